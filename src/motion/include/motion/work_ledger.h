#pragma once

#include <vector>

#include "methods/method.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// What was done to the energy of a run from outside (J).
struct Work {
  double pins = 0.0;         ///< by driven pins on the masses
  double loads = 0.0;        ///< by loads
  double contacts = 0.0;     ///< by solids that move, and by pins that are moved, on what touches them
  double broken = 0.0;       ///< elastic energy that went with broken links
  double throughput = 0.0;   ///< sum of the sizes of all the work above, step by step
  double fastest_pin = 0.0;  ///< m/s, the most that any pin has moved with

  /// What the total energy should have gained.
  double expected_gain() const { return pins + loads + contacts - broken; }
};

/// Adds up, step by step, the energy that a run gains and loses through its pins, its loads, its solids that
/// move and its broken links, so that what remains is what drag and friction take, what wind gives, and the
/// method's own error.
class WorkLedger {
 public:
  /// Goes on from a state, with what was done until then.
  WorkLedger(const Model& model, const State& state, const Work& before = {});

  /// Whether there is anything to add up: if not, record() need not be called.
  bool keeps_anything() const {
    return !model_->driven_pins.empty() || !model_->loads.empty() || breakable_springs_;
  }

  /// What it looks at in a state, as long as no link has broken since the last one.
  Watched watched() const;

  /// What will have been done when the run goes on from the state recorded last to another.
  Work until(const State& state) const;

  /// To be called after every step with the state that it ended in.
  void record(const State& state);

  /// The same of one long smooth step, in which nothing breaks: states at equal times, as many as a power of
  /// two, the last at its end. The sums over all, every second, every fourth … of them are extrapolated
  /// (Romberg).
  void record(const std::vector<State>& states);

  /// To be called after every step with its StepReport::contact_work.
  void add_contacts(double work);

  const Work& work() const { return work_; }

 private:
  // A link that ends in a driven pin, and its pull on the pin at the last step.
  struct PinLink {
    Index link, pin, other;
    Vec3 pull;  // N, on the mass at the other end, towards the pin
  };
  void look(const State& state);
  Vec3 pull_of(const PinLink& link, const State& state) const;

  const Model* model_;
  bool breakable_springs_ = false;
  std::vector<PinLink> pin_links_;
  std::vector<Vec3> last_pin_position_;                // m, one a pin link
  std::vector<std::vector<Vec3>> last_load_position_;  // m, one a mass of each load
  std::vector<bool> was_broken_;                       // one a breakable link
  double last_time_ = 0.0;                             // s
  Work work_;
};

}  // namespace taut
