// Störmer–Verlet with mass-weighted relaxation (Jakobsen, Advanced Character Physics, 2001).
//
// In its own terms the method keeps the current and the previous position instead of a velocity,
//   x_{n+1} = 2 x_n − x_{n−1} + h² a,
// and then moves the ends of each link along it, d = x_a − x_b, until it has its length:
//   x_a ← x_a − w_a s d,  x_b ← x_b + w_b s d,   s = (|d| − l) / ((w_a + w_b) |d|).
// The same sequence of positions is had from position and velocity at the same time by half a kick, the
// drift, the relaxation, v = Δx/h, and half a kick:  x_{n+1} − x_n = (x_n − x_{n−1}) + h (h/2) a + h (h/2) a.
// That is how it stands here, so that a State means the same for every method. The velocity at the end still
// holds the last half kick, which the links have not answered yet: a mass at rest shows h·g/2. The tension is
// Σ s |d| over h (h/2 + that kick): h² but for the first step and where h has changed. Where a stop or a
// solid pushes, more passes may follow (pass_control.h).

#include <array>
#include <utility>

#include "contact/joint_resistance.h"
#include "contact/limits_and_contacts.h"
#include "file_order_stepper.h"
#include "forces/forces.h"
#include "methods/method.h"
#include "parameters.h"
#include "relax/pass_control.h"
#include "relax/relaxation.h"

namespace taut {
namespace {

class VerletStepper final : public FileOrderStepper {
 public:
  VerletStepper(const Model& model, PassCounts passes)
      : model_(model), passes_(model, passes), links_(model), limits_and_contacts_(model), joints_(model) {}

 private:
  void links_changed(const State& state) override {
    links_.links_changed(state);
    passes_.links_changed(links_.links());
  }

  StepReport make_step(State& state, double h, double end_time) override {
    start_ = state.position;
    velocity_ = state.velocity;
    const double start_time = state.time;
    kick(model_, state.time, 0.5 * h, state.velocity, velocity_);
    blow(model_, state, state.position, state.velocity, end_time, h, velocity_);
    joints_.act(state, h, 1.0, velocity_);
    drift(h, start_, velocity_, state.position);
    place_pins(model_, end_time, state.position, velocity_);
    links_.begin_step(h, 1.0, coordinates(std::as_const(start_)), coordinates(std::as_const(state.position)));
    limits_and_contacts_.begin_step(start_, state);
    int made = 0;
    for (; passes_.another(made, limits_and_contacts_.may_jump(), start_, state.position, h); ++made) {
      links_.pass();
      if (limits_and_contacts_.none()) continue;
      links_.give(coordinates(state.position));
      limits_and_contacts_.solve(h, 1.0, state.position);
      links_.take(coordinates(std::as_const(state.position)));
    }
    links_.give(coordinates(state.position));
    StepReport report;
    report.rounds = made;
    report.link_solves = (links_.size() + limits_and_contacts_.size()) * made;
    difference_quotient(h, start_, state.position, velocity_);
    limits_and_contacts_.rebound(h, velocity_);
    kick(model_, end_time, 0.5 * h, velocity_, velocity_);
    place_pins(model_, end_time, state.position, velocity_);
    std::swap(state.velocity, velocity_);
    state.time = end_time;
    if (!all_finite(state)) {
      std::swap(state.position, start_);
      std::swap(state.velocity, velocity_);
      state.time = start_time;
      report.status = StepStatus::not_finite;
      return report;
    }
    limits_and_contacts_.keep(state);
    joints_.keep(start_, state);
    links_.give_multipliers(-1.0 / (h * (state.unanswered_kick + 0.5 * h)), state.tension);
    state.unanswered_kick = 0.5 * h;
    return report;
  }

  const Model& model_;
  PassControl passes_;
  Relaxation<double> links_;
  LimitsAndContacts limits_and_contacts_;
  JointResistance joints_;
  Vectors start_, velocity_;
};

constexpr std::array verlet_params{steps_per_second_param(600.0), passes_param(1.0), impact_passes_param()};

std::unique_ptr<Stepper> make_verlet(const Model& model, const Settings& settings, const Execution&) {
  return std::make_unique<VerletStepper>(model, pass_counts(settings));
}

}  // namespace

Method verlet_method() {
  Capabilities can;
  can.keeps = {Keeping::kept, Keeping::lost_with_step, Keeping::lost_with_step};
  can.half_kicked = true;
  can.ground = true;
  can.limits = true;
  can.colliders = true;
  can.break_stretch = true;
  can.break_tension = true;
  return {"verlet",
          "Störmer–Verlet with mass-weighted relaxation",
          "Jakobsen, Advanced Character Physics (2001)",
          verlet_params,
          can,
          {5.0, 6.0, 0.0},
          make_verlet};
}

}  // namespace taut
