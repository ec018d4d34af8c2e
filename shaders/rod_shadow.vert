#version 330 core
// The hull of two balls as the light sees it: one flat shape with the depth of its axis, a fiftieth of the triangles.
// Squeezed balls are looked at from where the light would come before they were squeezed.
#include "frame.glsl"

layout(location = 1) in vec4 start;   // xyz: m, w: radius (m)
layout(location = 2) in vec4 end;     // as start
layout(location = 3) in vec3 squeeze; // as in rod.vert

out vec2 at;  // m, along the axis from its start, and across
flat out vec2 radii;
flat out float span;
flat out vec2 depths;  // of the start's and the end's middle

vec3 unsqueezed(vec3 v) { return v + squeeze * (dot(squeeze, v) / (1.0 - dot(squeeze, squeeze))); }

void main() {
  radii = vec2(start.w, end.w);
  vec3 light_from = normalize(unsqueezed(to_light));
  vec3 axis = unsqueezed(end.xyz - start.xyz);
  vec3 seen = axis - light_from * dot(axis, light_from);
  span = length(seen);
  vec3 along = span > 1e-6 ? seen / span : normalize(cross(light_from, vec3(0, 0, 1)));
  vec3 across = cross(light_from, along);
  bool last = (gl_VertexID >> 1) != 0;
  float widest = max(start.w, end.w);
  float side = (gl_VertexID & 1) != 0 ? widest : -widest;
  // The wider ball may reach past the other.
  float low = min(-start.w, span - end.w), high = max(start.w, span + end.w);
  at = vec2(last ? high : low, side);
  vec3 from_start = (last ? axis + along * (high - span) : along * low) + across * side;
  vec3 corner = start.xyz + from_start - squeeze * dot(squeeze, from_start);
  gl_Position = view_projection * vec4(corner, 1.0);
  depths = vec2((view_projection * vec4(start.xyz, 1.0)).z, (view_projection * vec4(end.xyz, 1.0)).z) * 0.5 + 0.5;
}
