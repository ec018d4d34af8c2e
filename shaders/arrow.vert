#version 330 core
// An arrow: a shaft and a cone, in rows of corners around its axis.
#include "lighting.glsl"

layout(location = 0) in vec4 unit;    // x, y: cosine and sine of the angle about the axis; z: row, 0 to 7
layout(location = 1) in vec4 start;   // xyz: m, the tail; w: radius of the shaft (m)
layout(location = 2) in vec3 end;     // m, the tip
layout(location = 3) in vec4 colour;  // as displayed

out vec3 point;
out vec3 outward;
out vec3 painted;

const float head_width = 3.0, head_length = 8.5;  // radii of the shaft; width as in lines.h

void main() {
  vec3 span = end - start.xyz;
  float whole = max(length(span), 1e-9);
  vec3 axis = span / whole;
  vec3 right = normalize(cross(axis, abs(axis.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0)));
  vec3 radial = right * unit.x + cross(axis, right) * unit.y;
  float neck = max(whole - head_length * start.w, 0.0);
  int row = int(unit.z);
  // Tail: its middle and rim; shaft: both ends; back of the head: inner and outer rim; cone: rim and tip.
  float width = row == 0 || row == 7 ? 0.0 : row == 5 || row == 6 ? head_width : 1.0;
  float place = row < 3 ? 0.0 : row == 7 ? whole : neck;
  outward = row < 2 || row == 4 || row == 5 ? -axis
            : row < 4                       ? radial
                                            : normalize(radial * head_length + axis * head_width);
  point = start.xyz + axis * place + radial * (width * start.w);
  painted = colour.rgb;
  gl_Position = view_projection * vec4(point, 1.0);
}
