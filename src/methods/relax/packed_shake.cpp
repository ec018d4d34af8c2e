// shake where nothing acts on masses but rigid links, gravity, drag and pins. Masses stay packed between
// steps, as in packed_stepper.cpp, and so do multipliers: with the sums Σ q of the last two steps, as long as
// each other, the tension at the end of a step is worked out when somebody asks for it. shake.cpp has the
// formulas. The first steps after load(), and those of another length than the one before, work it out at
// once.

#include "relax/packed_shake.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base/vector_operations.h"
#include "forces/forces.h"
#include "relax/along_relaxation.h"
#include "relax/kept_pins.h"

namespace taut {
namespace {

// As long as each other, from which multipliers tell tensions, one back as well.
constexpr int steps_to_last = 2;

class PackedShake final : public Stepper {
 public:
  PackedShake(const Model& model, int passes, const Execution& execution)
      : model_(model), passes_(passes), links_(model, execution) {}

  void load(const State& state) override {
    if (state.broken_at != state_.broken_at) links_changed_ = true;
    state_ = state;
    at_ = {};
    packed_ = behind_ = tensions_behind_ = false;
  }

  StepReport step(double h, double end_time) override {
    if (!packed_) pack();
    const bool as_last = state_.unanswered_kick == 0.5 * h;
    const bool lasting = as_last && at_.lasting >= steps_to_last;
    if (!lasting) {
      store();
      tension_kept_ = state_.tension;
      tension_before_kept_ = state_.tension_before;
    }
    pins_before_.keep(model_, state_);
    place_pins(model_, end_time, state_.position, state_.velocity);
    StepReport report;
    if (!std::isfinite(end_time) || !pins_finite_) report.status = StepStatus::not_finite;
    if (report.status == StepStatus::done) move(h, next_, report);
    if (report.status != StepStatus::done) {
      pins_before_.put_back(model_, state_);
      return report;
    }
    std::swap(previous_, present_);
    std::swap(present_, next_);
    kept_ = {at_, state_.time, state_.unanswered_kick, !lasting};
    const double scale = tension_scale(h, state_.unanswered_kick);
    at_ = {h, false, as_last ? at_.lasting + 1 : 0};
    state_.unanswered_kick = 0.5 * h;
    state_.time = end_time;
    behind_ = true;
    tensions_behind_ = lasting;
    if (!lasting) set_tensions(h, scale, as_last, report);
    return report;
  }

  void undo() override {
    std::swap(present_, next_);
    std::swap(previous_, present_);
    links_.take_back();
    pins_before_.put_back(model_, state_);
    at_ = kept_.at;
    state_.time = kept_.time;
    state_.unanswered_kick = kept_.unanswered_kick;
    behind_ = true;
    tensions_behind_ = !kept_.tensions;
    if (!kept_.tensions) return;
    std::swap(state_.tension, tension_kept_);
    std::swap(state_.tension_before, tension_before_kept_);
    at_.lasting = 0;
  }

  const State& store() override {
    motion();
    if (std::exchange(tensions_behind_, false))
      links_.give_continued(lasting_scale(), state_.tension, state_.tension_before);
    return state_;
  }

  const State& motion() override {
    if (!std::exchange(behind_, false)) return state_;
    links_.places().give(present_, state_.position);
    if (at_.velocities) {
      links_.places().give(previous_, state_.velocity);
    } else {
      links_.places().give_difference(previous_, present_, 1.0 / at_.h, state_.velocity);
      place_pins(model_, state_.time, state_.position, state_.velocity);
      kick(model_, state_.time, 0.5 * at_.h, state_.velocity, state_.velocity);
    }
    return state_;
  }

  void watch(const Watched& watched) override { watched_ = watched; }

  const State& glimpse() override {
    if (!behind_ || at_.velocities) return store();
    const FieldKick end = end_kick();
    for (const Index mass : watched_.masses) {
      if (model_.masses.pinned(mass)) continue;
      const std::size_t place = links_.places().place[mass];
      state_.position.set(mass, at(present_, place));
      state_.velocity.set(mass, velocity_at_place(place, end));
    }
    if (tensions_behind_)
      for (const Index link : watched_.links)
        if (!state_.broken(link) && model_.links.rigid(link))
          state_.tension[link] = links_.continued(link, lasting_scale());
    return state_;
  }

  std::optional<double> energy() override {
    if (at_.velocities) return std::nullopt;
    const FieldKick end = end_kick();
    return energy_of_motion(
        links_.places().layout,
        {1.0 / at_.h, end.keep, packed_vector<double>(end.gain), packed_vector<double>(-model_.gravity)},
        mass_at_place_, present_.read(), previous_.read());
  }

 private:
  using Masses = AlongRelaxation::Masses;

