// Semi-implicit Euler with links set in place, the scheme that this program began with, as its text describes
// it.
//
//   v ← v + h a            gravity and loads; drag implicit
//   x ← x + h v
//   then, `passes` times, for each link (a, b) of length l in the file's order, d = x_a − x_b:
//     |d| > l·break_stretch   → the link is destroyed
//     both free               → x_a ← m + (l/2) d/|d|,  x_b ← m − (l/2) d/|d|,  m = (x_a + x_b)/2
//     b pinned                → x_a ← x_b + l d/|d|     (and the other way round)
//
// (The text compares the other way round, l·threshold > |d|, which would destroy every slack link at once.)
// Positions are overridden whatever the masses weigh, so momentum is not conserved between unequal ones; and
// velocities are left alone (velocities = "kept"), so gravity goes on adding speed to masses that hang still
// and no refinement of h or of the passes converges. velocities = "derived" takes v = Δx/h instead, and comes
// to rest.

#include <array>
#include <cmath>

#include "contact/ground_contacts.h"
#include "file_order_stepper.h"
#include "forces/forces.h"
#include "methods/method.h"
#include "parameters.h"

namespace taut {
namespace {

class EulerStepper final : public FileOrderStepper {
 public:
  EulerStepper(const Model& model, int passes, bool keep_velocities)
      : model_(model),
        passes_(passes),
        keep_velocities_(keep_velocities),
        links_(links_with_a_free_end(model)),
        ground_(model) {}

 private:
  void links_changed(const State&) override {}

  StepReport make_step(State& state, double h, double end_time) override {
    State& next = next_;
    next = state;
    StepReport report;
    next.time = end_time;
    kick(model_, next.time, h, state.velocity, next.velocity);
    blow(model_, state, state.position, state.velocity, next.time, h, next.velocity);
    drift(h, state.position, next.velocity, next.position);
    place_pins(model_, next.time, next.position, next.velocity);
    for (int pass = 0; pass < passes_; ++pass) relax(next, report);
    if (!ground_.empty()) land(state, next, h);
    if (!keep_velocities_) {
      difference_quotient(h, state.position, next.position, next.velocity);
      place_pins(model_, next.time, next.position, next.velocity);
    }
    if (!all_finite(next)) {
      report.status = StepStatus::not_finite;
      return report;
    }
    report.rounds = passes_;
    std::swap(state, next);
    return report;
  }

  void relax(State& state, StepReport& report) const {
    for (const Index link : links_) {
      if (state.broken(link)) continue;
      const Index a = model_.links.a[link], b = model_.links.b[link];
      const double length = model_.links.length[link];
      const Vec3 x_a = state.position.at(a), x_b = state.position.at(b);
      const Vec3 difference = x_a - x_b;
      const double distance = difference.norm();
      if (distance > length * model_.links.break_stretch[link]) {
        state.broken_at[link] = state.time;
        ++report.breaks;
        continue;
      }
      // Nothing to do, or no direction to do it in; gravity or a neighbour will part the two.
      const double stretch = model_.links.stretch(link, distance);
      if (distance == 0.0 || (stretch == 0.0 && model_.links.one_sided(link))) continue;
      const Vec3 reach =
          difference * ((model_.links.one_sided(link) ? distance - stretch : length) / distance);
      if (model_.masses.pinned(a)) {
        state.position.set(b, x_a - reach);
      } else if (model_.masses.pinned(b)) {
        state.position.set(a, x_b + reach);
      } else {
        const Vec3 middle = 0.5 * (x_a + x_b);
        state.position.set(a, middle + 0.5 * reach);
        state.position.set(b, middle - 0.5 * reach);
      }
      ++report.link_solves;
    }
  }

  // The ground is not in the text: masses in it are put onto it, and what it takes from their way it takes
  // from their velocity too, or kept velocities would grow for ever below it.
  void land(const State& before, State& next, double h) {
    fallen_ = next.position;
    ground_.solve(before.position, next.position);
    for (std::size_t i = 0; i < fallen_.size(); ++i)
      next.velocity.add(i, (next.position.at(i) - fallen_.at(i)) / h);
  }

  const Model& model_;
  int passes_;
  bool keep_velocities_;
  std::vector<Index> links_;
  GroundContacts ground_;
  State next_;      // being made
  Vectors fallen_;  // before the ground held it
};

constexpr std::array<std::string_view, 2> velocity_choices{"kept", "derived"};
constexpr std::array euler_params{
    steps_per_second_param(60.0),
    passes_param(4.0),
    Param{"velocities", "", 0, 0, 0, false, velocity_choices,
          "kept: links leave velocities alone, as the text has it; derived: v = Δx/h"},
};

std::unique_ptr<Stepper> make_euler(const Model& model, const Settings& settings, const Execution&) {
  return std::make_unique<EulerStepper>(model, static_cast<int>(settings.number("passes")),
                                        settings.choice("velocities") == "kept");
}

}  // namespace

Method euler_method() {
  Capabilities can;
  can.keeps = {Keeping::not_kept, Keeping::not_kept, Keeping::not_kept};
  can.limit = StepLimit::kept_velocities;
  can.ground = true;
  can.one_sided = true;
  can.break_stretch = true;
  can.breaks_within_step = true;
  can.tension_order = 0;
  can.between_steps = Interpolation::linear;
  return {"euler",
          "semi-implicit Euler, links set in place (the base line)",
          "Ragdoll and Cloth Physics Simulation",
          euler_params,
          can,
          {4.0, 18.0, 18.0},
          make_euler};
}

}  // namespace taut
