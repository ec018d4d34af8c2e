#version 330 core
// Polished wire, in which the sky is seen.
#include "lighting.glsl"

in vec3 outward;
in vec3 to_eye;
in float reaching;
flat in vec3 albedo;

out vec4 pixel;

void main() {
  vec3 normal = normalize(outward), sight = normalize(to_eye);
  vec3 mirrored = reflect(-sight, normal);
  float grazing = 1.0 - max(dot(normal, sight), 0.0);
  vec3 around = linear_from_display(mix(ambient_below, sky, smoothstep(-0.35, 0.5, mirrored.y)));
  vec3 colour = lit(albedo, normal, sight, reaching, 0.7) +
                around * mix(albedo, vec3(1.0), 0.15) * (0.22 + 0.4 * grazing * grazing * grazing);
  pixel = vec4(display_from_linear(colour), 1.0);
}
