// A mass is where it is and where it was before: velocities are the difference of the two, worked out when a
// step begins, so that a step goes over the masses once, just ahead of the links. The kick at the end of a
// step with half kicks is made there, too. The first step after load() has velocities instead.

#include "relax/packed_stepper.h"

#include <cmath>
#include <utility>
#include <vector>

#include "forces/forces.h"
#include "relax/kept_pins.h"
#include "relax/line_relaxation.h"
#include "relax/looks.h"
#include "relax/relaxation.h"

namespace taut {
namespace {

template <class LinkRelaxation>
class PackedStepper final : public Stepper {
  using Real = typename LinkRelaxation::Number;
  using Masses = typename LinkRelaxation::Masses;

 public:
  PackedStepper(const Model& model, int passes, Kicks kicks, const Execution& execution)
      : model_(model), passes_(passes), kicks_(kicks), links_(model, execution) {}

  void load(const State& state) override {
    if (state.broken_at != state_.broken_at) links_changed_ = true;
    state_ = state;
    packed_ = behind_ = tensions_behind_ = false;
  }

  StepReport step(double h, double end_time) override {
    if (!packed_) pack();
    const bool whole = kicks_ == Kicks::whole;
    FreeMotion<Real> motion{previous_.read(), present_.read(), velocities_, {}, Real(1), {}, {}, {}, {}};
    motion.inverse_h = static_cast<Real>(1.0 / last_h_);
    motion.h = static_cast<Real>(h);
    set_kick(whole ? h : 0.5 * h, motion.keep, motion.gain);
    if (!whole && !velocities_) set_kick(0.5 * last_h_, motion.end_keep, motion.end_gain);
    StepReport report;
    if (!std::isfinite(end_time) || !pins_finite_) {
      report.status = StepStatus::not_finite;
      return report;
    }
    pins_before_.keep(model_, state_);
    place_pins(model_, end_time, state_.position, state_.velocity);
    links_.places().load_pins(state_.position, next_);
    const bool keep = LinkRelaxation::always_keeps || passes_ > 1 || !watched_.links.empty() ||
                      looks_.expected_after_next_step();
    const bool finite = make_passes(h, motion, keep, present_, next_);
    report.rounds = passes_;
    report.link_solves = links_.size() * passes_;
    multipliers_kept_ = keep ? finite : multipliers_kept_ && !finite;
    if (!finite) {
      next_ = present_;  // what is filled up with masses that no step moves may be no number
      pins_before_.put_back(model_, state_);
      report.status = StepStatus::not_finite;
      return report;
    }
    motion_ = motion;
    std::swap(earlier_, next_);
    std::swap(earlier_, previous_);
    std::swap(previous_, present_);
    looks_.step_made();
    kick_before_ = state_.unanswered_kick;
    if (!whole) state_.unanswered_kick = 0.5 * h;
    state_.time = end_time;
    last_h_ = h;
    velocities_ = false;
    behind_ = tensions_behind_ = true;
    return report;
  }

  void undo() override {}

  const State& store() override {
    motion();
    if (!std::exchange(tensions_behind_, false)) return state_;
    recall_multipliers();
    looks_.looked();
    links_.give_multipliers(tension_scale(), state_.tension);
    return state_;
  }

  const State& motion() override {
    if (!std::exchange(behind_, false)) return state_;
    links_.places().give(present_, state_.position);
    links_.places().give_difference(previous_, present_, static_cast<Real>(1.0 / last_h_), state_.velocity);
    if (kicks_ == Kicks::halves) {
      kick(model_, state_.time, 0.5 * last_h_, state_.velocity, state_.velocity);
      place_pins(model_, state_.time, state_.position, state_.velocity);
    }
    return state_;
  }

  void watch(const Watched& watched) override { watched_ = watched; }

