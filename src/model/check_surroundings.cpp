#include "checker.h"

namespace taut {
namespace {

template <typename Spec>
void check_touch(Checker& check, const Spec& spec) {
  check.not_negative(spec.friction, "friction", "");
  check.require(spec.restitution >= 0.0 && spec.restitution <= 1.0, "restitution",
                fmt::format("restitution must be from 0 to 1, not {}", spec.restitution));
}

void check_plane(Checker& check, const PlaneSpec& plane) {
  check.finite(plane.point, "point");
  check.require(plane.normal.allFinite() && Checker::apart(plane.normal, Vec3::Zero()), "normal",
                "normal must not be zero");
  check_touch(check, plane);
}

void check_sphere(Checker& check, const SphereSpec& sphere) {
  check.finite(sphere.centre, "centre");
  check.positive(sphere.radius, "radius", "m");
  check_touch(check, sphere);
}

void check_capsule(Checker& check, const CapsuleSpec& capsule) {
  check.finite(capsule.from, "from");
  check.finite(capsule.to, "to");
  check.require(Checker::apart(capsule.from, capsule.to), "to",
                "from and to are the same point: write a [[sphere]]");
  check.positive(capsule.radius, "radius", "m");
  check_touch(check, capsule);
}

void check_box(Checker& check, const BoxSpec& box) {
  check.finite(box.centre, "centre");
  check.finite(box.turn, "turn");
  check.require(box.size.allFinite() && (box.size.array() >= smallest_divisor).all(), "size",
                "size must be three lengths above 0 m");
  check_touch(check, box);
}

void check_wind(Checker& check, const WindSpec& wind) {
  check.enter("wind", 0);
  check.finite(wind.velocity, "velocity");
  check.not_negative(wind.gust, "gust", "");
  check.positive(wind.gust_time, "gust_time", "s");
  check.not_negative(wind.density, "density", "kg/m³");
  check.not_negative(wind.drag_coefficient, "drag_coefficient", "");
  check.require(wind.seed >= 0, "seed", fmt::format("seed must be 0 or more, not {}", wind.seed));
}

}  // namespace

void check_surroundings(Checker& check, const Description& description) {
  check_each(check, "plane", description.planes, check_plane);
  check_each(check, "sphere", description.spheres, check_sphere);
  check_each(check, "capsule", description.capsules, check_capsule);
  check_each(check, "box", description.boxes, check_box);
  if (description.wind) check_wind(check, *description.wind);
}

}  // namespace taut
