#include "high_order/runge_kutta_step.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace taut {

// h² Σ … of accelerations for positions, h Σ … for velocities.
void RungeKuttaStep::add(const dop853::StageWeights& weights, VectorSums& sums) const {
  for (std::size_t i = 0; i < weights.count; ++i)
    sums.add(acceleration(weights.stage[i]), h_ * h_ * weights.position[i], h_ * weights.velocity[i]);
}

const PhaseSums& RungeKuttaStep::sums_of(std::size_t stage) {
  sums_.start(*start_.position, *start_.velocity, dop853::nodes[stage] * h_);
  add(dop853::stage_sums[stage], sums_.sums);
  return sums_;
}

bool RungeKuttaStep::evaluate(Equations& equations, std::size_t stage) {
  return equations.evaluate(time_of(stage), sums_of(stage), accelerations_[stage]);
}

const Vectors& RungeKuttaStep::positions(std::size_t stage) {
  write_phase(sums_of(stage), phase_);
  place_pins(model_, time_of(stage), phase_.position, phase_.velocity);
  return phase_.position;
}

// Hairer, Nørsett and Wanner's formula (10.17): of order 8 for short steps, where the estimate of order 5 is
// the smaller one. That of positions has one h more in it, by way of their weights.
double RungeKuttaStep::end(double position, double velocity, Phase& end) {
  sums_.start(*start_.position, *start_.velocity, h_);
  std::array<VectorSums, 2> estimates;
  add(dop853::end_sums[0], sums_.sums);
  add(dop853::end_sums[1], estimates[0]);
  add(dop853::end_sums[2], estimates[1]);
  const std::array<LargestSums, 2> largest = write_phase(sums_, estimates, workers_, end);
  const auto size = [&](const LargestSums& one) {
    return std::max(one.position / position, one.velocity / velocity);
  };
  const double fifth = size(largest[0]), third = size(largest[1]);
  const double both = fifth * fifth + 0.01 * third * third;
  return both == 0.0 ? 0.0 : fifth * fifth / std::sqrt(both);
}

void RungeKuttaStep::keep_start(Vectors& position, Vectors& velocity, Vectors& acceleration) {
  std::swap(kept_start_.position, position);
  std::swap(kept_start_.velocity, velocity);
  std::swap(accelerations_[0], acceleration);
  start_ = {&kept_start_.position, &kept_start_.velocity, &accelerations_[0]};
}

bool RungeKuttaStep::prepare_interpolant(Equations& equations, const Vectors& position,
                                         const Vectors& velocity, const Vectors& acceleration) {
  end_.position = position;
  end_.velocity = velocity;
  accelerations_[dop853::stages] = acceleration;
  for (std::size_t stage = dop853::stages + 1; stage < dop853::all_stages; ++stage)
    if (!evaluate(equations, stage)) return false;
  return true;
}

// With s the share, r = 1 − s, and c_i Hairer's coefficients,
//   y(s) = y₀ + s (c₀ + r (c₁ + s (c₂ + r (c₃ + s (c₄ + r (c₅ + s c₆)))))),
//   c₀ = y₁ − y₀,  c₁ = h k₀ − c₀,  c₂ = c₀ − h k₁₂ − c₁,  c₃ … c₆ = h Σ d_j k_j,
// put together of y₀, y₁ and the slopes k_j; as Σ d_j = 0, the velocity at the start is in none of the last.
void RungeKuttaStep::between(double share, Phase& phase) {
  const double s = share, r = 1.0 - share;
  const double on_end = s * (1.0 - r * (1.0 - 2.0 * s)), on_first = s * r * (1.0 - s), on_last = -s * r * s;
  sums_.start(*start_.position, *start_.velocity, h_ * on_first);
  VectorSums& sums = sums_.sums;
  sums.add(*start_.position, -on_end, 0.0);
  sums.add(end_.position, on_end, 0.0);
  sums.add(*start_.velocity, 0.0, -on_end);
  sums.add(end_.velocity, h_ * on_last, on_end);
  dop853::Row in_position{}, in_velocity{};
  double scale = s * s * r * r;
  for (const dop853::StageWeights& weights : dop853::interpolant_sums) {
    for (std::size_t i = 0; i < weights.count; ++i) {
      in_position[weights.stage[i]] += scale * weights.position[i];
      in_velocity[weights.stage[i]] += scale * weights.velocity[i];
    }
    scale *= &weights == &dop853::interpolant_sums[1] ? r : s;
  }
  in_velocity[0] += on_first;
  in_velocity[dop853::stages] += on_last;
  add(dop853::side_by_side(in_position, in_velocity), sums);
  write_phase(sums_, phase);
  place_pins(model_, time_ + share * h_, phase.position, phase.velocity);
}

}  // namespace taut
