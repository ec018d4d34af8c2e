// SHAKE by Gauss–Seidel passes (Ryckaert, Ciccotti and Berendsen, Numerical integration of the Cartesian
// equations of motion of a system with constraints, 1977): Verlet with relaxation along the link directions
// of the start of the step.
//
//   v½ = v + (h/2) a(x),  x₁ = x + h v½        gravity, loads, drag, wind, and links with stiffness as forces
//   `passes` times, for each rigid link, d = x_a − x_b, d₀ the same at the start of the step:
//     q = (|d|² − l²) / (2 (w_a + w_b) d·d₀),  x_a ← x_a − w_a q d₀,  x_b ← x_b + w_b q d₀
//   v ← (x₁ − x)/h + (h/2) a(x₁)
//
// Limits on angles follow the links in every pass, along their gradients at the start of the step; where one
// pushes, more passes may follow (pass_control.h).
//
// That one change of direction makes the relaxation of second order: one pass per small step is within 5e-4 m
// on a 2 m chain where relaxation along the new direction is at 1e-2 m for the same price. It shares RATTLE's
// limit, h below about √(m l/T). The velocity at the end still holds the last half kick, as with verlet.
// Damping and wind, which depend on velocity, meet one without it: the links' answer to that half kick is
// half a step of their tension.
//
// Tension: (1 + drag h/2) Σ q l/h² is the tension Tₙ at the start of the step, by x_{n+1} − 2 xₙ + x_{n−1}
// = h² a, to second order. Its end has 2 Tₙ − T_{n−1}; and where there is no T_{n−1}, or the step is not as
// long as the last one, the Σ q of another step from there, which is not made.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/vector_operations.h"
#include "contact/joint_resistance.h"
#include "file_order_stepper.h"
#include "forces/forces.h"
#include "forces/half_kicks.h"
#include "methods/breaking.h"
#include "methods/method.h"
#include "parameters.h"
#include "relax/along_relaxation.h"
#include "relax/limit_solver.h"
#include "relax/packed_shake.h"
#include "relax/packed_stepper.h"
#include "relax/pass_control.h"

namespace taut {
namespace {

class ShakeStepper final : public SwappingStepper {
 public:
  ShakeStepper(const Model& model, PassCounts passes, double tolerance, const Execution& execution)
      : model_(model),
        passes_(model, passes),
        relaxation_(model, execution),
        tolerance_(tolerance),
        kicks_(model, 2.0),
        limits_(model),
        joints_(model) {}

 private:
  void links_changed(const State& state) override {
    relaxation_.links_changed(state);
    packed_ = packed_start_ = relaxation_.places().room();
    passes_.links_changed(relaxation_.links());
    kicks_.links_changed(state);
    limits_.links_changed(state);
  }

  StepReport make_step(State& state, double h, double end_time) override {
    const double half = 0.5 * h;
    // Only then is Tₙ of second order.
    const bool as_last = state.unanswered_kick == half;
    StepReport report;
    begin_work(state);
    if (!move(state, h, end_time, report)) return report;
    put_start_tensions(h, state.unanswered_kick, tension_);
    start_tension_ = tension_;

    difference_quotient(h, state.position, position_, velocity_);
    place_pins(model_, end_time, position_, velocity_);
    const bool continued = as_last && !state.tension_before.empty();
    if (continued) {
      all_of(tension_) = 2.0 * all_of(start_tension_) - all_of(state.tension_before);
      limits_.keep_to_their_side(tension_);
    }
    kicks_.end(state, end_time, half, position_, kicked_, velocity_, tension_);
    take_over(state, end_time, report);
    if (report.status != StepStatus::done) return report;
    joints_.keep(position_, state);  // where the step began
    state.unanswered_kick = half;
    if (!continued && relaxation_.size() > 0) probe_tensions(state, h, report);
    if (as_last)
      std::swap(state.tension_before, start_tension_);
    else
      state.tension_before.clear();
    return report;
  }

  // Positions at the end of a step, in position_, with the velocities on the way in kicked_ and what links
  // did in the multipliers.
  bool move(const State& state, double h, double end_time, StepReport& report) {
    if (kicks_.meet_velocity()) {
      met_velocity_ = state.velocity;
      answer_kick(model_, state, met_velocity_);
    }
    kicks_.start(state, state.time, 0.5 * h, state.position, state.velocity,
                 kicks_.meet_velocity() ? met_velocity_ : state.velocity, kicked_);
    joints_.act(state, h, 1.0, kicked_);
    drift(h, state.position, kicked_, position_);
    place_pins(model_, end_time, position_, velocity_);
    report.link_solves += kicks_.solves();
    limits_.begin_step();
    return relax(state.position, h, report);
  }

