// For fragments only.
/// What is added to a colour before it is rounded to the STEPS of a channel, 255 on most displays, so that a smooth
/// gradient shows no bands: Bayer's pattern of 4 × 4 pixels, which PNG and films keep well where noise would swell
/// them.
vec3 dither() {
  const float[16] pattern =
      float[16](0.0, 8.0, 2.0, 10.0, 12.0, 4.0, 14.0, 6.0, 3.0, 11.0, 1.0, 9.0, 15.0, 7.0, 13.0, 5.0);
  ivec2 at = ivec2(gl_FragCoord.xy) & 3;
  return vec3((pattern[4 * at.y + at.x] - 7.5) / (16.0 * STEPS));
}
