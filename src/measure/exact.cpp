#include "measure/exact.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace taut {
namespace {

constexpr double level_modulus = std::numbers::sqrt2 / 2.0;  // k = sin(90°/2) of a pendulum released level

// Jacobi's sn(u | k) by the arithmetic–geometric mean and descending Landen transformation (Abramowitz and
// Stegun 16.4).
double jacobi_sn(double u, double k) {
  std::array<double, 16> a{}, c{};
  a[0] = 1.0;
  double b = std::sqrt(1.0 - k * k);
  c[0] = k;
  std::size_t n = 0;
  while (std::abs(c[n]) > 1e-16 && n + 1 < a.size()) {
    a[n + 1] = 0.5 * (a[n] + b);
    c[n + 1] = 0.5 * (a[n] - b);
    b = std::sqrt(a[n] * b);
    ++n;
  }
  double phase = std::ldexp(a[n] * u, static_cast<int>(n));
  for (; n > 0; --n) phase = 0.5 * (phase + std::asin(std::clamp(c[n] / a[n] * std::sin(phase), -1.0, 1.0)));
  return std::sin(phase);
}

using Vec2 = Eigen::Vector2d;
using Matrix2 = Eigen::Matrix2d;

// End of the chain that starts with force (H, V) in its first link, its derivative, and the shape on the way.
struct HangingShape {
  Vec2 end = Vec2::Zero();
  Matrix2 derivative = Matrix2::Zero();
  std::vector<Vec2> points;
  std::vector<double> tensions;
};

HangingShape follow(const Vec2& first_force, int link_count, double length, double compliance,
                    double weight) {
  HangingShape shape;
  shape.points.push_back(Vec2::Zero());
  for (int i = 0; i < link_count; ++i) {
    // The pull of link i on the mass before it: the first pin carries what lies below.
    const Vec2 force(first_force.x(), first_force.y() + i * weight);
    const double size = force.norm();
    const Vec2 direction = force / size;
    shape.end += direction * (length + compliance * size);
    shape.derivative += (length / size) * (Matrix2::Identity() - direction * direction.transpose()) +
                        compliance * Matrix2::Identity();
    shape.points.push_back(shape.end);
    shape.tensions.push_back(size);
  }
  return shape;
}

}  // namespace

double pendulum_period(double length, double gravity) {
  return 4.0 * std::comp_ellint_1(level_modulus) * std::sqrt(length / gravity);
}

double pendulum_angle_below_level(double length, double gravity, double time) {
  const double u = std::comp_ellint_1(level_modulus) - time * std::sqrt(gravity / length);
  return 0.5 * std::numbers::pi - 2.0 * std::asin(level_modulus * jacobi_sn(u, level_modulus));
}

HangingChain hanging_chain_at_rest(const Vec3& from, const Vec3& to, int link_count, double link_length,
                                   double compliance, double weight_per_mass) {
  const Vec2 span(to.x() - from.x(), to.y() - from.y());
  // Start from a taut guess: half the weight down at the first pin, as much across. Damped Newton steps from
  // there.
  const double weight = weight_per_mass * (link_count - 1);
  Vec2 force(0.5 * weight + weight_per_mass, -0.5 * weight + 1e-3 * weight_per_mass);
  HangingShape shape = follow(force, link_count, link_length, compliance, weight_per_mass);
  for (int round = 0; round < 200; ++round) {
    const Vec2 miss = span - shape.end;
    if (miss.norm() <= 1e-15 * link_length * link_count) break;
    const Vec2 change = shape.derivative.inverse() * miss;
    double share = 1.0;
    for (int halving = 0; halving < 40; ++halving, share *= 0.5) {
      const Vec2 trial = force + share * change;
      if (trial.x() <= 0.0) continue;  // the horizontal pull never turns round
      HangingShape tried = follow(trial, link_count, link_length, compliance, weight_per_mass);
      if ((span - tried.end).norm() >= miss.norm()) continue;
      force = trial;
      shape = std::move(tried);
      break;
    }
  }
  HangingChain chain;
  chain.tensions = shape.tensions;
  double lowest = std::min(from.y(), to.y());
  for (const Vec2& point : shape.points) {
    chain.positions.push_back(from + Vec3(point.x(), point.y(), 0.0));
    lowest = std::min(lowest, chain.positions.back().y());
  }
  chain.sag = std::min(from.y(), to.y()) - lowest;
  return chain;
}

}  // namespace taut