  // What the multipliers say of the start of a step of h seconds that has also answered the kick before it.
  void put_start_tensions(double h, double kick_before, std::vector<double>& tension) const {
    const double scale = (1.0 + 0.5 * h * model_.drag) / (h * (0.5 * h + kick_before));
    relaxation_.give_multipliers_along(scale, tension);
    limits_.give_tensions(-scale, tension);
  }

  void probe_tensions(State& state, double h, StepReport& report) {
    // For what it does to velocities that forces meet, the tension at the start of the step is good enough.
    StepReport probe;
    Vectors before = std::exchange(position_, state.position),
            velocity_before = std::exchange(velocity_, state.velocity);
    if (move(state, h, state.time + h, probe)) put_start_tensions(h, state.unanswered_kick, state.tension);
    position_ = std::move(before);  // what undo() needs
    velocity_ = std::move(velocity_before);
    report.link_solves += probe.link_solves;
  }

  bool relax(const Vectors& start, double h, StepReport& report) {
    relaxation_.begin_step(1.0, 1.0);
    relaxation_.places().load(start, packed_start_);
    relaxation_.places().load(position_, packed_);
    const bool judged = tolerance_ > 0.0;
    for (int made = 0; passes_.another(made, limits_.pushed(), start, position_, h); ++made) {
      const AlongStart found = relaxation_.pass_along(packed_start_, packed_, {made == 0, false}, judged);
      if (found.lost()) {
        report.status = std::isfinite(found.lost_along) ? StepStatus::direction_lost : StepStatus::not_finite;
        report.worst_link = found.lost_link;
        return false;
      }
      if (limits_.size() > 0) {
        relaxation_.places().give(packed_, position_);
        limits_.solve_along(start, position_, h, 1.0);
        relaxation_.places().load(position_, packed_);
      }
      ++report.rounds;
      report.link_solves += relaxation_.size() + limits_.size();
      if (judged && found.worst <= tolerance_) break;
    }
    relaxation_.places().give(packed_, position_);
    return true;
  }

  const Model& model_;
  PassControl passes_;
  AlongRelaxation relaxation_;
  AlongRelaxation::Masses packed_start_, packed_;
  double tolerance_;
  HalfKicks kicks_;
  LimitSolver limits_;
  JointResistance joints_;
  Vectors kicked_, met_velocity_;
  std::vector<double> start_tension_;
};

constexpr std::array shake_params{
    steps_per_second_param(2400.0),
    passes_param(1.0),
    impact_passes_param(),
    Param{"tolerance",
          "",
          0.0,
          0.0,
          1.0,
          false,
          {},
          "passes end early once every squared length was within this share of its own"},
};

std::unique_ptr<Stepper> make_shake(const Model& model, const Settings& settings,
                                    const Execution& execution) {
  const PassCounts passes = pass_counts(settings);
  const double tolerance = settings.number("tolerance");
  const std::vector<Index> links = solvable_links(model);
  if (only_links(model) && tolerance == 0.0 &&
      std::ranges::all_of(links, [&](Index link) { return model.links.rigid(link); }))
    return make_packed_shake(model, passes.ordinary, execution);
  return std::make_unique<ShakeStepper>(model, passes, tolerance, execution);
}

std::string shake_refusal(const Model& model, const State& start, const Settings& settings) {
  return too_stiff(model, start, settings);
}

}  // namespace

Method shake_method() {
  Capabilities can;
  can.family = Family::stormer_verlet;
  can.half_kicked = true;
  can.takes_steps_back = true;
  can.limit = StepLimit::sideways_vibration;
  can.stiffness = true;
  can.limits = true;
  can.one_sided = true;
  can.bending = true;
  can.joints = true;
  can.break_stretch = true;
  can.break_tension = true;
  can.tension_order = 2;
  return {"shake",
          "relaxation along the directions of the start of the step, second order",
          "Ryckaert, Ciccotti and Berendsen (1977)",
          shake_params,
          can,
          {4.0, 2.5, 2.5},
          make_shake,
          shake_refusal};
}

}  // namespace taut
