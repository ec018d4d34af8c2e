#include "high_order/runge_kutta_step.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/vector_operations.h"

namespace taut {
namespace {

using dop853::Row;

// How many of a row's weights count, and which.
template <const Row& row>
constexpr std::size_t count_of = static_cast<std::size_t>(std::ranges::count_if(row, [](double w) {
  return w != 0.0;
}));
template <const Row& row>
constexpr auto places_of = [] {
  std::array<std::size_t, count_of<row>> places{};
  std::size_t next = 0;
  for (std::size_t i = 0; i < row.size(); ++i)
    if (row[i] != 0.0) places[next++] = i;
  return places;
}();

// The rows as objects of their own, so that they can be template arguments.
template <std::size_t stage>
constexpr Row stage_row = dop853::weights[stage];
template <std::size_t place>
constexpr Row interpolant_row = dop853::interpolant[place];

using Slopes = std::array<Phase, dop853::all_stages>;
// An axis of the positions or the velocities of all slopes.
using Axis = std::vector<double> Vectors::*;

// Σ w_j k_j of an axis, as an expression; slopes of no weight are not read.
template <const Row& row, std::size_t... place>
auto weighted_sum(const Slopes& slopes, Vectors Phase::*part, Axis axis, std::index_sequence<place...>) {
  return ((row[places_of<row>[place]] * all_of(slopes[places_of<row>[place]].*part.*axis)) + ...);
}
template <const Row& row>
auto weighted_sum(const Slopes& slopes, Vectors Phase::*part, Axis axis) {
  return weighted_sum<row>(slopes, part, axis, std::make_index_sequence<count_of<row>>());
}

constexpr std::array axes{&Vectors::x, &Vectors::y, &Vectors::z};

// to = from + h Σ w_j k_j
template <const Row& row>
void move_along(const Slopes& slopes, Vectors Phase::*part, double h, const Vectors& from, Vectors& to) {
  to.resize(from.size());
  for (const Axis axis : axes)
    all_of(to.*axis) = all_of(from.*axis) + h * weighted_sum<row>(slopes, part, axis);
}

// The largest |Σ w_j k_j| of a coordinate.
template <const Row& row>
double largest_sum(const Slopes& slopes, Vectors Phase::*part) {
  double largest = 0.0;
  for (const Axis axis : axes) {
    const double size = weighted_sum<row>(slopes, part, axis).abs().template maxCoeff<Eigen::PropagateNaN>();
    if (!(size <= largest)) largest = size;
  }
  return largest;
}

using Mover = void (*)(const Slopes&, Vectors Phase::*, double, const Vectors&, Vectors&);
constexpr auto movers = []<std::size_t... stage>(std::index_sequence<stage...>) {
  return std::array<Mover, sizeof...(stage) + 1>{nullptr, move_along<stage_row<stage + 1>>...};
}
(std::make_index_sequence<dop853::all_stages - 1>());

}  // namespace

void RungeKuttaStep::begin(double time, double h, const Vectors& position, const Vectors& velocity,
                           const Vectors& acceleration) {
  time_ = time;
  h_ = h;
  start_.position = position;
  start_.velocity = velocity;
  slopes_[0].position = velocity;
  slopes_[0].velocity = acceleration;
}

bool RungeKuttaStep::evaluate(Equations& equations, std::size_t stage) {
  Phase& slope = slopes_[stage];
  movers[stage](slopes_, &Phase::position, h_, start_.position, position_);
  // The slope of the positions is the stage's velocity.
  movers[stage](slopes_, &Phase::velocity, h_, start_.velocity, slope.position);
  const double time = time_ + dop853::nodes[stage] * h_;
  place_pins(model_, time, position_, slope.position);
  return equations.evaluate(time, position_, slope.position, slope.velocity);
}

void RungeKuttaStep::end(Phase& end) const {
  movers[dop853::stages](slopes_, &Phase::position, h_, start_.position, end.position);
  movers[dop853::stages](slopes_, &Phase::velocity, h_, start_.velocity, end.velocity);
}

// Hairer, Nørsett and Wanner's formula (10.17): of order 8 for short steps, where the estimate of order 5 is
// the smaller one.
double RungeKuttaStep::error(double position, double velocity) const {
  const auto size = [&]<const Row & row>() {
    return std::max(largest_sum<row>(slopes_, &Phase::position) / position,
                    largest_sum<row>(slopes_, &Phase::velocity) / velocity);
  };
  const double fifth = size.operator()<dop853::fifth_order_error>(),
               third = size.operator()<dop853::third_order_error>();
  const double both = fifth * fifth + 0.01 * third * third;
  return both == 0.0 ? 0.0 : h_ * fifth * fifth / std::sqrt(both);
}

bool RungeKuttaStep::prepare_interpolant(Equations& equations, const Phase& end,
                                         const Vectors& acceleration) {
  slopes_[dop853::stages].position = end.velocity;
  slopes_[dop853::stages].velocity = acceleration;
  for (std::size_t stage = dop853::stages + 1; stage < dop853::all_stages; ++stage)
    if (!evaluate(equations, stage)) return false;
  for (const auto part : {&Phase::position, &Phase::velocity}) {
    const Vectors &from = start_.*part, &to = end.*part;
    for (Phase& coefficient : coefficients_) (coefficient.*part).resize(from.size());
    for (const Axis axis : axes) {
      const auto coefficient = [&](std::size_t place) { return all_of(coefficients_[place].*part.*axis); };
      coefficient(0) = all_of(to.*axis) - all_of(from.*axis);
      coefficient(1) = h_ * all_of(slopes_[0].*part.*axis) - coefficient(0);
      coefficient(2) = coefficient(0) - h_ * all_of(slopes_[dop853::stages].*part.*axis) - coefficient(1);
      coefficient(3) = h_ * weighted_sum<interpolant_row<0>>(slopes_, part, axis);
      coefficient(4) = h_ * weighted_sum<interpolant_row<1>>(slopes_, part, axis);
      coefficient(5) = h_ * weighted_sum<interpolant_row<2>>(slopes_, part, axis);
      coefficient(6) = h_ * weighted_sum<interpolant_row<3>>(slopes_, part, axis);
    }
  }
  return true;
}

void RungeKuttaStep::between(double share, Phase& phase) const {
  const double s = share, r = 1.0 - share;
  for (const auto part : {&Phase::position, &Phase::velocity}) {
    (phase.*part).resize((start_.*part).size());
    for (const Axis axis : axes) {
      const auto c = [&](std::size_t place) { return all_of(coefficients_[place].*part.*axis); };
      all_of(phase.*part.*axis) =
          all_of(start_.*part.*axis) +
          s * (c(0) + r * (c(1) + s * (c(2) + r * (c(3) + s * (c(4) + r * (c(5) + s * c(6)))))));
    }
  }
  place_pins(model_, time_ + share * h_, phase.position, phase.velocity);
}

}  // namespace taut
