#version 330 core
// What is in the way between a plane and a light, or the sky: how much of each texel, and that times how far off it
// is, so that both can be averaged over any part. FADING: the farther off, the less it counts.
#include "frame.glsl"

// SPAN: texels of the depth map a texel of the mask, each way.
uniform sampler2D depths;
uniform vec3 plane;        // depth of the plane at a place of the map: x·u + y·v + z
uniform vec3 range;        // x: from the plane to what is a unit of depth off it (m), y: the farthest that counts (m)

out vec4 mask;

void main() {
  vec2 at = gl_FragCoord.xy / vec2(textureSize(depths, 0) / SPAN);
  float of_plane = dot(plane, vec3(at, 1.0));
  ivec2 corner = SPAN * ivec2(gl_FragCoord.xy);
  vec2 sum = vec2(0.0);
  // Every other texel, as on a board.
  for (int i = 0; i < SPAN * SPAN / 2; ++i) {
    int row = 2 * i / SPAN;
    float depth = texelFetch(depths, corner + ivec2(2 * i % SPAN + (row & 1), row), 0).r;
    float away = (depth - of_plane) * range.x / range.y;
    float counts = step(depth, 0.999999);
#ifdef FADING
    away = max(away, 0.0);
    float near = max(1.0 - away, 0.0);
    counts *= near * near;
#else
    counts *= step(0.0, away);
#endif
    sum += counts * vec2(1.0, min(away, 1.0));
  }
  mask = vec4(sum / float(SPAN * SPAN / 2), 0.0, 1.0);
}
