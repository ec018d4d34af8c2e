#version 330 core
// The hull of two balls, each half of a unit ball moved to its end. The halves meet at the latitude where the
// cone between the balls touches them, so that the surface is smooth across their seam. A squeeze makes both
// balls flat: then it is the unsqueezed hull that is built, and squeezed.
#include "lighting.glsl"
#include "shade.glsl"

layout(location = 0) in vec4 unit;    // xy: unit vector around the axis; z: 0 at the seam's side or −1 and 1 at the tips; w: 0 at the start, 1 at the end, ½ between
layout(location = 1) in vec4 start;   // xyz: m, w: radius (m)
layout(location = 2) in vec4 end;     // as start
layout(location = 3) in vec3 squeeze; // what is at p is drawn at p − squeeze (squeeze · p)
layout(location = 4) in vec4 start_colour; // as displayed
layout(location = 5) in vec4 end_colour;
layout(location = 6) in vec2 shade;   // where its tile is

uniform vec3 grid;  // x: sides of its ball

out vec3 point;
out vec3 outward;
out vec3 painted;

vec3 unsqueezed(vec3 v) { return v + squeeze * (dot(squeeze, v) / (1.0 - dot(squeeze, squeeze))); }

void main() {
  vec3 span = unsqueezed(end.xyz - start.xyz);
  float span_length = length(span);
  vec3 axis = span_length > 0.0 ? span / span_length : vec3(0, 1, 0);
  vec3 right = normalize(cross(axis, abs(axis.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0)));
  float seam = asin(clamp((start.w - end.w) / max(span_length, 1e-12), -1.0, 1.0));
  float latitude = mix(seam, sign(unit.z) * 1.57079633, abs(unit.z));
  vec3 normal = cos(latitude) * (right * unit.x + cross(axis, right) * unit.y) + sin(latitude) * axis;
  vec3 from_centre = mix(start.w, end.w, unit.w) * normal;
  outward = normalize(unsqueezed(normal));
  point = mix(start.xyz, end.xyz, unit.w) + from_centre - squeeze * dot(squeeze, from_centre);
  painted = mix(start_colour.rgb, end_colour.rgb, unit.w);
#ifdef CONTACT
  float row = unit.z < 0.0 ? 2.0 + 2.0 * unit.z : unit.z > 0.0 ? 4.0 + 2.0 * unit.z : 2.0 + 2.0 * unit.w;
  float around = fract((float(gl_VertexID) + 0.25) / grid.x) - 0.25 / grid.x;
  open = openness(shade, vec2(ROD_TILE.x * around, row));
#endif
  gl_Position = view_projection * vec4(point, 1.0);
}
