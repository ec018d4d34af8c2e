#include "relax/relaxation_stepper.h"

#include <utility>

#include "contact/joint_resistance.h"
#include "contact/limits_and_contacts.h"
#include "file_order_stepper.h"
#include "forces/forces.h"
#include "relax/line_relaxation.h"
#include "relax/packed_stepper.h"
#include "relax/pass_control.h"
#include "relax/relaxation.h"

namespace taut {
namespace {

template <class LinkRelaxation>
class RelaxationStepper final : public FileOrderStepper {
  using Real = typename LinkRelaxation::Number;

 public:
  RelaxationStepper(const Model& model, PassCounts passes, Kicks kicks, const Execution& execution)
      : model_(model),
        kicks_(kicks),
        passes_(model, passes),
        links_(model, execution),
        limits_and_contacts_(model, execution),
        joints_(model) {}

 private:
  void links_changed(const State& state) override {
    links_.links_changed(state);
    passes_.links_changed(links_.links());
    limits_and_contacts_.links_changed(state);
    packed_start_ = packed_ = links_.places().room();
  }

  StepReport make_step(State& state, double h, double end_time) override {
    const double start_time = state.time;
    const bool whole = kicks_ == Kicks::whole;
    start_ = state.position;
    velocity_ = state.velocity;
    if (whole)
      kick(model_, end_time, h, state.velocity, velocity_);
    else
      kick(model_, start_time, 0.5 * h, state.velocity, velocity_);
    blow(model_, state, state.position, state.velocity, end_time, h, velocity_);
    joints_.act(state, h, 1.0, velocity_);
    drift(h, start_, velocity_, state.position);
    place_pins(model_, end_time, state.position, velocity_);
    StepReport report;
    const bool kept_apart = relax(h, end_time, whole ? 1.0 / (1.0 + h * model_.drag) : 1.0, state, report);
    difference_quotient(h, start_, state.position, velocity_);
    limits_and_contacts_.rebound(h, state.position, velocity_);
    if (!whole) kick(model_, end_time, 0.5 * h, velocity_, velocity_);
    place_pins(model_, end_time, state.position, velocity_);
    std::swap(state.velocity, velocity_);
    state.time = end_time;
    const bool crowded = limits_and_contacts_.crowded();
    if (crowded || !kept_apart || !all_finite(state)) {
      std::swap(state.position, start_);
      std::swap(state.velocity, velocity_);
      state.time = start_time;
      packed_ = packed_start_;  // what is filled up with masses that no step moves may be no number
      report.status = crowded      ? StepStatus::crowded
                      : kept_apart ? StepStatus::not_finite
                                   : StepStatus::pressed_through;
      return report;
    }
    limits_and_contacts_.keep(state);
    joints_.keep(start_, state);
    report.contact_work = limits_and_contacts_.contact_work(h);
    const double scale = -1.0 / (h * (whole ? h : state.unanswered_kick + 0.5 * h));
    links_.give_multipliers(scale, state.tension);
    limits_and_contacts_.give_tensions(scale, state.tension);
    if (!whole) state.unanswered_kick = 0.5 * h;
    return report;
  }

  // Whether faces could be kept from passing through each other.
  bool relax(double h, double end_time, double answer, State& state, StepReport& report) {
    links_.begin_step(static_cast<Real>(h), static_cast<Real>(answer));
    links_.places().load(start_, packed_start_);
    links_.places().load(state.position, packed_);
    limits_and_contacts_.begin_step(start_, state, end_time);
    int made = 0;
    for (; passes_.another(made, limits_and_contacts_.may_jump(), start_, state.position, h); ++made) {
      links_.pass(packed_start_, packed_, {made == 0, false});
      if (limits_and_contacts_.none()) continue;
      links_.places().give(packed_, state.position);
      limits_and_contacts_.solve(h, answer, state.position);
      links_.places().load(state.position, packed_);
    }
    links_.places().give(packed_, state.position);
    report.rounds = made;
    report.link_solves = (links_.size() + limits_and_contacts_.size()) * made;
    return limits_and_contacts_.finish(state.position);
  }

  const Model& model_;
  Kicks kicks_;
  PassControl passes_;
  LinkRelaxation links_;
  LimitsAndContacts limits_and_contacts_;
  JointResistance joints_;
  Vectors start_, velocity_;
  typename LinkRelaxation::Masses packed_start_, packed_;
};

template <class LinkRelaxation>
std::unique_ptr<Stepper> make(const Model& model, PassCounts passes, Kicks kicks,
                              const Execution& execution) {
  if (only_links(model)) return make_packed_stepper<LinkRelaxation>(model, passes.ordinary, kicks, execution);
  return std::make_unique<RelaxationStepper<LinkRelaxation>>(model, passes, kicks, execution);
}

}  // namespace

std::unique_ptr<Stepper> make_relaxation_stepper(const Model& model, PassCounts passes, Kicks kicks,
                                                 const Execution& execution) {
  return make<Relaxation<double>>(model, passes, kicks, execution);
}

std::unique_ptr<Stepper> make_line_relaxation_stepper(const Model& model, PassCounts passes, Kicks kicks,
                                                      const Execution& execution) {
  return make<LineRelaxation>(model, passes, kicks, execution);
}

std::unique_ptr<Stepper> make_single_relaxation_stepper(const Model& model, PassCounts passes, Kicks kicks,
                                                        const Execution& execution) {
  return make<Relaxation<float>>(model, passes, kicks, execution);
}

}  // namespace taut
