#include "frame.glsl"

uniform sampler2DShadow shadow_map;

// What isn't wanted is left out when a shader is compiled: drawn by the processor, an `if` saves nothing.
// SHADOWS: there is a shadow map. MULTISAMPLED: alpha says which share of a pixel is covered.

vec3 linear_from_display(vec3 colour) { return colour * colour; }

/// Softens highlights, then a square root in place of the sRGB curve: cheaper, and the eye can't tell.
vec3 display_from_linear(vec3 colour) { return sqrt(colour / (1.0 + 0.12 * colour)); }

/// The colour of the sky, or below the horizon of the mist, in a direction of unit length.
vec3 sky_colour(vec3 sight) { return mix(horizon, sky, smoothstep(0.0, 0.45, sight.y)); }

/// A place in the shadow map, and the depth that the light must reach there.
vec3 place_in_map(vec3 point) { return (shadow_matrix * vec4(point, 1.0)).xyz; }

#ifdef SHADOWS
float tap(vec3 at) {
  // Past the light's far plane there is nothing left that could throw a shadow.
  at.z = min(at.z, 1.0);
  return texture(shadow_map, at);
}

/// Mean of four comparisons with the shadow map, a quarter turn apart in the plane of two directions.
float four_taps(vec3 at, vec3 right, vec3 up, vec2 arm) {
  vec3 one = arm.x * right + arm.y * up, other = arm.x * up - arm.y * right;
  return 0.25 * (tap(at + one) + tap(at - one) + tap(at + other) + tap(at - other));
}

float eight_taps(vec3 at, vec3 right, vec3 up) {
  return 0.5 * (four_taps(at, right, up, vec2(0.11, 0.28)) + four_taps(at, right, up, vec2(0.59, 0.31)));
}

/// The share of the light that arrives at a place in the shadow map, 0 to 1.
float light_reaching(vec3 at) {
  float width = 3.2 * shadow.y;
  return eight_taps(at, vec3(width, 0.0, 0.0), vec3(0.0, width, 0.0));
}
#else
float light_reaching(vec3 at) { return 1.0; }
#endif

vec3 ambient_light(vec3 normal) {
  // A broad glow from the side opposite the light keeps the shape of what lies in shadow.
  float glow = 0.5 + 0.5 * dot(normal, vec3(-0.87, 0.10, 0.48));
  return mix(ambient_below, ambient_above, 0.5 + 0.5 * normal.y) * (0.72 + 0.60 * glow * glow);
}

/// Light that a surface sends to the eye: hemispheric ambient, one diffuse key light, a Blinn highlight.
vec3 lit(vec3 albedo, vec3 normal, vec3 to_eye, float reaching, float gloss) {
  float facing = max(dot(normal, to_light), 0.0);
  vec3 halfway = normalize(to_light + to_eye);
  float highlight = gloss * pow(max(dot(normal, halfway), 0.0), 48.0);
  return albedo * (ambient_light(normal) + light * (facing * reaching)) +
         light * (highlight * reaching * step(0.001, facing));
}
