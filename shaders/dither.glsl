// For fragments only.
/// A pixel's own small share of a step of an eight-bit display, −1 to 1, so that smooth gradients show no bands.
vec3 dither() {
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  return vec3((2.0 * noise - 1.0) / 255.0);
}
