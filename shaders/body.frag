#version 330 core
// A smooth opaque surface.
#include "soft_shadow.glsl"

in vec3 point;
in vec3 outward;
in vec3 painted;

out vec4 pixel;

void main() {
  vec3 normal = normalize(outward);
  float reaching = light_reaching_on(place_in_map(point + normal * (2.2 * shadow.z)), normal);
  vec3 colour = lit(linear_from_display(painted), normal, normalize(-point), reaching, 0.12);
  pixel = vec4(display_from_linear(colour), 1.0);
}
