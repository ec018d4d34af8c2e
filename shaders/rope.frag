#version 330 core
// A ribbon lit as the rope of three strands that it stands for.
#include "lighting.glsl"

flat in float reaching;
flat in float fade;
flat in float stranded;
in vec3 albedo;
in float offset;
in float phase;
in vec3 across, front, along;
in vec3 to_eye;

out vec4 pixel;

const float strands = 3.0;  // as in rope.cpp
const float steepness = 0.739;  // of the strands' way about the rope: 2 pi over the lay in radii

void main() {
  float height = sqrt(max(1.0 - offset * offset, 0.0));
  vec3 normal = across * offset + front * height;
  // Each strand is round: its height over the rope is |cos| of half the angle within it, which tilts the
  // normal away from its middle, across its way.
  float within = 0.5 * (phase + strands * asin(clamp(offset, -1.0, 1.0)));
  float top = abs(cos(within));
  float slope = -sin(within) * sign(cos(within));
  vec3 away = (across * height - front * offset) - along * steepness;
  normal = normalize(normal - away * (0.75 * stranded * slope * height));
  float groove = mix(1.0, smoothstep(-0.25, 0.75, top), 0.8 * stranded);
  vec3 colour = lit(albedo * groove, normal, normalize(to_eye), reaching, 0.06);
#ifdef MULTISAMPLED
  pixel = vec4(display_from_linear(colour), fade);
#else
  pixel = vec4(display_from_linear(colour), 1.0);
#endif
}
