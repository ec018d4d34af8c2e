// Where in a step something happens: seen from its stages, looked for on its interpolant, and then found by
// steps themselves.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "high_order/stepper.h"

namespace taut {
namespace {

constexpr int looks_between = 8;  // parts of a step whose ends are looked at for events
// A step that is cut short at an event has less of an error than the whole of it, but its estimate may be a
// little larger.
constexpr double error_at_events = 4.0;

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
  return runge_kutta_.prepare_interpolant(*equations_, end_.position, end_.velocity, end_acceleration_);
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

}  // namespace taut
