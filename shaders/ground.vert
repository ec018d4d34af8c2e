#version 330 core
// A square of ground around the foot of the eye, as far as the fog lets one see.
#include "lighting.glsl"

uniform vec3 normal, along, across;  // unit vectors: off the ground, and the grid lines' directions
uniform vec3 foot_and_height;        // xy: where in the grid the foot of the eye is, z: how far below the eye (m)

out vec3 point;
out vec2 from_foot;  // m, along and across

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  from_foot = corner * (1.05 * fog.y);
  point = eye.xyz - normal * foot_and_height.z + along * from_foot.x + across * from_foot.y;
  gl_Position = view_projection * vec4(point, 1.0);
}
