// For fragments only: how light reaches places of a surface. The light is as wide as LIGHT_SPREAD says, so the farther
// off what throws a shadow is, the wider its edge.
#include "lighting.glsl"

#ifdef SHADOWS
uniform sampler2D blocker_map;  // blockers.frag

// Radii of the sharpest shadow's edge, in texels, and of the widest that eight taps are close enough together for, in
// widths of the map.
const float sharpest = 2.4, widest = 0.014;

/// The mean share of the light on a part of a surface; right and up: unit vectors along it, as seen in the map.
float light_on(vec3 at, vec3 right, vec3 up, vec2 least) {
  // What is in the light's way is so far off; as deep as the place itself is the surface that it is on.
  float away = max(at.z - textureLod(blocker_map, at.xy, 0.0).r, 0.0);
  float penumbra = away * (LIGHT_SPREAD / shadow.w);
  float radius = clamp(penumbra, sharpest * shadow.y, max(widest, sharpest * shadow.y));
  right *= max(radius, least.x);
  up *= max(radius, least.y);
  // Spread so that along and across an edge each is as far from the next.
  vec3 a = 0.10 * right + 0.51 * up, b = 0.10 * up - 0.51 * right;
  vec3 c = 0.78 * right + 0.30 * up, d = 0.78 * up - 0.30 * right;
  return 0.125 * (tap(at + a) + tap(at - a) + tap(at + b) + tap(at - b) + tap(at + c) + tap(at - c) + tap(at + d) +
                  tap(at - d));
}

const vec3 light_right = normalize(cross(vec3(0.0, 1.0, 0.0), to_light)), light_up = cross(to_light, light_right);

/// The share of the light that arrives on a surface with that normal.
float light_reaching_on(vec3 at, vec3 normal) {
  // Along the surface: else it would throw a shadow on itself where taps are far apart.
  vec2 slope = vec2(dot(normal, light_right), dot(normal, light_up)) * (shadow.w / max(dot(normal, to_light), 0.15));
  return light_on(at, vec3(1.0, 0.0, slope.x), vec3(0.0, 1.0, slope.y), vec2(0.0));
}

/// The mean share over a part of a surface: of the size of a fragment, or of the shadow's own softness where that is
/// larger, so that edges of shadows are smooth however many texels they cross at once.
float light_reaching_across(vec3 at) {
  vec3 right = dFdx(at), up = dFdy(at);
  vec2 size = max(vec2(length(right.xy), length(up.xy)), vec2(1e-9));
  return light_on(at, right / size.x, up / size.y, min(size, vec2(100.0 * shadow.y)));
}
#else
float light_reaching_on(vec3 at, vec3 normal) { return 1.0; }
float light_reaching_across(vec3 at) { return 1.0; }
#endif
