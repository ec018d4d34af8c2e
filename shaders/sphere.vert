#version 330 core
// A quad for each sphere, in the plane of the circle that the sphere shows to the eye.
#include "lighting.glsl"

layout(location = 0) in vec4 sphere;  // xyz: centre, w: radius (m)
layout(location = 1) in vec4 colour;

flat out vec4 centre_and_radius;
flat out vec3 albedo;
flat out float reaching;
flat out float softness;  // width of a pixel, in radii of the circle
out vec3 point;
out vec2 disc;            // inside the circle where its length is below 1

void main() {
  vec3 centre = sphere.xyz;
  float radius = sphere.w;
  vec3 axis = centre - eye.xyz;
  float distance_to_eye = max(length(axis), 1.001 * radius);
  axis /= distance_to_eye;
  vec3 middle = centre - axis * (radius * radius / distance_to_eye);
  float rim = radius * sqrt(1.0 - radius * radius / (distance_to_eye * distance_to_eye));
  softness = view.x * max(dot(centre - eye.xyz, forward.xyz), 0.0) / rim;

  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  disc = corner * (1.0 + softness);
  vec3 right = normalize(cross(axis, abs(axis.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0)));
  vec3 up = cross(right, axis);
  point = middle + rim * (disc.x * right + disc.y * up);

  centre_and_radius = sphere;
  albedo = linear_from_display(colour.rgb);
  reaching = light_reaching(place_in_map(centre + to_light * (radius + 2.0 * shadow.z)));
  gl_Position = view_projection * vec4(point, 1.0);
}
