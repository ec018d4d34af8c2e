#version 330 core
// A smooth opaque surface. CONTACT: what is near keeps light from all around from it; FACES: that is looked up for every
// fragment, since there are few vertices.
#include "soft_shadow.glsl"

in vec3 point;
in vec3 outward;
in vec3 painted;
#ifdef CONTACT
#ifdef FACES
uniform sampler2D shade_map;

in vec2 in_tile;
#else
in float open;
#endif
#endif

out vec4 pixel;

void main() {
  vec3 normal = normalize(outward);
  float reaching = light_reaching_on(place_in_map(point + normal * (2.2 * shadow.z)), normal);
  vec3 albedo = linear_from_display(painted);
  vec3 colour = lit(albedo, normal, normalize(-point), reaching, 0.12);
#ifdef CONTACT
#ifdef FACES
  float open = texture(shade_map, in_tile / vec2(textureSize(shade_map, 0))).r;
#endif
  // Light that things send each other, too, is less there.
  colour *= mix(1.0, open, 0.35);
  colour -= albedo * ambient_light(normal) * (0.65 * (1.0 - open));
#endif
  pixel = vec4(display_from_linear(colour), 1.0);
}
