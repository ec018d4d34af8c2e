// What is the same for everything drawn in one pass; mirrors FrameBlock in src/render/frame_block.h. Everything
// is drawn in a space that has the camera's eye as its origin and y upwards.
layout(std140) uniform Frame {
  mat4 view_projection;   // to clip space
  mat4 shadow_matrix;     // to the shadow map's coordinates and depth, all 0 to 1
  vec4 eye;               // xyz: m
  vec4 forward;           // xyz: unit vector along the line of sight
  vec4 to_light;          // xyz: unit vector
  vec4 light;             // rgb, linear
  vec4 ambient_below;     // rgb, linear
  vec4 ambient_above;     // rgb, linear
  vec4 horizon;           // rgb as displayed
  vec4 sky;               // rgb as displayed
  vec4 ground;            // rgb, linear albedo; w: strength of the grid lines
  vec4 fog;               // x: start (m), y: end (m), z: grid spacing (m)
  vec4 shadow;            // x: 1 when there is a map, y: texel in map coordinates, z: texel (m)
  vec4 view;              // x: height of a pixel one metre away (m), y: samples a pixel
};
