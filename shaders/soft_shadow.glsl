// For fragments only: how light reaches places whose size in the shadow map matters.
#include "lighting.glsl"

#ifdef SHADOWS
/// The mean share over a part of a surface: of the size of a fragment, or of the map's own softness where that is
/// larger, so that edges of shadows are smooth however many texels they cross at once.
float light_reaching_across(vec3 at) {
  float least = 3.2 * shadow.y, most = 100.0 * shadow.y;
  vec3 right = dFdx(at), up = dFdy(at);
  float width = max(length(right.xy), 1e-9), height = max(length(up.xy), 1e-9);
  return eight_taps(at, right * (clamp(width, least, most) / width), up * (clamp(height, least, most) / height));
}
#else
float light_reaching_across(vec3 at) { return 1.0; }
#endif
