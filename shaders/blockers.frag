#version 330 core
// How deep in a shadow map what is about each place lies, on the mean. The nearer to the light, the more it counts, since
// what lies deeper than a place throws no shadow on it; where there is nothing it is the far end.

// SPAN: texels of the depth map a texel of this one, each way. NEARER: the exponent.
uniform sampler2D depths;

out vec4 depth_about;

void main() {
  // Three times as far as a texel, each way, so that no step shows between it and the next.
  ivec2 corner = SPAN * (ivec2(gl_FragCoord.xy) - 1), last = textureSize(depths, 0) - 1;
  float sum = 0.0;
  for (int i = 0; i < 16; ++i) {
    // Rows are shifted against each other.
    ivec2 at = corner + ivec2(i & 3, i >> 2) * (3 * SPAN / 4) + ivec2(i >> 2, 3 - (i & 3));
    float depth = texelFetch(depths, clamp(at, ivec2(0), last), 0).r;
    sum += step(depth, 0.999999) * exp(-NEARER * depth);
  }
  depth_about = vec4(sum > 0.0 ? min(log(sum / 16.0) / -NEARER, 1.0) : 1.0);
}
