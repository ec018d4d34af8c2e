#version 330 core
// A box: two triangles a face, six faces.
#include "lighting.glsl"

layout(location = 0) in vec3 centre;       // m
layout(location = 1) in vec3 edge_x;       // m, from the centre to the middle of a face
layout(location = 2) in vec3 edge_y;
layout(location = 3) in vec3 edge_z;
layout(location = 4) in vec4 colour;       // as displayed
layout(location = 5) in vec3 shade;        // xy: where its tile is; z: cells of that a face, each way

out vec3 point;
out vec3 outward;
out vec3 painted;
#ifdef CONTACT
out vec2 in_tile;
#endif

void main() {
  int face = gl_VertexID / 6, corner = gl_VertexID % 6;
  // 0 1 2 and 2 1 3, which turn the other way on the other side.
  int place = corner < 3 ? corner : (corner == 3 ? 2 : corner == 4 ? 1 : 3);
  float side = (face & 1) == 0 ? 1.0 : -1.0;
  vec2 at = vec2(place & 1, place >> 1) * 2.0 - 1.0;
  vec3 out_of = face < 2 ? edge_x : face < 4 ? edge_y : edge_z;
  vec3 along = face < 2 ? edge_y : face < 4 ? edge_z : edge_x;
  vec3 across = face < 2 ? edge_z : face < 4 ? edge_x : edge_y;
  outward = normalize(out_of) * side;
  point = centre + out_of * side + along * (at.x * side) + across * at.y;
  painted = colour.rgb;
#ifdef CONTACT
  // Three faces beside each other, the opposite ones below.
  vec2 square = vec2(face >> 1, face & 1) * (shade.z + 1.0);
  in_tile = shade.z > 0.0 ? shade.xy + square + (0.5 + 0.5 * at) * shade.z + 0.5 : vec2(0.5);
#endif
  gl_Position = view_projection * vec4(point, 1.0);
}
