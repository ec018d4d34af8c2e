#version 330 core
// What a shadow map holds around each place: depths, and their squares, of what is there. The nearer to the light, the
// more it counts, since what lies deeper than a place throws no shadow on it.

// SPAN: texels of the depth map a texel of this one, each way. NEARER: the exponent.
uniform sampler2D depths;

out vec4 blockers;

void main() {
  ivec2 corner = SPAN * ivec2(gl_FragCoord.xy) - SPAN / 2, last = textureSize(depths, 0) - 1;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 16; ++i) {
    // A fourth of twice the span from each to the next, rows shifted against each other.
    ivec2 at = corner + ivec2((i & 3) * (SPAN / 2) + (i >> 2), (i >> 2) * (SPAN / 2) + 3 - (i & 3));
    float depth = texelFetch(depths, clamp(at, ivec2(0), last), 0).r;
    sum += step(depth, 0.999999) * exp(-NEARER * depth) * vec3(1.0, depth, depth * depth);
  }
  blockers = vec4(sum / 16.0, 1.0);
}
