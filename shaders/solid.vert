#version 330 core
// The triangles of bones, boxes and other solids.
#include "lighting.glsl"

layout(location = 0) in vec3 position;  // m
layout(location = 1) in vec3 normal;    // unit vector, outwards
layout(location = 2) in vec4 colour;    // as displayed

out vec3 point;
out vec3 outward;
out vec3 painted;

void main() {
  point = position;
  outward = normal;
  painted = colour.rgb;
  gl_Position = view_projection * vec4(position, 1.0);
}
