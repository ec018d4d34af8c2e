#version 330 core
// From the horizon's colour to the sky's.
#include "lighting.glsl"
#include "dither.glsl"

uniform vec3 right, down;  // half the picture's width and height one metre away, as vectors (m)

in vec2 at;

out vec4 pixel;

void main() {
  vec3 sight = normalize(forward.xyz + at.x * right + at.y * down);
  pixel = vec4(sky_colour(sight) + dither(), 1.0);
}
