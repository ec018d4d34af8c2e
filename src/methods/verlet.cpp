// Störmer–Verlet with mass-weighted relaxation (Jakobsen, Advanced Character Physics, 2001).
//
// In its own terms the method keeps the current and the previous position instead of a velocity,
//   x_{n+1} = 2 x_n − x_{n−1} + h² a,
// and then moves the ends of each link along it, d = x_a − x_b, until it has its length:
//   x_a ← x_a − w_a s d,  x_b ← x_b + w_b s d,   s = (|d| − l) / ((w_a + w_b) |d|).
// The same sequence of positions is had from position and velocity at the same time by half a kick, the
// drift, the relaxation, v = Δx/h, and half a kick:  x_{n+1} − x_n = (x_n − x_{n−1}) + h (h/2) a + h (h/2) a.
// That is how it stands here, so that a State means the same for every method. The velocity at the end still
// holds the last half kick, which the links have not answered yet: a mass at rest shows h·g/2. Where a stop
// or a solid pushes, more passes may follow (pass_control.h).

#include <array>
#include <cmath>
#include <utility>

#include "contact/joint_resistance.h"
#include "contact/limits_and_contacts.h"
#include "forces/forces.h"
#include "methods/method.h"
#include "parameters.h"
#include "relax/link_order.h"
#include "relax/pass_control.h"

namespace taut {
namespace {

class VerletStepper final : public Stepper {
 public:
  VerletStepper(const Model& model, PassCounts passes)
      : model_(model), passes_(model, passes), beside_(model), joints_(model) {}

  void links_changed(const State& state) override {
    order_ = coloured_order(model_, state);
    passes_.links_changed(order_.links);
  }

  StepReport step(State& state, double h) override {
    start_ = state.position;
    velocity_ = state.velocity;
    const double start_time = state.time, end_time = state.time + h;
    kick(model_, state.time, 0.5 * h, state.velocity, velocity_);
    blow(model_, state, state.position, state.velocity, end_time, h, velocity_);
    joints_.act(state, h, 1.0, velocity_);
    drift(h, start_, velocity_, state.position);
    place_pins(model_, end_time, state.position, velocity_);
    beside_.begin_step(start_, state);
    int made = 0;
    for (; passes_.another(made, beside_.may_jump(), start_, state.position, h); ++made) {
      relax(state.position);
      beside_.solve(h, 1.0, state.position);
    }
    StepReport report;
    report.rounds = made;
    report.link_solves = (static_cast<std::int64_t>(order_.links.size()) + beside_.size()) * made;
    difference_quotient(h, start_, state.position, velocity_);
    beside_.rebound(h, velocity_);
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
    beside_.keep(state);
    joints_.keep(start_, state);
    return report;
  }

 private:
  void relax(Vectors& position) const {
    const Links& links = model_.links;
    const std::vector<double>& inverse_mass = model_.masses.inverse_mass;
    for (const Index link : order_.links) {
      const Index a = links.a[link], b = links.b[link];
      const Vec3 difference = position.at(a) - position.at(b);
      const double distance = difference.norm();
      if (distance == 0.0) continue;  // no direction to move in
      const double scale = (distance - links.length[link]) / ((inverse_mass[a] + inverse_mass[b]) * distance);
      position.add(a, -(inverse_mass[a] * scale) * difference);
      position.add(b, (inverse_mass[b] * scale) * difference);
    }
  }

  const Model& model_;
  PassControl passes_;
  BesideLinks beside_;
  JointResistance joints_;
  OrderedLinks order_;
  Vectors start_, velocity_;
};

constexpr std::array params{steps_per_second_param(600.0), passes_param(1.0), impact_passes_param()};

std::unique_ptr<Stepper> make(const Model& model, const Settings& settings) {
  return std::make_unique<VerletStepper>(model, pass_counts(settings));
}

}  // namespace

Method verlet_method() {
  Capabilities can;
  can.half_kicked = true;
  can.plane = true;
  can.limits = true;
  can.colliders = true;
  can.break_stretch = true;
  return {"verlet",
          "Störmer–Verlet with mass-weighted relaxation",
          "Jakobsen, Advanced Character Physics (2001)",
          params,
          can,
          make};
}

}  // namespace taut
