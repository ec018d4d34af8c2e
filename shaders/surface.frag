#version 330 core
// Cloth: two sides, a pattern, a hem, folds that darken where they hide the sky, a little light through the weave.
#include "lighting.glsl"

// FRONT_COLOUR, BACK_COLOUR: as displayed. PATTERN: 1 checker, 2 woven; without it the cloth is plain. PAINTED:
// masses are coloured by what they do. TINTED: each sheet has colours of its own.

in vec3 to_eye;
in vec3 front_normal;
in vec2 openness;  // how bright light from all around makes front and back
in vec3 from_edges;  // xy: from upright and level borders, in hems; z: 0 at a tear, 1 away from it
#ifdef SHADOWS
in vec2 in_light_map;

uniform sampler2D light_map;  // the share of the light that reaches places of the cloth
#endif
#ifdef PATTERN
in vec2 weave;
#endif
#ifdef PAINTED
in vec3 painted;
#endif
#ifdef TINTED
flat in vec3 front_colour, back_colour;
#else
const vec3 front_colour = FRONT_COLOUR, back_colour = BACK_COLOUR;
#endif

out vec4 pixel;

#ifdef PATTERN
/// A square wave of period 2 between −1 and 1, averaged over `width`: the difference of its integral.
vec2 averaged_square_wave(vec2 at, vec2 width) {
  vec2 low = at - 0.5 * width, high = at + 0.5 * width;
  return (abs(fract(0.5 * high) - 0.5) - abs(fract(0.5 * low) - 0.5)) * -2.0 / width;
}

/// Brightness of the pattern, about 1.
float pattern_shade() {
  vec2 width = max(fwidth(weave), vec2(1e-4));
  vec2 wave = averaged_square_wave(weave, width);
#if PATTERN == 1
  return 1.0 + 0.34 * wave.x * wave.y;
#else
  // Threads pass over and under each other; each is round, so darker towards its edges. Below two pixels a thread
  // nothing is left of them but their mean.
  vec2 fade = clamp(1.6 - 2.4 * width, 0.0, 1.0);
  vec2 thread = abs(fract(weave) - 0.5) * 2.0;
  float warp_on_top = 0.5 + 0.5 * wave.x * wave.y;
  float roundness = mix(1.0 - 0.45 * thread.x * thread.x, 1.0 - 0.45 * thread.y * thread.y, warp_on_top);
  return mix(1.0, (0.88 + 0.24 * warp_on_top) * roundness / 0.85, fade.x * fade.y);
#endif
}
#endif

#ifndef PAINTED
/// Brightness along borders and tears, about 1: a hem is cloth turned over and sewn down, so twice as thick, with a
/// seam; at its outer edge and along tears the ends of threads catch the light.
float edge_shade() {
  float inwards = min(from_edges.x, from_edges.y);
  float pixel_width = fwidth(inwards) + 1e-4;
  float seen = clamp(1.4 - 2.8 * pixel_width, 0.0, 1.0);  // as wide as a pixel or two, or not at all
  float hem = clamp((1.0 - inwards) / pixel_width + 0.5, 0.0, 1.0);
  float seam = clamp(1.0 - abs(inwards - 0.86) / max(0.09, 0.7 * pixel_width), 0.0, 1.0);
  float rim = clamp(1.0 - inwards / max(0.14, pixel_width), 0.0, 1.0);
  float frayed = clamp(1.0 - 3.0 * from_edges.z, 0.0, 1.0);
  return 1.0 + seen * (0.30 * rim - 0.14 * hem - 0.38 * seam) + 0.5 * frayed * frayed;
}
#endif

void main() {
  float side = gl_FrontFacing ? 1.0 : -1.0;
  vec3 normal = normalize(front_normal) * side;

#ifdef PAINTED
  // As much shade as folds need to be seen, and no more: what counts are the colours of the legend.
  float shape = 0.5 + 0.5 * dot(normal, normalize(0.6 * to_light + normalize(to_eye)));
  float shade = 0.80 + 0.24 * shape;
#ifdef SHADOWS
  shade -= 0.10 * (1.0 - texture(light_map, in_light_map).r);
#endif
  pixel = vec4(painted * shade, 1.0);
#else
  vec3 albedo = linear_from_display(gl_FrontFacing ? front_colour : back_colour) * edge_shade();
#ifdef PATTERN
  albedo *= pattern_shade();
#endif
  float facing = dot(normal, to_light);
  // Folds light each other, so what lies in their shadow isn't quite dark.
#ifdef SHADOWS
  float reaching = 0.12 + 0.88 * texture(light_map, in_light_map).r;
#else
  const float reaching = 1.0;
#endif
  float open = gl_FrontFacing ? openness.x : openness.y;

  float diffuse = max((facing + 0.15) / 1.15, 0.0) * reaching;
  float through = 0.16 * max(-facing, 0.0);
  // Fibres that stand off the cloth catch the light where one looks along it.
  float edge_on = 1.0 - max(dot(normal, normalize(to_eye)), 0.0);
  float sheen = edge_on * edge_on * edge_on;
  vec3 colour = albedo * (ambient_light(normal) * open + light * (diffuse * mix(1.0, open, 0.7) + through));
  colour += (0.28 * albedo + 0.025) * (sheen * open) * (ambient_above + 0.8 * light * diffuse);
  pixel = vec4(display_from_linear(colour), 1.0);
#endif
}
