#version 330 core
// The sphere's surface where the line of sight meets it, with its true depth and a smooth edge.
#include "lighting.glsl"

flat in vec4 centre_and_radius;
flat in vec3 albedo;
flat in float reaching;
flat in float softness;
in vec3 point;
in vec2 disc;

out vec4 pixel;

void main() {
  float coverage = clamp((1.0 - length(disc)) / softness + 0.5, 0.0, 1.0);
#ifdef MULTISAMPLED
  if (coverage <= 0.0) discard;
#else
  if (coverage <= 0.5) discard;
#endif

  vec3 sight = normalize(point);
  vec3 to_centre = centre_and_radius.xyz;
  float radius = centre_and_radius.w;
  float along = dot(sight, to_centre);
  float depth_inside = sqrt(max(radius * radius - dot(to_centre, to_centre) + along * along, 0.0));
  vec3 hit = sight * (along - depth_inside);
  vec3 normal = normalize(hit - centre_and_radius.xyz);

  vec4 clip = view_projection * vec4(hit, 1.0);
  gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;
  pixel = vec4(display_from_linear(lit(albedo, normal, -sight, reaching, 0.25)), coverage);
}
