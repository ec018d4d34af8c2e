#version 330 core
// A ribbon lit as the cylinder that it stands for.
#include "lighting.glsl"

flat in vec3 albedo;
flat in float reaching;
flat in float fade;
in float offset;
in vec3 across, front;
in vec3 to_eye;

out vec4 pixel;

void main() {
  float height = sqrt(max(1.0 - offset * offset, 0.0));
  vec3 normal = normalize(across * offset + front * height);
  vec3 colour = lit(albedo, normal, normalize(to_eye), reaching, 0.15);
#ifdef MULTISAMPLED
  pixel = vec4(display_from_linear(colour), fade);
#else
  pixel = vec4(display_from_linear(colour), 1.0);
#endif
}
