#include "object_section.h"
#include "physics_facts.h"
#include "solid_keys.h"

namespace taut {
namespace {

Keys<PlaneSpec> plane_keys() {
  return Keys<PlaneSpec>{
             key<PlaneSpec>("point", &PlaneSpec::point,
                            {.unit = "m", .range = between(-far, far), .help = "any point on it"}),
             key<PlaneSpec>(
                 "normal", &PlaneSpec::normal,
                 {.range = between(-far, far), .help = "away from the ground, of any length but 0"}),
         } +
         touch_keys<PlaneSpec>();
}

Keys<SphereSpec> sphere_keys() {
  return Keys<SphereSpec>{
             key<SphereSpec>("centre", &SphereSpec::centre, where("of the sphere")),
             key<SphereSpec>("radius", &SphereSpec::radius,
                             {.unit = "m", .range = above_to(0, far), .help = "of the sphere"}),
         } +
         touch_keys<SphereSpec>();
}

Keys<CapsuleSpec> capsule_keys() {
  return Keys<CapsuleSpec>{
             key<CapsuleSpec>("from", &CapsuleSpec::from, where("one end of its middle line")),
             key<CapsuleSpec>("to", &CapsuleSpec::to, where("the other end")),
             key<CapsuleSpec>("radius", &CapsuleSpec::radius,
                              {.unit = "m", .range = above_to(0, far), .help = "around that line"}),
         } +
         touch_keys<CapsuleSpec>();
}

Keys<BoxSpec> box_keys() {
  return Keys<BoxSpec>{
             key<BoxSpec>("centre", &BoxSpec::centre, where("of the box")),
             key<BoxSpec>("size", &BoxSpec::size,
                          {.unit = "m", .range = above_to(0, far), .help = "of its edges along x, y and z"}),
             key<BoxSpec>("turn", &BoxSpec::turn,
                          {.unit = "degrees",
                           .range = between(-360, 360),
                           .help = "about x, then y, then z, through its centre"}),
         } +
         touch_keys<BoxSpec>();
}

Keys<WindSpec> wind_keys() {
  return {
      key<WindSpec>("velocity", &WindSpec::velocity,
                    {.unit = "m/s",
                     .range = between(-1000, 1000),
                     .help = "of the air, without gusts; zero: still air, which slows what moves in it"}),
      key<WindSpec>("gust", &WindSpec::gust,
                    {.range = between(0, 10), .help = "how far gusts reach, as a share of the velocity"}),
      key<WindSpec>("gust_time", &WindSpec::gust_time,
                    {.unit = "s", .range = above_to(0, far), .help = "from one gust to the next"}),
      key<WindSpec>("seed", &WindSpec::seed, {.range = between(0, 1e9), .help = "which gusts"}),
      key<WindSpec>("density", &WindSpec::density,
                    {.unit = "kg/m³", .range = between(0, 1e4), .help = "of the air; zero: a vacuum"}),
      key<WindSpec>("drag_coefficient", &WindSpec::drag_coefficient,
                    {.range = between(0, 100), .help = "of a triangle that faces the wind"}),
  };
}

}  // namespace

std::vector<Section> surroundings_sections() {
  return {
      object_section<PlaneSpec>("plane", "The ground, or another flat solid, which no mass can enter.",
                                plane_keys(), solid_look, &Description::planes, &ObjectLooks::planes),
      object_section<SphereSpec>("sphere", "A ball that stays where it is and that no mass can enter.",
                                 sphere_keys(), solid_look, &Description::spheres, &ObjectLooks::spheres),
      object_section<CapsuleSpec>("capsule", "A rod with round ends that no mass can enter.", capsule_keys(),
                                  solid_look, &Description::capsules, &ObjectLooks::capsules),
      object_section<BoxSpec>("box", "A box that no mass can enter; several make a stair.", box_keys(),
                              solid_look, &Description::boxes, &ObjectLooks::boxes),
      optional_section<WindSpec>("wind", "Air that blows on both sides of sheets; left out: a vacuum.",
                                 wind_keys(), description_of(&Description::wind)),
  };
}

}  // namespace taut
