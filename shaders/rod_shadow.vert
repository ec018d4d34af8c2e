#version 330 core
// A rod with round ends as the light sees it: one flat shape through its axis, a fiftieth of the triangles.
#include "frame.glsl"

layout(location = 1) in vec4 start;  // xyz: m, w: radius (m)
layout(location = 2) in vec3 end;    // m

out vec2 at;  // m, along the axis from its start, and across
flat out float radius, span;

void main() {
  radius = start.w;
  vec3 axis = end - start.xyz;
  axis -= to_light * dot(axis, to_light);
  span = length(axis);
  vec3 along = span > 1e-6 ? axis / span : normalize(cross(to_light, vec3(0, 0, 1)));
  vec3 across = cross(to_light, along);
  bool last = (gl_VertexID >> 1) != 0;
  float side = (gl_VertexID & 1) != 0 ? radius : -radius;
  vec3 corner = (last ? end + along * radius : start.xyz - along * radius) + across * side;
  at = vec2(last ? span + radius : -radius, side);
  gl_Position = view_projection * vec4(corner, 1.0);
}
