#include "frame.glsl"

uniform sampler2DShadow shadow_map;

vec3 linear_from_display(vec3 colour) { return colour * colour; }

/// Softens highlights, then a square root in place of the sRGB curve: cheaper, and the eye can't tell.
vec3 display_from_linear(vec3 colour) { return sqrt(colour / (1.0 + 0.12 * colour)); }

/// The colour of the sky, or below the horizon of the mist, in a direction of unit length.
vec3 sky_colour(vec3 sight) { return mix(horizon.rgb, sky.rgb, smoothstep(0.0, 0.45, sight.y)); }

/// Mean of four comparisons with the shadow map, a quarter turn apart.
float four_taps(vec3 at, vec2 arm) {
  return 0.25 * (texture(shadow_map, at + vec3(arm, 0.0)) + texture(shadow_map, at - vec3(arm, 0.0)) +
                 texture(shadow_map, at + vec3(-arm.y, arm.x, 0.0)) +
                 texture(shadow_map, at + vec3(arm.y, -arm.x, 0.0)));
}

/// The share of the light that arrives at a point, 0 to 1.
float light_reaching(vec3 point) {
  if (shadow.x < 0.5) return 1.0;
  vec3 at = (shadow_matrix * vec4(point, 1.0)).xyz;
  if (any(greaterThan(abs(at.xy - 0.5), vec2(0.5)))) return 1.0;
  // Past the light's far plane there is nothing left that could throw a shadow.
  at.z = min(at.z, 1.0);
  float inner = four_taps(at, vec2(0.35, 0.9) * shadow.y);
  float outer = four_taps(at, vec2(1.9, 1.0) * shadow.y);
  // Where the eight agree, nearly everywhere, there is no edge to soften.
  float eight = 0.5 * (inner + outer);
  if (eight < 0.01 || eight > 0.99) return eight;
  return (4.0 * eight + 2.0 * four_taps(at, vec2(2.2, -1.6) * shadow.y) +
          four_taps(at, vec2(3.6, 0.9) * shadow.y) + four_taps(at, vec2(0.9, -3.6) * shadow.y)) / 8.0;
}

vec3 ambient_light(vec3 normal) {
  // A broad glow from the side opposite the light keeps the shape of what lies in shadow.
  float glow = 0.5 + 0.5 * dot(normal, vec3(-0.87, 0.10, 0.48));
  return mix(ambient_below.rgb, ambient_above.rgb, 0.5 + 0.5 * normal.y) * (0.72 + 0.60 * glow * glow);
}

/// Light that a surface sends to the eye: hemispheric ambient, one diffuse key light, a Blinn highlight.
vec3 lit(vec3 albedo, vec3 normal, vec3 to_eye, float reaching, float gloss) {
  float facing = max(dot(normal, to_light.xyz), 0.0);
  vec3 halfway = normalize(to_light.xyz + to_eye);
  float highlight = gloss * pow(max(dot(normal, halfway), 0.0), 48.0);
  return albedo * (ambient_light(normal) + light.rgb * (facing * reaching)) +
         light.rgb * (highlight * reaching * step(0.001, facing));
}
