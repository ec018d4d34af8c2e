#pragma once

#include <vector>

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// Where driven pins are and how they move, to be put back after a step that fails or is taken back.
class KeptPins {
 public:
  void keep(const Model& model, const State& state);
  void put_back(const Model& model, State& state) const;

 private:
  std::vector<Vec3> pins_;  // m and m/s, one after the other
};

/// Whether the pins that nothing drives, and that so stay for ever, are where numbers are.
bool still_pins_are_finite(const Model& model, const State& state);

}  // namespace taut
