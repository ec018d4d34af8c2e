// What is the same for everything drawn in one pass; mirrors FrameBlock in src/render/geometry/frame_block.h. Everything
// is drawn in a space that has the camera's eye as its origin and y upwards.
layout(std140) uniform Frame {
  mat4 view_projection;   // to clip space
  mat4 shadow_matrix;     // to the shadow map's coordinates and depth, all 0 to 1
  vec4 eye;               // xyz: m; the origin, but for the pass of the shadow map
  vec4 forward;           // xyz: unit vector along the line of sight
  vec4 fog;               // x: start (m), y: end (m), z: grid spacing (m)
  vec4 shadow;            // y: texel in map coordinates, z: texel (m), w: width over depth of what is in the map
  vec4 view;              // x: height of a pixel one metre away (m)
};

// What is the same for all pictures of a look stands in the shaders as numbers: Mesa's software drivers would
// read it from memory for every fragment.
const vec3 to_light = TO_LIGHT;            // unit vector
const vec3 light = LIGHT;                  // linear
const vec3 ambient_below = AMBIENT_BELOW;  // linear
const vec3 ambient_above = AMBIENT_ABOVE;  // linear
const vec3 horizon = HORIZON;              // as displayed
const vec3 sky = SKY;                      // as displayed
const vec4 ground = GROUND;                // rgb: linear albedo; w: strength of the grid lines
