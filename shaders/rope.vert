#version 330 core
// A ribbon for each piece of a rope, turned towards the eye at either end, so that neighbours meet in a line.
#include "lighting.glsl"

layout(location = 0) in vec4 start;          // xyz: m, w: radius (m)
layout(location = 1) in vec4 end;            // the same
layout(location = 2) in vec3 start_tangent;  // unit vectors
layout(location = 3) in vec3 end_tangent;
layout(location = 4) in vec2 phases;         // rad, of the strands where the rope faces the eye
layout(location = 5) in vec4 start_colour;   // as displayed
layout(location = 6) in vec4 end_colour;

flat out float reaching;
flat out float fade;        // share of the drawn width that the rope fills
flat out float stranded;    // how much of its strands is seen, 0 to 1
out vec3 albedo;
out float offset;           // across the ribbon, −1 to 1
out float phase;            // rad
out vec3 across, front, along;
out vec3 to_eye;

void main() {
  float side = float(gl_VertexID & 1) * 2.0 - 1.0;
  bool first = (gl_VertexID >> 1) == 0;
  vec3 position = first ? start.xyz : end.xyz;
  float radius = first ? start.w : end.w;
  along = first ? start_tangent : end_tangent;
  phase = first ? phases.x : phases.y;
  to_eye = normalize(eye.xyz - position);
  front = to_eye - along * dot(to_eye, along);
  front = normalize(front + 1e-5 * abs(along.zxy));
  across = cross(along, front);

  // Thinner than a pixel a ribbon would break into dashes: it stays a pixel wide and grows faint instead.
  float pixel = view.x * max(dot(position - eye.xyz, forward.xyz), 0.0);
  float half_width = max(radius, 0.55 * pixel);
  fade = radius / half_width;
  offset = side;
  // Strands that a few pixels can't show would only flicker.
  stranded = smoothstep(1.4, 3.2, radius / max(pixel, 1e-9));

  albedo = linear_from_display(first ? start_colour.rgb : end_colour.rgb);
  reaching = light_reaching(place_in_map(0.5 * (start.xyz + end.xyz) + to_light * (radius + 2.0 * shadow.z)));
  gl_Position = view_projection * vec4(position + across * (side * half_width), 1.0);
  // The ribbon lies in the plane of the rope's axis but has the depth of its front.
  vec4 raised = view_projection * vec4(position + front * radius, 1.0);
  gl_Position.z = raised.z / raised.w * gl_Position.w;
}
