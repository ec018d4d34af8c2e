#version 330 core
// For passes that only write depth.
void main() {}
