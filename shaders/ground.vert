#version 330 core
// A square of ground around the eye, as far as the fog lets one see.
#include "lighting.glsl"

out vec3 point;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  vec2 at = eye.xz + corner * (1.05 * fog.y);
  point = vec3(at.x, fog.w, at.y);
  gl_Position = view_projection * vec4(point, 1.0);
}
