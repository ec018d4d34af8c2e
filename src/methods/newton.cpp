// One implicit solve of all links together per step:
//
//   v ← v + h a,  x ← x + h v                            gravity and loads; drag implicit
//   x ← where the links allow, and with what pulls       chains and trees: fast_projection.cpp; nets, and all
//                                                        that resists bending: implicit_net.cpp
//   v ← Δx/h
//
// First order in time and losing energy as h, but at home with any stiffness and any ratio of masses. In a
// chain or a tree every pull follows from the masses beyond it, and Newton's method on the multipliers alone,
// one O(n) elimination a round, takes the longest steps. In a net pulls depend on each other, and only a true
// balance of forces at the end of the step comes to rest. With limits on angles a net is projected, too, and
// bends, which are forces to be balanced, are refused.

#include <array>
#include <optional>

#include "contact/joint_resistance.h"
#include "direct/fast_projection.h"
#include "direct/implicit_net.h"
#include "direct/link_topology.h"
#include "direct/solve_memory.h"
#include "file_order_stepper.h"
#include "forces/forces.h"
#include "methods/method.h"
#include "parameters.h"

namespace taut {
namespace {

class NewtonStepper final : public SwappingStepper {
 public:
  NewtonStepper(const Model& model, double steps_per_second)
      : model_(model), nominal_step_(1.0 / steps_per_second), joints_(model) {}

 private:
  void links_changed(const State& state) override {
    std::vector<Index> whole;
    for (const Index link : solvable_links(model_))
      if (!state.broken(link)) whole.push_back(link);
    projection_.reset();
    net_.reset();
    const bool open = model_.bends.empty() && (path_order(model_, whole) || tree_order(model_, whole));
    if (!model_.limits.empty() || open)
      projection_.emplace(model_, make_link_system(model_, whole), state);
    else
      net_.emplace(model_, whole, whole_bends(model_, state), nominal_step_);
  }

  StepReport make_step(State& state, double h, double end_time) override {
    const bool in_blocks = projection_ && projection_->blocks().several();
    begin_work(state, in_blocks);
    const auto fall = [&](Extent masses) { fall_freely(state, h, end_time, masses); };
    StepReport report;
    if (projection_) {
      if (!projection_->solve(state.position, h, fall, position_, tension_, report)) return report;
    } else {
      fall({0, position_.size()});
      if (!net_->solve(state.position, h, position_, tension_, report)) return report;
    }
    if (in_blocks) {
      energy_ = 0.0;
      projection_->blocks().visit_masses([&](Extent masses) {
        difference_quotient(h, state.position, position_, velocity_, masses);
        *energy_ += energy_of_some(model_, position_, velocity_, masses);
      });
    } else {
      difference_quotient(h, state.position, position_, velocity_);
      place_pins(model_, end_time, position_, velocity_);
    }
    take_over(state, end_time, report);
    if (report.status == StepStatus::done) joints_.keep(position_, state);
    return report;
  }

  // Where masses would be without links.
  void fall_freely(const State& state, double h, double end_time, Extent masses) {
    if (!model_.wind && model_.joints.empty()) {
      kick_and_drift(model_, end_time, h, h, state.position, state.velocity, velocity_, position_,
                     DragAt::end, masses);
    } else {
      kick(model_, end_time, h, state.velocity, velocity_);
      blow(model_, state, state.position, state.velocity, end_time, h, velocity_);
      joints_.act(state, h, 1.0, velocity_);
      drift(h, state.position, velocity_, position_);
    }
    place_pins(model_, end_time, position_, velocity_);
  }

  const Model& model_;
  double nominal_step_;  // s
  JointResistance joints_;
  std::optional<FastProjection> projection_;  // for chains, trees, and whatever has limits …
  std::optional<ImplicitNet> net_;            // … or this one for nets and bends
};

constexpr std::array newton_params{steps_per_second_param(240.0)};

std::unique_ptr<Stepper> make_newton(const Model& model, const Settings& settings, const Execution&) {
  return std::make_unique<NewtonStepper>(model, settings.steps_per_second());
}

std::string newton_refusal(const Model& model, const State&, const Settings&) {
  if (model.bends.empty() || model.limits.empty()) return {};
  return "method newton solves bending stiffness only where there are no limits on angles and no links that "
         "only pull or only push: use xpbd for this scene, or leave one of the two out";
}

double newton_memory(const Model& model) {
  constexpr double bytes_with_bends = 450.0;
  return model.bends.empty() ? bytes_of_links_factor(model) : bytes_of_masses_factor(model, bytes_with_bends);
}

}  // namespace

Method newton_method() {
  Capabilities can;
  can.family = Family::implicit;
  can.takes_steps_back = true;
  can.keeps = {Keeping::kept, Keeping::lost_with_step, Keeping::lost_with_step};
  can.stiffness = true;
  can.limits = true;
  can.one_sided = true;
  can.most_limits = most_limits_solved_together;
  can.bending = true;
  can.joints = true;
  can.break_stretch = true;
  can.break_tension = true;
  return {"newton",
          "one implicit solve of all links together per step, by Newton's method",
          "Goldenthal et al. (2007); Deul et al. (2018)",
          newton_params,
          can,
          {8.0, 8.5, 30.0, 4.0},
          make_newton,
          newton_refusal,
          newton_memory};
}

}  // namespace taut
