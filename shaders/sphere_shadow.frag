#version 330 core
// The sphere as the light sees it: a disc.
in vec2 disc;

void main() {
  if (dot(disc, disc) > 1.0) discard;
}
