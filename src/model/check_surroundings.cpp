#include "checker.h"

namespace taut {
namespace {

void check_rotation(Checker& check, const RotationSpec& rotation) {
  check.require(rotation.axis.allFinite() && Checker::apart(rotation.axis, Vec3::Zero()), "rotation",
                "rotation: axis must not be zero");
  if (rotation.through) check.finite(*rotation.through, "rotation");
  check.require(rotation.rate.has_value() == rotation.angle.empty(), "rotation",
                "rotation needs either a \"rate\", or \"angle\", a list of [time, degrees]");
  if (rotation.rate)
    check.require(std::isfinite(*rotation.rate), "rotation", "rotation: rate must be a finite number");
  check.require(std::isfinite(rotation.rise) && rotation.rise >= 0.0, "rotation",
                fmt::format("rotation: rise must be 0 s or more, not {}", rotation.rise));
  check.require(rotation.rate || rotation.rise == 0.0, "rotation",
                "rotation: rise is how long a \"rate\" takes to be reached; angles have their own times");
  double last = -infinity;
  for (const auto& [time, angle] : rotation.angle) {
    check.later(time, last, "rotation", "rotation: times of \"angle\"");
    check.require(std::isfinite(angle), "rotation", "rotation: angle must have finite numbers");
  }
}

void check_moves(Checker& check, const SolidMotionSpec& spec) {
  if (!spec.name.empty()) check.name(spec.name);
  check.way(spec.motion.sinusoid, spec.motion.path, "motion");
  if (spec.rotation) check_rotation(check, *spec.rotation);
}

template <typename Spec>
void check_touch(Checker& check, const Spec& spec) {
  check_moves(check, spec.moves);
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

void check_mesh_solid(Checker& check, const MeshSolidSpec& solid) {
  check.require(solid.data != nullptr, "file", "the solid's mesh has not been read");
  check_touch(check, solid);
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
  check_each(check, "solid", description.mesh_solids, check_mesh_solid);
  if (description.wind) check_wind(check, *description.wind);
}

}  // namespace taut
