#include "high_order/stepper.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/vector_operations.h"

namespace taut {
namespace {

constexpr double longest_step = 1.0;      // s
constexpr double shortest_step = 1e-13;   // s
constexpr double velocity_weight = 10.0;  // 1/s: the tolerance of velocities over that of positions
// Of the length that the error asks for. Chains that whip make steps ever shorter: with 0.9 every fourth was
// made in vain, and the same error took 5 to 20 % more evaluations.
constexpr double safety = 0.8;
constexpr double least_factor = 1.0 / 3.0, most_factor = 6.0;
// Two stops that push each other open may be met and left ever faster. Where events of stops crowd together
// like that, what leaves slowly is held at rest; where that does not end it, the step fails.
constexpr double crowd = 1e-5;                         // s between two events
constexpr int a_crowd = 6, most_crowded = 60;          // events
constexpr double slow = 1e-9, slow_in_a_crowd = 1e-3;  // rad/s
// Stages whose positions and tensions are near enough to those of the motion to hint at events.
constexpr std::array<std::size_t, 4> telling_stages{3, 6, 9, 10};

std::vector<double> times_of_kinks(const Model& model) {
  std::vector<double> times;
  for (const Load& load : model.loads) times.insert(times.end(), {load.from, load.to, load.until, load.gone});
  for (const DrivenPin& pin : model.driven_pins) {
    const std::vector<double> kinks = kinks_of(pin.motion);
    times.insert(times.end(), kinks.begin(), kinks.end());
  }
  std::ranges::sort(times);
  return times;
}

double eighth_root(double value) {
  return std::sqrt(std::sqrt(std::sqrt(value)));
}

double largest_norm(const Vectors& vectors) {
  double square = 0.0;
  for (std::size_t i = 0; i < vectors.size(); ++i) square = std::max(square, vectors.at(i).squaredNorm());
  return std::sqrt(square);
}

}  // namespace

HighOrderStepper::HighOrderStepper(const Model& model, double tolerance, std::shared_ptr<Workers> workers)
    : model_(model),
      tolerance_(tolerance),
      workers_(std::move(workers)),
      kinks_(times_of_kinks(model)),
      watch_(model),
      runge_kutta_(model, workers_.get()) {}

void HighOrderStepper::load(const State& state) {
  keep_end();
  if (state.broken_at != state_.broken_at) equations_.reset();
  state_ = state;
  begun_ = false;
}

// Brings a state that comes from elsewhere to where it belongs: on its links and stops.
bool HighOrderStepper::begin(StepReport& report) {
  if (!equations_) equations_ = std::make_shared<Equations>(model_, state_, workers_);
  equations_->hold(state_.own_steps.held);
  if (!state_.own_steps.settled) {
    place_pins(model_, state_.time, state_.position, state_.velocity);
    equations_->hold({});
    if (!equations_->project(state_.position, state_.velocity)) {
      report.status = StepStatus::not_converged;
      report.worst_link = equations_->worst_link();
      return false;
    }
    if (!equations_->settle(state_.time, state_.position, slow, state_.velocity, state_.own_steps.held)) {
      report.status = StepStatus::not_converged;
      return false;
    }
    state_.own_steps.settled = true;
  }
  if (!look_again(report)) return false;
  if (state_.own_steps.next == 0.0) state_.own_steps.next = first_length();
  begun_ = true;
  return true;
}

// Accelerations and tensions where the masses are, with what is whole and held.
bool HighOrderStepper::look_again(StepReport& report) {
  report.link_solves += static_cast<std::int64_t>(equations_->rows());
  ++report.factorisations;
  if (!equations_->evaluate(state_.time, state_.position, state_.velocity, acceleration_)) {
    report.status = StepStatus::factorisation_failed;
    return false;
  }
  equations_->write_tensions(state_.tension);
  watch_.begin(state_);
  if (!watch_.none()) past_ = watch_.past(state_.position, *equations_);
  return true;
}

// A guess: the time in which masses cross the shortest link, times what the tolerance leaves of that by the
// order of the method.
double HighOrderStepper::first_length() const {
  double length = infinity;
  for (const double l : model_.links.length)
    if (l > 0.0) length = std::min(length, l);
  if (length == infinity) length = 1.0;
  const double speed = largest_norm(state_.velocity);
  const double pull = largest_norm(acceleration_) + speed * speed / length;
  if (!(pull > 0.0)) return longest_step;
  return std::min(longest_step, std::sqrt(length / pull) * eighth_root(std::min(1.0, tolerance_ / length)));
}

// The end of a step of h; exactly where it is to end at the latest.
double HighOrderStepper::time_after(double h) const {
  return h == longest_ ? goal_ : state_.time + h;
}

// One whose error is larger than is allowed in it goes no further than its stages.
HighOrderStepper::Attempt HighOrderStepper::attempt(double h, double most_error, StepReport& report) {
  Attempt tried;
  samples_.clear();
  if (!watch_.none()) samples_.push_back({0.0, past_});
  const auto look = [&](std::size_t stage) {
    if (!watch_.none() && std::ranges::find(telling_stages, stage) != telling_stages.end())
      samples_.push_back({dop853::nodes[stage] * h, watch_.past(runge_kutta_.positions(stage), *equations_)});
  };
  ++report.rounds;
  report.link_solves += static_cast<std::int64_t>(dop853::stages * equations_->rows());
  report.factorisations += static_cast<std::int64_t>(dop853::stages);
  last_.interpolant = false;
  if (!runge_kutta_.make(*equations_, state_.time, h, state_.position, state_.velocity, acceleration_,
                         look)) {
    tried.status = StepStatus::factorisation_failed;
    return tried;
  }
  tried.error = runge_kutta_.end(tolerance_, velocity_weight * tolerance_, end_);
  if (!std::isfinite(tried.error)) tried.status = StepStatus::not_finite;
  tried.good = tried.error <= most_error;
  if (!tried.good) return tried;
  tried.good = false;
  const double end_time = time_after(h);
  place_pins(model_, end_time, end_.position, end_.velocity);
  report.link_solves += static_cast<std::int64_t>(equations_->rows());
  ++report.factorisations;
  if (!equations_->project(end_.position, end_.velocity)) {
    tried.status = StepStatus::not_converged;
    return tried;
  }
  if (!equations_->evaluate(end_time, end_.position, end_.velocity, end_acceleration_)) {
    tried.status = StepStatus::factorisation_failed;
    return tried;
  }
  equations_->write_tensions(end_tension_);
  if (!watch_.none()) {
    end_past_ = watch_.past(end_.position, *equations_);
    samples_.push_back({h, end_past_});
  }
  tried.good = true;
  return tried;
}

// Makes a step of h, or as much shorter as its error asks for, and says how long the next one should be.
// Returns its length; 0 where there is none, and the report says why.
double HighOrderStepper::good_step(double h, double longest, StepReport& report) {
  const double wanted = h;
  bool shortened = false;
  for (;;) {
    const double tried = std::min(h, longest);
    const Attempt made = attempt(tried, 1.0, report);
    const double factor =
        made.status == StepStatus::done
            ? std::clamp(safety / eighth_root(std::max(made.error, 1e-30)), least_factor, most_factor)
            : least_factor;
    if (made.good) {
      const double next = std::min(longest_step, tried * (shortened ? std::min(1.0, factor) : factor));
      // A step that was cut short says nothing against the length it was to have.
      state_.own_steps.next = tried < h ? std::max(next, wanted) : next;
      return tried;
    }
    shortened = true;
    h = tried * factor;
    if (h < std::max(shortest_step, 16.0 * std::numeric_limits<double>::epsilon() * std::abs(state_.time))) {
      report.status = made.status == StepStatus::done ? StepStatus::not_converged : made.status;
      report.worst_link = equations_->worst_link();
      return 0.0;
    }
  }
}

StepReport HighOrderStepper::step(double h, double end_time) {
  StepReport report;
  breaking_.clear();
  if (!begun_) {
    if (!all_finite(state_)) {
      report.status = StepStatus::not_finite;
      return report;
    }
    const State given = state_;
    if (!begin(report)) {
      state_ = given;
      return report;
    }
  }
  if (past_ > 0.0) {
    breaking_ = watch_.breaking(state_.position, *equations_);
    if (!breaking_.empty()) return report;  // at once
    past_ = 0.0;                            // a stop that was just left
  }
  goal_ = end_time;
  longest_ = h;
  if (const auto kink = std::ranges::upper_bound(kinks_, state_.time);
      kink != kinks_.end() && *kink < goal_) {
    goal_ = *kink;
    longest_ = goal_ - state_.time;
  }
  const double wanted = state_.own_steps.next;
  double made = good_step(wanted, longest_, report);
  if (made == 0.0) return report;
  const double next = state_.own_steps.next;
  bool event = false;
  if (!watch_.none() && may_have_passed()) {
    Bracket bracket{};
    const bool passed = find_bracket(made, report, bracket);
    if (report.status != StepStatus::done) return report;
    if (passed) {
      made = step_to_event(bracket, made, report);
      if (report.status != StepStatus::done) return report;
      event = end_past_ > 0.0;
    }
  }
  state_.own_steps.next = next;
  if (!event) {
    take_over(made);
    return report;
  }
  const State given = state_;
  take_over(made);
  pass_event(report);
  if (report.status != StepStatus::done) load(given);
  return report;
}

void HighOrderStepper::take_over(double h) {
  last_.equations = equations_;
  last_.held = state_.own_steps.held;
  last_.begin = state_.time;
  last_.end = time_after(h);
  last_.end_is_kept = false;
  last_.interpolant = false;
  runge_kutta_.keep_start(state_.position, state_.velocity, acceleration_);
  std::swap(state_.position, end_.position);
  std::swap(state_.velocity, end_.velocity);
  std::swap(state_.tension, end_tension_);
  std::swap(acceleration_, end_acceleration_);
  past_ = end_past_;
  state_.time = last_.end;
}

// To be called before the state becomes something else than the end of the last step.
void HighOrderStepper::keep_end() {
  if (!last_.equations || last_.end_is_kept) return;
  last_.end_is_kept = true;
  last_.phase.position = state_.position;
  last_.phase.velocity = state_.velocity;
  last_.acceleration = acceleration_;
}

// What happens at an event: links are told of, and left to the run; stops are settled anew.
void HighOrderStepper::pass_event(StepReport& report) {
  breaking_ = watch_.breaking(state_.position, *equations_);
  if (!breaking_.empty()) return;
  crowded_ = state_.time - last_event_ < crowd ? crowded_ + 1 : 0;
  last_event_ = state_.time;
  keep_end();
  if (crowded_ > most_crowded) {
    report.status = StepStatus::chattering;
    return;
  }
  if (!equations_->settle(state_.time, state_.position, crowded_ < a_crowd ? slow : slow_in_a_crowd,
                          state_.velocity, state_.own_steps.held)) {
    report.status = StepStatus::not_converged;
    return;
  }
  look_again(report);
}

bool HighOrderStepper::prepare_last_interpolant() {
  Equations& equations = *last_.equations;
  return last_.end_is_kept
             ? runge_kutta_.prepare_interpolant(equations, last_.phase.position, last_.phase.velocity,
                                                last_.acceleration)
             : runge_kutta_.prepare_interpolant(equations, state_.position, state_.velocity, acceleration_);
}

State HighOrderStepper::between(double time) {
  State state = state_;
  state.time = time;
  for (double& broken_at : state.broken_at)
    if (broken_at > time) broken_at = infinity;
  Equations& equations = *last_.equations;
  equations.hold(last_.held);
  if (!last_.interpolant) last_.interpolant = prepare_last_interpolant();
  runge_kutta_.between((time - last_.begin) / (last_.end - last_.begin), between_);
  state.position = between_.position;
  state.velocity = between_.velocity;
  if (last_.interpolant && equations.project(between_.position, between_.velocity) &&
      equations.evaluate(time, between_.position, between_.velocity, between_acceleration_)) {
    state.position = between_.position;
    state.velocity = between_.velocity;
    equations.write_tensions(state.tension);
  }
  if (equations_) equations_->hold(state_.own_steps.held);
  return state;
}

}  // namespace taut
