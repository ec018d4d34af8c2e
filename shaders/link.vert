#version 330 core
// A ribbon for each link, turned towards the eye.
#include "lighting.glsl"

layout(location = 0) in vec4 start;   // xyz: m, w: radius (m)
layout(location = 1) in vec3 end;     // m
layout(location = 2) in vec4 colour;  // as displayed; a: the share of its width that is not see-through

flat out vec3 albedo;
flat out float reaching;
flat out float fade;     // share of the drawn width that the link fills
out float offset;        // across the ribbon, −1 to 1
out vec3 across, front;  // the cylinder's directions towards the ribbon's edge and the eye
out vec3 to_eye;

void main() {
  float side = float(gl_VertexID & 1) * 2.0 - 1.0;
  float radius = start.w;
  vec3 axis = normalize(end - start.xyz);
  vec3 position = (gl_VertexID >> 1) == 0 ? start.xyz : end;
  to_eye = normalize(eye.xyz - position);
  front = to_eye - axis * dot(to_eye, axis);
  front = normalize(front + 1e-5 * abs(axis.zxy));
  across = cross(axis, front);

  // Thinner than a pixel a ribbon would break into dashes: it stays a pixel wide and grows faint instead.
  float least = 0.55 * view.x * max(dot(position - eye.xyz, forward.xyz), 0.0);
  float half_width = max(radius, least);
  fade = colour.a * radius / half_width;
  offset = side;

  albedo = linear_from_display(colour.rgb);
  reaching = light_reaching(place_in_map(0.5 * (start.xyz + end) + to_light * (radius + 2.0 * shadow.z)));
  // The ribbon lies in the plane of the cylinder's axis but has the depth of its front.
  gl_Position = view_projection * vec4(position + across * (side * half_width), 1.0);
  vec4 raised = view_projection * vec4(position + front * radius, 1.0);
  gl_Position.z = raised.z / raised.w * gl_Position.w;
}
