#include "model/solid_motion.h"

namespace taut {
namespace {

// An angle and its derivatives (rad, rad/s, rad/s²).
struct AngleMotion {
  double angle = 0.0, rate = 0.0, change = 0.0;
};

// With u = t/rise the rate is that of the cubic 3u² − 2u³, whose slope is 0 at both ends, and so
// angle = rate·rise (u³ − u⁴/2).
AngleMotion turned_by(const SteadyTurn& turn, double time) {
  if (time <= 0.0) return {0.0, turn.rise > 0.0 ? 0.0 : turn.rate, 0.0};
  if (time >= turn.rise) return {turn.rate * (time - 0.5 * turn.rise), turn.rate, 0.0};
  const double u = time / turn.rise;
  return {turn.rate * turn.rise * u * u * u * (1.0 - 0.5 * u), turn.rate * u * u * (3.0 - 2.0 * u),
          turn.rate * 6.0 * u * (1.0 - u) / turn.rise};
}

AngleMotion turned_by(const Path& path, double time) {
  return {position_at(path, time).x(), velocity_at(path, time).x(), acceleration_at(path, time).x()};
}

AngleMotion turned_by(std::monostate, double) {
  return {};
}

AngleMotion turned_at(const SolidMotion& motion, double time) {
  return std::visit([time](const auto& turn) { return turned_by(turn, time); }, motion.turn);
}

// What `along` gives of the way, a function of it and the time; `still` where there is none.
template <class Along>
Vec3 of_way(const SolidMotion& motion, const Vec3& still, const Along& along) {
  if (const auto* sinusoid = std::get_if<Sinusoid>(&motion.way)) return along(*sinusoid);
  if (const auto* path = std::get_if<Path>(&motion.way)) return along(*path);
  return still;
}

Vec3 centre_at(const SolidMotion& motion, double time) {
  const Vec3 along = of_way(motion, motion.from, [time](const auto& way) { return position_at(way, time); });
  return motion.centre + (along - motion.from);
}

}  // namespace

Placement placement_at(const SolidMotion& motion, double time) {
  const Eigen::AngleAxisd turn(turned_at(motion, time).angle, motion.axis);
  return {turn.toRotationMatrix(), motion.centre, centre_at(motion, time)};
}

Twist twist_at(const SolidMotion& motion, double time) {
  const AngleMotion turned = turned_at(motion, time);
  const Vec3 none = Vec3::Zero();
  return {centre_at(motion, time),
          of_way(motion, none, [time](const auto& way) { return velocity_at(way, time); }),
          turned.rate * motion.axis,
          of_way(motion, none, [time](const auto& way) { return acceleration_at(way, time); }),
          turned.change * motion.axis};
}

}  // namespace taut
