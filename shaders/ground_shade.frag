#version 330 core
// How much of the light (red) and of the sky (green) reaches a ground: the light is as wide as its penumbras say, so
// that shadows are sharp where what throws them touches the ground and soft where it is far off.
// CONTACT: what is near the ground hides the sky from it.
#include "lighting.glsl"

uniform sampler2D light_mask, sky_mask;  // ground_mask.frag
uniform vec3 light_reach;  // x: radius of the farthest thing's penumbra (texels), y: of the sharpest
uniform vec3 sky_reach;    // xy: radii that what hides the sky is averaged within (texels)
uniform vec3 sky_place;    // xy: where in its mask the foot of the eye is, z: a metre

in vec3 point;
in vec2 from_foot;

out vec4 shade;

/// Radius (texels) within which what covers a place is to be averaged: as wide as it is far off, on the mean, first of
/// all that may count, then of what so wide a part still holds.
float radius_at(sampler2D mask, vec2 at, vec3 reach) {
  float radius = reach.x;
  for (int i = 0; i < 2; ++i) {
    vec2 found = textureLod(mask, at, ceil(log2(max(2.0 * radius, 1.0)))).rg;
    radius = max(reach.x * found.y / max(found.x, 1e-4), reach.y);
  }
  return radius;
}

/// The mean of a mask within a radius (texels) of a place.
float mean_around(sampler2D mask, vec2 at, float radius) {
  vec2 size = vec2(textureSize(mask, 0));
  // A fragment may be larger than that, far off or along the ground.
  vec2 across = dFdx(at) * size, along = dFdy(at) * size;
  float longest = max(length(along), 1e-6);
  vec2 up = along / longest, right = vec2(-up.y, up.x);
  float width = max(radius, 0.6 * abs(dot(across, right))), height = max(radius, 0.6 * longest);
  // Four taps. A tap is itself as wide as texels of its level, 0.5 to 0.95 of the whole; the rest of the variance
  // comes from how far apart they are, so that it is the same in any level.
  float middle = sqrt(width * height);
  float level = floor(log2(max(0.95 * middle, 1.0))), texel = exp2(level) / middle;
  float apart = sqrt(max(0.5 * (1.0 - texel * texel), 0.05));
  right *= width * apart / size.x;
  up *= height * apart / size.y;
  vec2 a = 0.36 * right + 0.93 * up, b = 0.93 * right - 0.36 * up;
  return 0.25 * (textureLod(mask, at + a, level).r + textureLod(mask, at - a, level).r +
                 textureLod(mask, at + b, level).r + textureLod(mask, at - b, level).r);
}

void main() {
  vec2 in_light = place_in_map(point).xy;
  float light = 1.0 - mean_around(light_mask, in_light, radius_at(light_mask, in_light, light_reach));
#ifdef CONTACT
  // What touches the ground hides it from half of the sky beside it, and beyond that about as far as it is high.
  vec2 in_sky = sky_place.xy + sky_place.z * from_foot;
  float sky = 1.0 - 0.5 * (mean_around(sky_mask, in_sky, sky_reach.y) + mean_around(sky_mask, in_sky, sky_reach.x));
#else
  const float sky = 1.0;
#endif
  shade = vec4(light, sky, 0.0, 1.0);
}
