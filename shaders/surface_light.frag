#version 330 core
// How much of the light reaches each place of sheets that are spread out flat.
#include "soft_shadow.glsl"

uniform sampler2D places;        // of each mass, in the shadow map and its depth
uniform vec3 texels_a_cell;      // xy

out float reaching;

void main() {
  vec2 at = (gl_FragCoord.xy - 0.5) / texels_a_cell.xy;
  ivec2 last = textureSize(places, 0) - 2;
  ivec2 cell = clamp(ivec2(at), ivec2(0), last);
  vec2 share = at - vec2(cell);
  // A cell's triangles share its rising diagonal; which of them a place is on says which corner is of no use.
  bool upper = share.x + share.y < 1.0;
  vec3 corner = texelFetch(places, upper ? cell : cell + 1, 0).xyz;
  vec3 right = texelFetch(places, cell + ivec2(1, 0), 0).xyz;
  vec3 below = texelFetch(places, cell + ivec2(0, 1), 0).xyz;
  vec3 place = upper ? corner + share.x * (right - corner) + share.y * (below - corner)
                     : corner + (1.0 - share.x) * (below - corner) + (1.0 - share.y) * (right - corner);
  reaching = light_reaching_across(place);
}
