#version 330 core
// A solid out of a mesh, in axes of its own.
#include "lighting.glsl"

layout(location = 0) in vec3 place;   // m, in its axes
layout(location = 1) in vec3 normal;  // out of it

uniform vec3 centre;                  // m
uniform vec3 axis_x, axis_y, axis_z;  // unit length
uniform vec3 own_colour;              // as displayed

out vec3 point;
out vec3 outward;
out vec3 painted;

void main() {
  point = centre + axis_x * place.x + axis_y * place.y + axis_z * place.z;
  outward = axis_x * normal.x + axis_y * normal.y + axis_z * normal.z;
  painted = own_colour;
  gl_Position = view_projection * vec4(point, 1.0);
}