  const State& glimpse() override {
    if (!tensions_behind_ || kicks_ == Kicks::halves) return store();
    if (!watched_.links.empty()) recall_multipliers();
    const Real inverse_h = static_cast<Real>(1.0 / last_h_);
    for (const Index mass : watched_.masses) {
      if (model_.masses.pinned(mass)) continue;
      const Packed<Real> now = present_.at(links_.places().place[mass]),
                         before = previous_.at(links_.places().place[mass]);
      state_.position.set(mass, Vec3(now.x, now.y, now.z));
      state_.velocity.set(mass, Vec3((now.x - before.x) * inverse_h, (now.y - before.y) * inverse_h,
                                     (now.z - before.z) * inverse_h));
    }
    for (const Index link : watched_.links)
      if (!state_.broken(link))
        state_.tension[link] = static_cast<double>(links_.multiplier(link)) * tension_scale();
    return state_;
  }

 private:
  // The state as it was loaded: not before there is a step to make, for some are only looked at.
  void pack() {
    if (std::exchange(links_changed_, false)) {
      links_.links_changed(state_);
      earlier_ = previous_ = present_ = next_ = links_.places().room();
    }
    links_.places().load(state_.velocity, previous_);
    links_.places().load(state_.position, present_);
    links_.places().load(state_.position, next_);
    packed_ = velocities_ = true;
    pins_finite_ = still_pins_are_finite(model_, state_);
  }

  void set_kick(double seconds, Real& keep, Packed<Real>& gain) const {
    const FieldKick fields = field_kick(model_, seconds, DragAt::end);
    keep = static_cast<Real>(fields.keep);
    gain = packed_vector<Real>(fields.gain);
  }

  bool make_passes(double h, const FreeMotion<Real>& motion, bool keep, const Masses& start,
                   Masses& position) {
    const bool whole = kicks_ == Kicks::whole;
    links_.begin_step(static_cast<Real>(h), static_cast<Real>(whole ? 1.0 / (1.0 + h * model_.drag) : 1.0));
    bool finite = true;
    for (int made = 0; made < passes_; ++made)
      finite =
          links_.pass(start, position, {made == 0, made == passes_ - 1, keep}, made == 0 ? &motion : nullptr);
    return finite;
  }

  // Makes the last step once more, from the same masses to the same places, with multipliers. They take long
  // to write, and most steps are not looked at.
  void recall_multipliers() {
    if (std::exchange(multipliers_kept_, true)) return;
    make_passes(last_h_, motion_, true, previous_, present_);
  }

  double tension_scale() const {
    return -1.0 / (last_h_ * (kicks_ == Kicks::whole ? last_h_ : kick_before_ + 0.5 * last_h_));
  }

  const Model& model_;
  int passes_;
  Kicks kicks_;
  LinkRelaxation links_;
  State state_;  // of pins always, of all else where it isn't behind
  Watched watched_;
  bool links_changed_ = true, packed_ = false;
  bool behind_ = false, tensions_behind_ = false;  // positions and velocities; tensions
  bool multipliers_kept_ = true;                   // of the last step
  Looks looks_;
  bool pins_finite_ = true;  // those that nothing drives
  KeptPins pins_before_;
  Masses earlier_, previous_, present_, next_;  // the free masses before that before, before, now, being made
  FreeMotion<Real> motion_{};                   // of the last step, from earlier_ and previous_
  bool velocities_ = false;                     // previous_ has them
  double last_h_ = 1.0, kick_before_ = 0.0;     // s
};

}  // namespace

bool only_links(const Model& model) {
  return model.limits.empty() && model.bends.empty() && model.joints.empty() && model.contacts.empty() &&
         model.faces.empty() && model.loads.empty() && !model.wind;
}

template <class LinkRelaxation>
std::unique_ptr<Stepper> make_packed_stepper(const Model& model, int passes, Kicks kicks,
                                             const Execution& execution) {
  return std::make_unique<PackedStepper<LinkRelaxation>>(model, passes, kicks, execution);
}

template std::unique_ptr<Stepper> make_packed_stepper<Relaxation<double>>(const Model&, int, Kicks,
                                                                          const Execution&);
template std::unique_ptr<Stepper> make_packed_stepper<Relaxation<float>>(const Model&, int, Kicks,
                                                                         const Execution&);
template std::unique_ptr<Stepper> make_packed_stepper<LineRelaxation>(const Model&, int, Kicks,
                                                                      const Execution&);

}  // namespace taut
