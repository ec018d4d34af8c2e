#include "file_order_stepper.h"

#include <cmath>
#include <utility>

namespace taut {

void FileOrderStepper::load(const State& state) {
  if (state.broken_at != state_.broken_at) links_changed_ = true;
  state_ = state;
  energy_.reset();
  goes_on_ = false;
}

StepReport FileOrderStepper::step(double h, double end_time) {
  if (std::exchange(links_changed_, false)) links_changed(state_);
  energy_.reset();
  const StepReport report = make_step(state_, h, end_time);
  goes_on_ = report.status == StepStatus::done;
  if (!goes_on_) energy_.reset();
  return report;
}

void SwappingStepper::copy_to_work(const State& state) {
  begin_work(state);
  position_ = state.position;
  velocity_ = state.velocity;
}

void SwappingStepper::begin_work(const State& state, bool sets_tensions) {
  position_.resize(state.position.size());
  velocity_.resize(state.velocity.size());
  if (sets_tensions)
    tension_.resize(state.tension.size());
  else
    tension_ = state.tension;
  kick_before_ = state.unanswered_kick;
  tension_before_ = state.tension_before;
  joints_before_ = state.static_friction.joints;
}

void SwappingStepper::take_over(State& state, double end_time, StepReport& report) {
  const bool finite =
      std::isfinite(energy_.value_or(infinity)) || (all_finite(position_) && all_finite(velocity_));
  if (!std::isfinite(end_time) || !finite) {
    report.status = StepStatus::not_finite;
    return;
  }
  std::swap(state.position, position_);
  std::swap(state.velocity, velocity_);
  std::swap(state.tension, tension_);
  time_before_ = state.time;
  state.time = end_time;
}

void SwappingStepper::undo() {
  std::swap(state_.position, position_);
  std::swap(state_.velocity, velocity_);
  std::swap(state_.tension, tension_);
  energy_.reset();
  goes_on_ = false;
  state_.time = time_before_;
  state_.unanswered_kick = kick_before_;
  state_.tension_before = tension_before_;
  state_.static_friction.joints = joints_before_;
}

}  // namespace taut
