#version 330 core
// A ring of a chain: two half circles and what is straight between them.
#include "lighting.glsl"

layout(location = 0) in vec4 unit;    // x, y: cosine (below 0 at the start) and sine of the angle about the half
                                      // circle's middle; z, w: cosine and sine of the angle around the wire
layout(location = 1) in vec4 start;   // xyz: m, where the ring bears on the one before; w: radius of the wire (m)
layout(location = 2) in vec4 end;     // xyz: m; w: radius of the half circles, to the middle of the wire (m)
layout(location = 3) in vec3 side;    // unit vector in the ring's plane
layout(location = 4) in vec4 colour;  // as displayed

out vec3 outward;
out vec3 to_eye;
out float reaching;
flat out vec3 albedo;

void main() {
  float wire = start.w, bend = end.w;
  vec3 span = end.xyz - start.xyz;
  float pitch = length(span);
  vec3 axis = pitch > 0.0 ? span / pitch : cross(side, vec3(0.0, 0.0, 1.0));
  vec3 radial = axis * unit.x + side * unit.y;
  // The wire lies beyond the place where it bears on the next one's.
  float straight = max(0.5 * pitch + wire - bend, 0.0);
  vec3 middle = 0.5 * (start.xyz + end.xyz) + axis * (sign(unit.x) * straight) + bend * radial;
  outward = radial * unit.z + cross(axis, side) * unit.w;
  vec3 point = middle + wire * outward;
  to_eye = eye.xyz - point;
  albedo = linear_from_display(colour.rgb);
  reaching = light_reaching(place_in_map(point + outward * (1.5 * shadow.z) + to_light * (2.0 * shadow.z)));
  gl_Position = view_projection * vec4(point, 1.0);
}
