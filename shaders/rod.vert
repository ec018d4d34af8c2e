#version 330 core
// A rod with round ends, or a ball: each half of a unit ball moved to its end.
#include "lighting.glsl"

layout(location = 0) in vec4 unit;   // xyz: on the ball, its axis along z; w: 0 at the start, 1 at the end
layout(location = 1) in vec4 start;  // xyz: m, w: radius (m)
layout(location = 2) in vec3 end;    // m
layout(location = 3) in vec4 colour; // as displayed

out vec3 point;
out vec3 outward;
flat out vec3 painted;

void main() {
  vec3 span = end - start.xyz;
  vec3 axis = dot(span, span) > 0.0 ? normalize(span) : vec3(0, 1, 0);
  vec3 right = normalize(cross(axis, abs(axis.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0)));
  outward = right * unit.x + cross(axis, right) * unit.y + axis * unit.z;
  point = mix(start.xyz, end, unit.w) + start.w * outward;
  painted = colour.rgb;
  gl_Position = view_projection * vec4(point, 1.0);
}
