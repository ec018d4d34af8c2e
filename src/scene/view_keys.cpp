#include "section.h"

namespace taut {
namespace {

constexpr double far = 1e6;      // m
constexpr double farther = 2e6;  // m; so that what is far away can be seen from a little farther

template <class T>
Key<T> colour_key(std::string_view name, Colour T::*member, std::string_view help) {
  return key<T>(name, member, {.range = between(0, 1), .help = help});
}

Keys<Camera> camera_keys() {
  return {
      key<Camera>("eye", &Camera::eye,
                  {.unit = "m",
                   .range = between(-farther, farther),
                   .fallback = "in `direction`, just so far that what there is to show is in view, whatever "
                               "the picture's shape",
                   .help = "where the picture is taken from"}),
      key<Camera>("target", &Camera::target,
                  {.unit = "m",
                   .range = between(-farther, farther),
                   .fallback = "the middle of what there is to show",
                   .help = "what is in the middle of it"}),
      key<Camera>("direction", &Camera::direction,
                  {.range = between(-far, far),
                   .help = "where the eye is, seen from what is shown, of any length but 0; of no effect "
                           "where `eye` is given"}),
      key<Camera>("show", &Camera::show,
                  {.unit = "m",
                   .range = between(-farther, farther),
                   .fallback = "where the masses go, by a coarse look ahead",
                   .help = "[lowest corner, highest corner] of a box that there is to show; with `follow`, "
                           "as it is at the start"}),
      key<Camera>("field_of_view", &Camera::field_of_view,
                  {.unit = "degrees",
                   .range = between(1, 150),
                   .help = "from the lower to the upper edge; pictures narrower than 16:9 with a given `eye` "
                           "see as far to the sides as those"}),
      key<Camera>("up", &Camera::up,
                  {.range = between(-far, far),
                   .fallback = "against gravity, or along y where there is none",
                   .help = "which way is up, for the camera, its orbit and the drawn ground, of any length "
                           "but 0"}),
      key<Camera>("orbit", &Camera::orbit,
                  {.unit = "degrees/s",
                   .range = between(-3600, 3600),
                   .help = "how fast the eye goes round the vertical through the target"}),
      key<Camera>("follow", &Camera::follow,
                  {.fallback = "none",
                   .help = "name of a mass; eye and target move along with it from where they are at the "
                           "start"}),
  };
}

Keys<Look> look_keys() {
  return {
      key<Look>("masses", &Look::masses, {.help = "whether masses are drawn"}),
      key<Look>("links", &Look::links, {.help = "whether links are drawn"}),
      key<Look>("surface", &Look::surface, {.help = "whether sheets are drawn as cloth"}),
      key<Look>(
          "ground", &Look::ground,
          {.help = "whether the planes are drawn, or in a scene without any grid lines to see heights by"}),
      key<Look>("shadows", &Look::shadows, {.help = "whether things cast shadows"}),
      key<Look>("bones", &Look::bones,
                {.help = "whether ragdolls are drawn as bodies, in place of their masses and links"}),
      key<Look>("colliders", &Look::colliders,
                {.help = "whether spheres, capsules and boxes to hit are drawn"}),
      key<Look>("supports", &Look::supports,
                {.help = "whether poles, rails, posts and brackets are drawn where pins are: what might hold "
                         "them, and no part of the physics"}),
      key<Look>("theme", &Look::theme, {.help = "sky and ground"}),
      key<Look>(
          "colour_by", &Look::colour_by,
          {.help = "what links (masses for speed, joints for limit) are coloured by; limit: 1 at a stop"}),
      key<Look>("colour_range", &Look::colour_range,
                {.unit = "1, N or m/s",
                 .range = between(0, 1e15),
                 .help = "strain, tension or speed at the top of the colour scale; 0: what 98 % of all links "
                         "(for speed, masses) stay below, in all pictures of a film, strip or comparison"}),
      key<Look>("colour_steps", &Look::colour_steps,
                {.help = "how values are spread over the colours; log: over three decades below the top"}),
      key<Look>("ground_height", &Look::ground_height,
                {.unit = "m",
                 .range = between(-far, far),
                 .fallback = "that of the plane; without any, zero, or below the lowest mass that is ever "
                             "below that",
                 .help = "where, upwards, the level ground is drawn"}),
      key<Look>("mass_radius", &Look::mass_radius,
                {.unit = "m",
                 .range = between(0, far),
                 .help = "of the median mass; 0: 0.21 of the median link length"}),
      key<Look>("link_radius", &Look::link_radius,
                {.unit = "m", .range = between(0, far), .help = "0: 0.42 of the mass radius"}),
      key<Look>("weights", &Look::weights,
                {.help = "whether masses are drawn larger and darker the heavier they are next to the median "
                         "one; not those with a radius of contact"}),
      key<Look>("link_shape", &Look::link_shape,
                {.help = "how links are drawn: as rods between masses, as rope, or as the rings of a chain"}),
      key<Look>("chain_pitch", &Look::chain_pitch,
                {.unit = "m",
                 .range = between(0, far),
                 .help = "from a ring of a chain to the next; 0: a ring for each link"}),
      key<Look>("families", &Look::families,
                {.choices = link_families,
                 .help = "which of a sheet's links are drawn; all others are structural"}),
      key<Look>("loads", &Look::loads, {.help = "whether loads are drawn as arrows"}),
      key<Look>("exact", &Look::exact,
                {.help = "whether the exact shape at rest is drawn as well, thin and pale"}),
      key<Look>("trails", &Look::trails,
                {.help = "names of masses whose ways so far are drawn, fading into the past"}),
      key<Look>("trail_time", &Look::trail_time,
                {.unit = "s", .range = between(0, far), .help = "how far back they go; 0: to the start"}),
      colour_key("mass_colour", &Look::mass_colour,
                 "of free masses: red, green, blue, each 0 to 1; text such as \"#cc8c33\" or \"gold\""),
      colour_key("pin_colour", &Look::pin_colour, "of pinned masses"),
      colour_key("link_colour", &Look::link_colour, "of links"),
      colour_key("bone_colour", &Look::bone_colour,
                 "of a ragdoll; several have a hue each, of about its lightness"),
      colour_key("collider_colour", &Look::collider_colour, "of what there is to hit"),
      colour_key("surface_colour", &Look::surface_colour, "of the cloth's front"),
      colour_key("surface_back_colour", &Look::surface_back_colour, "of the cloth's back"),
      key<Look>("pattern", &Look::pattern, {.help = "how the cloth is painted"}),
      key<Look>("speed", &Look::speed,
                {.range = between(0, 1e6),
                 .fallback = "1",
                 .help = "[time in s, speed], …: from each time on so many of the scene's seconds pass in a "
                         "second of film; 0.2 is slow motion"}),
      key<Look>(
          "thread_pitch", &Look::thread_pitch,
          {.unit = "m",
           .range = between(0, far),
           .help = "from thread to thread of a woven pattern; 0: an eightieth of the cloth's shorter side"}),
      key<Look>("hem_width", &Look::hem_width,
                {.unit = "m",
                 .range = between(0, far),
                 .fallback = "0.018 of the cloth's shorter side",
                 .help = "of the cloth that is turned over and sewn down along its borders; 0: none"}),
      key<Look>("mass_shape", &Look::mass_shape,
                {.help = "how masses are drawn; boxes show how each has turned with its links"}),
  };
}

Keys<Expectation> expect_keys() {
  return {
      key<Expectation>("max_strain", &Expectation::max_strain,
                       {.range = between(0, 1e6),
                        .fallback = "not checked",
                        .help = "largest |length ÷ length at rest − 1| of the links that are whole"}),
      key<Expectation>(
          "energy_drift", &Expectation::energy_drift,
          {.range = between(0, 1e6),
           .fallback = "not checked",
           .help = "|energy − work done − energy at the start|, as a share of the energy scale"}),
      key<Expectation>(
          "broken_links", &Expectation::broken_links,
          {.range = between(0, 1e12), .fallback = "not checked", .help = "[least, most] links broken"}),
      key<Expectation>("sag", &Expectation::sag,
                       {.unit = "m",
                        .range = between(-far, far),
                        .fallback = "not checked",
                        .help = "[least, most] of how far the lowest mass is below the lowest pin"}),
      key<Expectation>("at_rest", &Expectation::at_rest,
                       {.unit = "m/s",
                        .range = between(0, far),
                        .fallback = "not checked",
                        .help = "speed of the fastest mass"}),
      key<Expectation>("inside", &Expectation::inside,
                       {.unit = "m",
                        .range = between(-far, far),
                        .fallback = "not checked",
                        .help = "[lowest corner, highest corner] of a box that holds every mass"}),
      key<Expectation>("limit_excess", &Expectation::limit_excess,
                       {.unit = "degrees",
                        .range = between(0, 180),
                        .fallback = "not checked",
                        .help = "farthest that any angle is beyond its range"}),
      key<Expectation>("penetration", &Expectation::penetration,
                       {.unit = "m",
                        .range = between(0, far),
                        .fallback = "not checked",
                        .help = "deepest that anything is inside what it can hit: masses and faces in "
                                "solids, and in the thickness of faces"}),
      key<Expectation>("tangled", &Expectation::tangled,
                       {.range = between(0, 1e12),
                        .fallback = "not checked",
                        .help = "most places where faces go through one another or through boxes"}),
  };
}

}  // namespace

std::vector<Section> view_sections() {
  return {
      single_section<Camera>("camera", "Where the picture is taken from.", camera_keys(), &Scene::camera),
      single_section<Look>("look", "What is drawn, and how.", look_keys(), &Scene::look),
      single_section<Expectation>("expect", "What must hold at the end of the run.", expect_keys(),
                                  &Scene::expectation),
  };
}

}  // namespace taut
