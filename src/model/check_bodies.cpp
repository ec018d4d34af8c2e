#include <algorithm>
#include <array>

#include "checker.h"

namespace taut {
namespace {

// A range in degrees that must lie within what its kind of angle can be.
void check_range(Checker& check, const std::array<double, 2>& range, double least, double most,
                 std::string_view min_key, std::string_view max_key) {
  const auto within = [&](double x) { return x >= least && x <= most; };
  const auto outside = [&](std::string_view key, double x) {
    return fmt::format("{} must be from {} to {} degrees, not {}", key, least, most, x);
  };
  check.require(within(range[0]), min_key, outside(min_key, range[0]));
  check.require(within(range[1]), max_key, outside(max_key, range[1]));
  check.require(!(range[0] > range[1]), min_key == max_key ? max_key : min_key,
                min_key == max_key
                    ? fmt::format("{} begins above its end: {} to {} degrees", min_key, range[0], range[1])
                    : fmt::format("min = {} degrees is above max = {} degrees", range[0], range[1]));
}

void check_half_angle(Checker& check, double half_angle, std::string_view key) {
  check.require(half_angle > 0.0 && half_angle <= 180.0, key,
                fmt::format("{} must be above 0 and at most 180 degrees, not {}", key, half_angle));
}

void check_count(Checker& check, const std::vector<std::string>& names, std::size_t least, std::size_t most,
                 std::string_view key) {
  check.require(names.size() >= least && names.size() <= most, key,
                least == most
                    ? fmt::format("{} must name {} masses, not {}", key, least, names.size())
                    : fmt::format("{} must name {} or {} masses, not {}", key, least, most, names.size()));
}

void check_angle(Checker& check, const AngleSpec& angle) {
  check_count(check, angle.masses, 3, 3, "masses");
  check_range(check, {angle.min, angle.max}, 0.0, 180.0, "min", "max");
  check.not_negative(angle.compliance, "compliance", "rad/(N m)");
}

void check_hinge(Checker& check, const HingeSpec& hinge) {
  check_count(check, hinge.masses, 3, 3, "masses");
  check_count(check, hinge.axis, 2, 2, "axis");
  check_range(check, {hinge.min, hinge.max}, -180.0, 180.0, "min", "max");
  check.not_negative(hinge.compliance, "compliance", "rad/(N m)");
}

void check_cone(Checker& check, const ConeSpec& cone) {
  check_count(check, cone.frame, 3, 3, "frame");
  check_count(check, cone.limb, 2, 3, "limb");
  check.require(cone.axis.allFinite() && Checker::apart(cone.axis, Vec3::Zero()), "axis",
                "axis must not be zero");
  check_half_angle(check, cone.half_angle, "half_angle");
  check.not_negative(cone.compliance, "compliance", "rad/(N m)");
}

void check_ragdoll(Checker& check, const RagdollSpec& ragdoll) {
  check.name(ragdoll.name);
  check.positive(ragdoll.height, "height", "m");
  check.positive(ragdoll.mass, "mass", "kg");
  check.finite(ragdoll.position, "position");
  check.finite(ragdoll.turn, "turn");
  check.finite(ragdoll.velocity, "velocity");
  check.finite(ragdoll.spin, "spin");
  for (const std::string& part : ragdoll.pinned)
    check.require(
        std::find(ragdoll_handles.begin(), ragdoll_handles.end(), part) != ragdoll_handles.end(), "pinned",
        fmt::format("pinned names left_hand, right_hand, left_foot, right_foot or head, not \"{}\"", part));
  const RangeSpec& ranges = ragdoll.ranges;
  const auto range = [&](const std::array<double, 2>& limits, std::string_view key) {
    check_range(check, limits, -180.0, 180.0, key, key);
  };
  range(ranges.neck, "ranges.neck");
  range(ranges.elbow, "ranges.elbow");
  range(ranges.knee, "ranges.knee");
  check_half_angle(check, ranges.shoulder, "ranges.shoulder");
  check_half_angle(check, ranges.hip, "ranges.hip");
  check_half_angle(check, ranges.hip_twist, "ranges.hip_twist");
  check_half_angle(check, ranges.wrist, "ranges.wrist");
  check_half_angle(check, ranges.ankle, "ranges.ankle");
}

}  // namespace

void check_bodies(Checker& check, const Description& description) {
  check_each(check, "ragdoll", description.ragdolls, check_ragdoll);
  check_each(check, "angle", description.angles, check_angle);
  check_each(check, "hinge", description.hinges, check_hinge);
  check_each(check, "cone", description.cones, check_cone);
}

}  // namespace taut
