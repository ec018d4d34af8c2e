#pragma once

#include <vector>

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// Adds up, step by step, the energy that a run gains and loses through its pins, its loads and its broken
/// links, so that what remains is the method's own error. Drag's loss is not counted.
class WorkLedger {
 public:
  WorkLedger(const Model& model, const State& start);

  /// To be called after every step with the state that it ended in.
  void record(const State& state);

  double pins() const { return pins_; }      ///< J, work of driven pins on the masses
  double loads() const { return loads_; }    ///< J, work of loads
  double broken() const { return broken_; }  ///< J, elastic energy that went with broken links
  /// What the total energy should have gained since the start (J).
  double expected_gain() const { return pins_ + loads_ - broken_; }

 private:
  // A link that ends in a driven pin, and its pull on the pin at the last step.
  struct PinLink {
    Index link, pin, other;
    Vec3 pull;  // N, on the mass at the other end, towards the pin
  };
  Vec3 pull_of(const PinLink& link, const State& state) const;

  const Model& model_;
  std::vector<PinLink> pin_links_;
  std::vector<Vec3> last_pin_position_;                // m, one a pin link
  std::vector<std::vector<Vec3>> last_load_position_;  // m, one a mass of each load
  std::vector<bool> was_broken_;                       // one a breakable link
  double last_time_;                                   // s
  double pins_ = 0.0, loads_ = 0.0, broken_ = 0.0;
};

}  // namespace taut
