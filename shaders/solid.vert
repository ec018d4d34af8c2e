#version 330 core
// A solid out of a mesh, in axes of its own.
#include "lighting.glsl"
#include "shade.glsl"

layout(location = 0) in vec3 place;   // m, in its axes
layout(location = 1) in vec3 normal;  // out of it

uniform vec3 centre;                  // m
uniform vec3 axis_x, axis_y, axis_z;  // unit length
uniform vec3 own_colour;              // as displayed
uniform vec3 shade;                   // y: row where the vertices' texels begin; x: below 0 without

out vec3 point;
out vec3 outward;
out vec3 painted;

void main() {
  point = centre + axis_x * place.x + axis_y * place.y + axis_z * place.z;
  outward = axis_x * normal.x + axis_y * normal.y + axis_z * normal.z;
  painted = own_colour;
#ifdef CONTACT
  int width = textureSize(shade_map, 0).x;
  open = shade.x < 0.0 ? 1.0 : texelFetch(shade_map, ivec2(gl_VertexID % width, int(shade.y) + gl_VertexID / width), 0).r;
#endif
  gl_Position = view_projection * vec4(point, 1.0);
}
