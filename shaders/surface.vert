#version 330 core
// The triangles of sheets.
#include "lighting.glsl"

layout(location = 0) in vec3 position;  // m
layout(location = 1) in vec3 normal;    // unit vector, front side
layout(location = 2) in vec2 open;      // how bright light from all around makes front and back
layout(location = 3) in vec2 pattern_position;
layout(location = 4) in vec3 edge_distances;  // xy: from upright and level borders, in hems; z: 0 at a tear, else 1
layout(location = 5) in vec2 light_position;  // in cells of the light map
layout(location = 6) in vec4 colour;          // as displayed, in place of the cloth's own
layout(location = 7) in vec4 front_tint;      // as displayed, the sheet's own colours
layout(location = 8) in vec4 back_tint;

uniform vec3 texels_a_cell, light_texel;  // xy: texels of the light map a cell; a texel in its coordinates

out vec3 to_eye;
out vec3 front_normal;
out vec2 openness;
out vec3 from_edges;
#ifdef SHADOWS
out vec2 in_light_map;
#endif
#ifdef PATTERN
out vec2 weave;
#endif
#ifdef PAINTED
out vec3 painted;
#endif
#ifdef TINTED
flat out vec3 front_colour, back_colour;
#endif

void main() {
  to_eye = eye.xyz - position;
  front_normal = normal;
  openness = open;
  from_edges = edge_distances;
#ifdef SHADOWS
  in_light_map = (light_position * texels_a_cell.xy + 0.5) * light_texel.xy;
#endif
#ifdef PATTERN
  weave = pattern_position;
#endif
#ifdef PAINTED
  painted = colour.rgb;
#endif
#ifdef TINTED
  front_colour = front_tint.rgb;
  back_colour = back_tint.rgb;
#endif
  gl_Position = view_projection * vec4(position, 1.0);
}
