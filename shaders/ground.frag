#version 330 core
// Ground with grid lines that fade where they would alias, and fog towards the horizon. What stops things is a
// surface (SOLID), of a colour of its own where it is TINTED; what stops nothing is but lines on the mist, to see
// heights by. CUT_OUT: only the shadow on it, to lay over any page.
#include "lighting.glsl"
#include "dither.glsl"

uniform vec3 normal;
uniform vec3 foot_and_height;
#ifdef TINTED
uniform vec3 tint;  // as displayed, the ground's own colour
#endif

#ifdef SHADOWS
uniform sampler2D light_map;             // shares of the light (red) and of the sky (green) that reach it
uniform vec3 shade_scale, shade_start, shade_last;  // xy: from fragments to places there, up to the last
#endif

in vec3 point;
in vec2 from_foot;

out vec4 pixel;

float grid_lines(vec2 at, float half_width) {
  vec2 width = max(fwidth(at), vec2(1e-5));
  vec2 from_line = abs(fract(at - 0.5) - 0.5);
  vec2 reach = max(vec2(half_width), 0.5 * width);
  vec2 line = 1.0 - smoothstep(reach - 0.5 * width, reach + 0.5 * width, from_line);
  line *= min(vec2(half_width) / reach, 1.0);
  return max(line.x, line.y);
}

void main() {
  float mist = smoothstep(fog.x, fog.y, length(from_foot));
#ifdef SHADOWS
  vec2 shade = texture(light_map, min(gl_FragCoord.xy * shade_scale.xy + shade_start.xy, shade_last.xy)).rg;
  float reaching = shade.r, open = shade.g;
#else
  const float reaching = 1.0, open = 1.0;
#endif
#ifdef CUT_OUT
  pixel = vec4(vec3(0.0), (1.0 - (0.70 + 0.30 * reaching) * (0.75 + 0.25 * open)) * (1.0 - mist));
#else
  vec2 at = (foot_and_height.xy + from_foot) / fog.z;
  float lines = min(0.6 * grid_lines(at, 0.012) + 0.8 * grid_lines(0.25 * at, 0.006), 1.0);
  vec3 behind = sky_colour(normalize(point));
#ifdef SOLID
#ifdef TINTED
  vec3 own = linear_from_display(tint);
#else
  vec3 own = ground.rgb;
#endif
  vec3 albedo = own * (1.0 - ground.w * lines);
  vec3 sent = lit(albedo, normal, normalize(-point), reaching, 0.0);
  // Less of the sky's light, but no other tint: things that hide it send some of their own.
  float of_sky = dot(ambient_light(normal), vec3(0.33));
  float of_light = dot(light, vec3(0.33)) * max(dot(normal, to_light), 0.0) * reaching;
  vec3 colour = display_from_linear(sent * (1.0 - (1.0 - open) * of_sky / (of_sky + of_light)));
#else
  vec3 colour = behind * (1.0 - 0.7 * ground.w * lines) * mix(0.86, 1.0, reaching);
#endif
  pixel = vec4(mix(colour, behind, mist) + dither(), 1.0);
#endif
}
