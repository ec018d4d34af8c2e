#version 330 core
// A box: two triangles a face, six faces.
#include "lighting.glsl"

layout(location = 0) in vec3 centre;       // m
layout(location = 1) in vec3 edge_x;       // m, from the centre to the middle of a face
layout(location = 2) in vec3 edge_y;
layout(location = 3) in vec3 edge_z;
layout(location = 4) in vec4 colour;       // as displayed

out vec3 point;
out vec3 outward;
out vec3 painted;

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
  gl_Position = view_projection * vec4(point, 1.0);
}
