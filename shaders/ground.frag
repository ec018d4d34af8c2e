#version 330 core
// Ground with grid lines that fade where they would alias, and fog towards the horizon.
#include "lighting.glsl"

in vec3 point;

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
  float away = length(point.xz - eye.xz);
  float mist = smoothstep(fog.x, fog.y, away);
  vec2 at = point.xz / fog.z;
  float lines = 0.6 * grid_lines(at, 0.012) + 0.8 * grid_lines(0.25 * at, 0.006);
  vec3 albedo = ground.rgb * (1.0 - ground.w * min(lines, 1.0));
  vec3 normal = vec3(0.0, 1.0, 0.0);
  float reaching = light_reaching(point);
  vec3 colour = display_from_linear(lit(albedo, normal, normalize(eye.xyz - point), reaching, 0.0));
  pixel = vec4(mix(colour, horizon.rgb, mist), 1.0);
}
