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
constexpr double safety = 0.9, least_factor = 1.0 / 3.0, most_factor = 6.0;
constexpr int looks_between = 8;  // parts of a step whose ends are looked at for events
// Two stops that push each other open may be met and left ever faster. Where events of stops crowd together
// like that, what leaves slowly is held at rest; where that does not end it, the step fails.
constexpr double crowd = 1e-5;                         // s between two events
constexpr int a_crowd = 6, most_crowded = 60;          // events
constexpr double slow = 1e-9, slow_in_a_crowd = 1e-3;  // rad/s
// A step that is cut short at an event has less of an error than the whole of it, but its estimate may be a
// little larger.
constexpr double error_at_events = 4.0;

// Stages whose positions and tensions are near enough to those of the motion to hint at events.
constexpr std::array<std::size_t, 4> telling_stages{3, 6, 9, 10};

std::vector<double> times_of_kinks(const Model& model) {
  std::vector<double> times;
  for (const Load& load : model.loads) times.insert(times.end(), {load.from, load.to});
  for (const DrivenPin& pin : model.driven_pins)
    if (const auto* path = std::get_if<Path>(&pin.motion))
      for (const Knot& knot : path->knots) times.push_back(knot.time);
  std::ranges::sort(times);
  return times;
}

double largest_norm(const Vectors& vectors) {
  double square = 0.0;
  for (std::size_t i = 0; i < vectors.size(); ++i) square = std::max(square, vectors.at(i).squaredNorm());
  return std::sqrt(square);
}

// The place and height of the top of the parabola through three samples, where the middle one is the highest.
template <class Sample>
Sample top_of(const Sample& a, const Sample& b, const Sample& c) {
  const double left = (b.past - a.past) / (b.h - a.h), right = (c.past - b.past) / (c.h - b.h);
  const double curvature = (right - left) / (c.h - a.h);
  if (!(curvature < 0.0)) return b;
  const double top = 0.5 * (a.h + b.h) - 0.5 * left / curvature;
  return {top, b.past + (top - b.h) * (left + curvature * (top - a.h))};
}

}  // namespace

HighOrderStepper::HighOrderStepper(const Model& model, double tolerance)
    : model_(model),
      tolerance_(tolerance),
      kinks_(times_of_kinks(model)),
      watch_(model),
      runge_kutta_(model) {}

void HighOrderStepper::load(const State& state) {
  if (!equations_ || state.broken_at != state_.broken_at)
    equations_ = std::make_shared<Equations>(model_, state);
  state_ = state;
  begun_ = false;
}

