#include "model/way.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace taut {
namespace {

// Harmonic mean of the slopes on both sides; 0 where they disagree in sign. It is at most twice the smaller
// one. That keeps a quintic without acceleration at its ends from turning back: for slopes up to 2, in units
// of its mean slope, its velocity is linear in both and not negative at the four corners.
double limited_slope(double before, double after) {
  return before * after > 0.0 ? 2.0 * before * after / (before + after) : 0.0;
}

// Position or its derivative of the given order, 1 or 2, on the quintic between two knots with given
// velocities and no acceleration.
Vec3 on_segment(const Knot& start, const Knot& end, const Vec3& start_velocity, const Vec3& end_velocity,
                double time, int order) {
  const double span = end.time - start.time;
  const double u = (time - start.time) / span;
  const double u2 = u * u;
  const Vec3 rise = end.position - start.position;
  const Vec3 v0 = start_velocity * span;
  const Vec3 v1 = end_velocity * span;
  // p(u) = p0 + v0 u + u³ (a + b u + c u²) with p(1) = p1, p'(1) = v1, p''(1) = 0.
  const Vec3 a = 10.0 * rise - 6.0 * v0 - 4.0 * v1;
  const Vec3 b = -15.0 * rise + 8.0 * v0 + 7.0 * v1;
  const Vec3 c = 6.0 * rise - 3.0 * v0 - 3.0 * v1;
  if (order == 0) return start.position + v0 * u + u2 * u * (a + b * u + c * u2);
  if (order == 1) return (v0 + u2 * (3.0 * a + 4.0 * b * u + 5.0 * c * u2)) / span;
  return u * (6.0 * a + 12.0 * b * u + 20.0 * c * u2) / (span * span);
}

Vec3 path_at(const Path& path, double time, int order) {
  const auto& knots = path.knots;
  const Vec3 still = Vec3::Zero();
  if (time <= knots.front().time) return order == 0 ? knots.front().position : still;
  if (time >= knots.back().time) return order == 0 ? knots.back().position : still;
  const auto next = std::upper_bound(knots.begin(), knots.end(), time,
                                     [](double t, const Knot& knot) { return t < knot.time; });
  const auto i = static_cast<std::size_t>(next - knots.begin()) - 1;
  return on_segment(knots[i], knots[i + 1], path.velocities[i], path.velocities[i + 1], time, order);
}

double sinusoid_angle(const Sinusoid& motion, double time) {
  return motion.angular_frequency * time + motion.phase;
}

}  // namespace

Path make_path(std::vector<Knot> knots) {
  std::vector<Vec3> velocities(knots.size(), Vec3::Zero());
  for (std::size_t i = 1; i + 1 < knots.size(); ++i) {
    const double before = knots[i].time - knots[i - 1].time;
    const double after = knots[i + 1].time - knots[i].time;
    const Vec3 slope_before = (knots[i].position - knots[i - 1].position) / before;
    const Vec3 slope_after = (knots[i + 1].position - knots[i].position) / after;
    for (int axis = 0; axis < 3; ++axis)
      velocities[i][axis] = limited_slope(slope_before[axis], slope_after[axis]);
  }
  return {std::move(knots), std::move(velocities)};
}

Vec3 position_at(const Path& way, double time) {
  return path_at(way, time, 0);
}

Vec3 velocity_at(const Path& way, double time) {
  return path_at(way, time, 1);
}

Vec3 acceleration_at(const Path& way, double time) {
  return path_at(way, time, 2);
}

Vec3 position_at(const Sinusoid& way, double time) {
  return way.rest + way.amplitude * std::sin(sinusoid_angle(way, time));
}

Vec3 velocity_at(const Sinusoid& way, double time) {
  return way.amplitude * (way.angular_frequency * std::cos(sinusoid_angle(way, time)));
}

Vec3 acceleration_at(const Sinusoid& way, double time) {
  const double squared = way.angular_frequency * way.angular_frequency;
  return way.amplitude * (-squared * std::sin(sinusoid_angle(way, time)));
}

}  // namespace taut
