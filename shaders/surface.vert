#version 330 core
// The triangles of sheets.
#include "lighting.glsl"

layout(location = 0) in vec3 position;  // m
layout(location = 1) in vec3 normal;    // unit vector, front side
layout(location = 2) in vec2 pattern_position;
layout(location = 3) in vec4 colour;    // as displayed; a: 1 where it replaces the cloth's own colour
layout(location = 4) in float hollow;   // −1 to 1: above 0 where the front side is hollow

out vec3 point;
out vec3 front_normal;
out vec2 weave;
out vec4 painted;
out float hollowness;

void main() {
  point = position;
  front_normal = normal;
  weave = pattern_position;
  painted = colour;
  hollowness = hollow;
  gl_Position = view_projection * vec4(position, 1.0);
}
