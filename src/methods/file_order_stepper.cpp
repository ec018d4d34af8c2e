#include "file_order_stepper.h"

#include <cmath>
#include <utility>

namespace taut {

void FileOrderStepper::load(const State& state) {
  if (state.broken_at != state_.broken_at) links_changed_ = true;
  state_ = state;
}

StepReport FileOrderStepper::step(double h, double end_time) {
  if (std::exchange(links_changed_, false)) links_changed(state_);
  return make_step(state_, h, end_time);
}

void SwappingStepper::copy_to_work(const State& state) {
  begin_work(state);
  position_ = state.position;
  velocity_ = state.velocity;
}

void SwappingStepper::begin_work(const State& state) {
  position_.resize(state.position.size());
  velocity_.resize(state.velocity.size());
  tension_ = state.tension;
  kick_before_ = state.unanswered_kick;
  tension_before_ = state.tension_before;
  joints_before_ = state.static_friction.joints;
}

void SwappingStepper::take_over(State& state, double end_time, StepReport& report) {
  if (!std::isfinite(end_time) || !all_finite(position_) || !all_finite(velocity_)) {
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
  state_.time = time_before_;
  state_.unanswered_kick = kick_before_;
  state_.tension_before = tension_before_;
  state_.static_friction.joints = joints_before_;
}

}  // namespace taut
