#version 330 core
// A trunk in axes of its own.
#include "lighting.glsl"
#include "shade.glsl"

layout(location = 0) in vec3 place;   // in those axes
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 origin;  // m
layout(location = 3) in vec3 axis_x;  // m
layout(location = 4) in vec3 axis_y;
layout(location = 5) in vec3 axis_z;
layout(location = 6) in vec4 colour;  // as displayed
layout(location = 7) in vec2 shade;   // where its tile is

uniform vec3 grid;  // x: sides of the skin, y: bands

out vec3 point;
out vec3 outward;
out vec3 painted;

void main() {
  point = origin + axis_x * place.x + axis_y * place.y + axis_z * place.z;
  // What keeps across the skin however the axes stretch it.
  outward = normalize(cross(axis_y, axis_z) * normal.x + cross(axis_z, axis_x) * normal.y + cross(axis_x, axis_y) * normal.z);
  painted = colour.rgb;
#ifdef CONTACT
  float ring = floor((float(gl_VertexID) + 0.25) / grid.x);
  open = openness(shade, TORSO_TILE * vec2(float(gl_VertexID) - ring * grid.x, ring) / grid.xy);
#endif
  gl_Position = view_projection * vec4(point, 1.0);
}
