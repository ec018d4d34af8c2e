#version 330 core
in vec2 at;
flat in vec2 radii;
flat in float span;
flat in vec2 depths;

void main() {
  // Within either circle, or between both and below the line that touches them.
  float rise = clamp((radii.x - radii.y) / max(span, 1e-6), -1.0, 1.0);
  vec2 outwards = vec2(rise, sqrt(1.0 - rise * rise));
  vec2 here = vec2(at.x, abs(at.y));
  float along = here.x * outwards.y - here.y * outwards.x;
  bool between = along > 0.0 && along < span * outwards.y && dot(here, outwards) < radii.x;
  bool in_start = dot(here, here) < radii.x * radii.x;
  vec2 from_end = here - vec2(span, 0.0);
  if (!between && !in_start && dot(from_end, from_end) > radii.y * radii.y) discard;
  gl_FragDepth = mix(depths.x, depths.y, clamp(at.x / max(span, 1e-6), 0.0, 1.0));
}