// Brings a state that comes from elsewhere to where it belongs: on its links and stops.
bool HighOrderStepper::begin(StepReport& report) {
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
  return std::min(longest_step,
                  std::sqrt(length / pull) * std::pow(std::min(1.0, tolerance_ / length), 0.125));
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
  const auto look = [&](std::size_t stage, const Vectors& position) {
    if (!watch_.none() && std::ranges::find(telling_stages, stage) != telling_stages.end())
      samples_.push_back({dop853::nodes[stage] * h, watch_.past(position, *equations_)});
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
  tried.error = runge_kutta_.error(tolerance_, velocity_weight * tolerance_);
  if (!std::isfinite(tried.error)) tried.status = StepStatus::not_finite;
  tried.good = tried.error <= most_error;
  if (!tried.good) return tried;
  tried.good = false;
  const double end_time = time_after(h);
  runge_kutta_.end(end_);
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
            ? std::clamp(safety * std::pow(std::max(made.error, 1e-30), -0.125), least_factor, most_factor)
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
  take_over(made);
  if (event) pass_event(report);
  return report;
}

// Whether something is past at one of the moments looked at, or may be between them.
bool HighOrderStepper::may_have_passed() const {
  double least = infinity, most = -infinity;
  for (const Sample& sample : samples_) {
    if (sample.past > 0.0) return true;
    least = std::min(least, sample.past);
    most = std::max(most, sample.past);
  }
  const double near = 0.1 * (most - least);
  for (std::size_t i = 1; i + 1 < samples_.size(); ++i) {
    const Sample &a = samples_[i - 1], &b = samples_[i], &c = samples_[i + 1];
    if (b.past >= a.past && b.past >= c.past && top_of(a, b, c).past > -near) return true;
  }
  return false;
}

bool HighOrderStepper::prepare_interpolant(StepReport& report) {
  report.link_solves += static_cast<std::int64_t>(3 * equations_->rows());
  return runge_kutta_.prepare_interpolant(*equations_, end_, end_acceleration_);
}

// What is past at a share of the step in hand.
double HighOrderStepper::past_between(double share, StepReport& report) {
  runge_kutta_.between(share, between_);
  const double time = state_.time + share * (time_after(samples_.back().h) - state_.time);
  report.link_solves += static_cast<std::int64_t>(2 * equations_->rows());
  if (!equations_->project(between_.position, between_.velocity) ||
      !equations_->evaluate(time, between_.position, between_.velocity, between_acceleration_))
    return -infinity;
  return watch_.past(between_.position, *equations_);
}

// Where on the interpolant something is past for the first time; false where nothing is.
bool HighOrderStepper::find_bracket(double h, StepReport& report, Bracket& bracket) {
  if (!prepare_interpolant(report)) {
    report.status = StepStatus::factorisation_failed;
    return false;
  }
  std::vector<Sample> looks{{0.0, past_}};
  for (int i = 1; i <= looks_between; ++i) {
    const double share = static_cast<double>(i) / looks_between;
    const double past = i == looks_between ? end_past_ : past_between(share, report);
    looks.push_back({share * h, past});
    const Sample* before = &looks[looks.size() - 2];
    if (looks.size() > 2 && looks[looks.size() - 3].past <= before->past && before->past >= past &&
        !(past > 0.0)) {
      const Sample top = top_of(looks[looks.size() - 3], *before, looks.back());
      const double at_top = past_between(top.h / h, report);
      if (at_top > 0.0) {
        bracket = {looks[looks.size() - 3].h, top.h};
        return true;
      }
    }
    if (past > 0.0) {
      bracket = {before->h, looks.back().h};
      return true;
    }
  }
  return false;
}

// Makes the step as far as the event: the shortest of the steps found that is past it. What is past at the
// end of a step is zero where the event is, by its length: false position, and halving where that is slow.
// Returns its length. The bracket is the interpolant's; where steps themselves see nothing past
// at its end, that is as far as it goes.
double HighOrderStepper::step_to_event(Bracket bracket, double h, StepReport& report) {
  double at = bracket.high;
  const auto past_after = [&](double length) {
    at = length;
    if (!attempt(length, error_at_events, report).good) report.status = StepStatus::not_converged;
    return end_past_;
  };
  double high = bracket.high, low = bracket.low;
  double past_high = high == h ? end_past_ : past_after(high);
  if (report.status != StepStatus::done || !(past_high > 0.0)) return at;
  double past_low = low > 0.0 ? past_after(low) : past_;
  if (report.status != StepStatus::done) return at;
  if (low > 0.0 && past_low > 0.0) {
    high = low;
    past_high = past_low;
    low = 0.0;
    past_low = past_;
  }
  const double width = 4.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(state_.time), h);
  double guess = 0.5 * (low + high);
  while (high - low > width) {
    const double before = high - low;
    double middle = 0.5 * (low + high);
    if (past_low < 0.0 && std::isfinite(past_low)) {
      const double last = std::exchange(guess, low - past_low * before / (past_high - past_low));
      // A little further than the guess, from the nearer end: to have the event between the two.
      const double beyond = std::max(0.5 * width, 0.01 * std::abs(guess - last));
      middle = std::clamp(guess - low < high - guess ? guess + beyond : guess - beyond, low + 0.25 * width,
                          high - 0.25 * width);
    }
    for (int tries = 0; tries < 2; ++tries) {
      const double past = past_after(middle);
      if (report.status != StepStatus::done) return at;
      (past > 0.0 ? high : low) = middle;
      (past > 0.0 ? past_high : past_low) = past;
      if (high - low <= std::max(width, 0.5 * before)) break;
      middle = 0.5 * (low + high);
    }
  }
  if (at != high) past_after(high);
  return at;
}

void HighOrderStepper::take_over(double h) {
  last_.equations = equations_;
  last_.held = state_.own_steps.held;
  last_.begin = state_.time;
  last_.end = time_after(h);
  last_.phase = end_;
  last_.acceleration = end_acceleration_;
  last_.interpolant = false;
  std::swap(state_.position, end_.position);
  std::swap(state_.velocity, end_.velocity);
  std::swap(state_.tension, end_tension_);
  std::swap(acceleration_, end_acceleration_);
  past_ = end_past_;
  state_.time = last_.end;
}

// What happens at an event: links are told of, and left to the run; stops are settled anew.
bool HighOrderStepper::pass_event(StepReport& report) {
  breaking_ = watch_.breaking(state_.position, *equations_);
  if (!breaking_.empty()) return true;
  crowded_ = state_.time - last_event_ < crowd ? crowded_ + 1 : 0;
  last_event_ = state_.time;
  if (crowded_ > most_crowded) {
    report.status = StepStatus::chattering;
    return false;
  }
  if (!equations_->settle(state_.time, state_.position, crowded_ < a_crowd ? slow : slow_in_a_crowd,
                          state_.velocity, state_.own_steps.held)) {
    report.status = StepStatus::not_converged;
    return false;
  }
  return look_again(report);
}

State HighOrderStepper::between(double time) {
  State state = state_;
  state.time = time;
  for (double& broken_at : state.broken_at)
    if (broken_at > time) broken_at = infinity;
  Equations& equations = *last_.equations;
  equations.hold(last_.held);
  if (!last_.interpolant)
    last_.interpolant = runge_kutta_.prepare_interpolant(equations, last_.phase, last_.acceleration);
  runge_kutta_.between((time - last_.begin) / (last_.end - last_.begin), between_);
  state.position = between_.position;
  state.velocity = between_.velocity;
  if (last_.interpolant && equations.project(between_.position, between_.velocity) &&
      equations.evaluate(time, between_.position, between_.velocity, between_acceleration_)) {
    state.position = between_.position;
    state.velocity = between_.velocity;
    equations.write_tensions(state.tension);
  }
  equations_->hold(state_.own_steps.held);
  return state;
}

}  // namespace taut