  // Where steps have come to.
  struct Going {
    double h = 1.0;          // s, of the last step
    bool velocities = true;  // previous_ has them: there is no last step
    int lasting = 0;         // steps as long as the one before, in a row
  };
  // What undo() goes back to.
  struct Kept {
    Going at;
    double time = 0.0, unanswered_kick = 0.0;  // s
    bool tensions = false;                     // whether they were kept: else multipliers tell them
  };
  // The state as it was loaded: not before there is a step to make, for some are only looked at.
  void pack() {
    if (std::exchange(links_changed_, false)) {
      links_.links_changed(state_);
      previous_ = present_ = next_ = probed_ = links_.places().room();
      mass_at_place_.clear();
      for (const Index mass : links_.places().masses)
        mass_at_place_.push_back(mass == empty_place ? 0.0 : model_.masses.mass[mass]);
      if (links_.places().layout == Layout::split)
        while (mass_at_place_.size() % 4 != 0) mass_at_place_.push_back(0.0);
    }
    links_.places().load(state_.velocity, previous_);
    links_.places().load(state_.position, present_);
    links_.places().load(state_.position, next_);
    packed_ = true;
    pins_finite_ = still_pins_are_finite(model_, state_);
  }

  FieldKick end_kick() const { return field_kick(model_, 0.5 * at_.h, DragAt::end); }
  static Vec3 at(const Masses& masses, std::size_t place) {
    const Packed<double> vector = masses.at(place);
    return {vector.x, vector.y, vector.z};
  }
  Vec3 velocity_at_place(std::size_t place, const FieldKick& end) const {
    return ((at(present_, place) - at(previous_, place)) * (1.0 / at_.h)) * end.keep + end.gain;
  }

  // The masses at the end of another step of h seconds, to `moved`, with pins where the state has them.
  void move(double h, Masses& moved, StepReport& report) {
    const FieldKick end = end_kick();
    const FieldKick begun = field_kick(model_, 0.5 * h, DragAt::start);
    const FreeMotion<double> motion{previous_.read(),
                                    present_.read(),
                                    at_.velocities,
                                    1.0 / at_.h,
                                    end.keep,
                                    begun.keep,
                                    h,
                                    packed_vector<double>(end.gain),
                                    packed_vector<double>(begun.gain)};
    links_.places().load_pins(state_.position, moved);
    links_.begin_step(1.0, 1.0);
    for (int made = 0; made < passes_; ++made) {
      const AlongStart found = links_.pass_along(present_, moved, {made == 0, made == passes_ - 1}, false,
                                                 made == 0 ? &motion : nullptr);
      if (found.lost()) {
        report.status = std::isfinite(found.lost_along) ? StepStatus::direction_lost : StepStatus::not_finite;
        report.worst_link = found.lost_link;
      } else if (!found.finite) {
        report.status = StepStatus::not_finite;
      }
      if (report.status != StepStatus::done) return links_.take_back();
      ++report.rounds;
      report.link_solves += links_.size();
    }
  }

  // Tensions at the end of the step just made, from those at its start and those before it, or from another
  // step, which is not made.
  void set_tensions(double h, double scale, bool as_last, StepReport& report) {
    start_tension_ = state_.tension;
    links_.give_multipliers_along(scale, start_tension_);
    if (as_last && !state_.tension_before.empty()) {
      all_of(state_.tension) = 2.0 * all_of(start_tension_) - all_of(state_.tension_before);
    } else {
      state_.tension = start_tension_;
      probe(h, report);
    }
    if (as_last)
      std::swap(state_.tension_before, start_tension_);
    else
      state_.tension_before.clear();
  }

  void probe(double h, StepReport& report) {
    if (links_.size() == 0) return;
    pins_at_end_.keep(model_, state_);
    place_pins(model_, state_.time + h, state_.position, state_.velocity);
    StepReport probe;
    move(h, probed_, probe);
    pins_at_end_.put_back(model_, state_);
    report.link_solves += probe.link_solves;
    if (probe.status != StepStatus::done) return;
    links_.give_multipliers_along(tension_scale(h, state_.unanswered_kick), state_.tension);
    links_.take_back();
  }

  // What the multipliers of a step of h seconds that has also answered the kick before it say of its start.
  double tension_scale(double h, double kick_before) const {
    return (1.0 + 0.5 * h * model_.drag) / (h * (0.5 * h + kick_before));
  }
  double lasting_scale() const { return tension_scale(at_.h, 0.5 * at_.h); }

  const Model& model_;
  int passes_;
  AlongRelaxation links_;
  State state_;  // of pins always, of all else where it isn't behind
  Watched watched_;
  bool links_changed_ = true, packed_ = false;
  bool pins_finite_ = true;  // those that nothing drives
  bool behind_ = false, tensions_behind_ = false;
  Going at_;
  Kept kept_;
  KeptPins pins_before_, pins_at_end_;
  Masses previous_, present_, next_;   // the free masses before, now, and being made; or before that
  Masses probed_;                      // at the end of a step that is not made
  std::vector<double> mass_at_place_;  // kg, filled up for the kernel
  std::vector<double> start_tension_, tension_kept_, tension_before_kept_;  // N
};

}  // namespace

std::unique_ptr<Stepper> make_packed_shake(const Model& model, int passes, const Execution& execution) {
  return std::make_unique<PackedShake>(model, passes, execution);
}

}  // namespace taut
