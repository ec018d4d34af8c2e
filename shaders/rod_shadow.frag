#version 330 core
in vec2 at;
flat in float radius, span;

void main() {
  vec2 from_axis = vec2(at.x - clamp(at.x, 0.0, span), at.y);
  if (dot(from_axis, from_axis) > radius * radius) discard;
}
