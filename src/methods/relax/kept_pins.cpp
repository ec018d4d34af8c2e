#include "relax/kept_pins.h"

namespace taut {

void KeptPins::keep(const Model& model, const State& state) {
  pins_.clear();
  for (const DrivenPin& pin : model.driven_pins) {
    pins_.push_back(state.position.at(pin.mass));
    pins_.push_back(state.velocity.at(pin.mass));
  }
}

void KeptPins::put_back(const Model& model, State& state) const {
  for (std::size_t i = 0; i < model.driven_pins.size(); ++i) {
    state.position.set(model.driven_pins[i].mass, pins_[2 * i]);
    state.velocity.set(model.driven_pins[i].mass, pins_[2 * i + 1]);
  }
}

bool still_pins_are_finite(const Model& model, const State& state) {
  std::vector<bool> driven(model.masses.size(), false);
  for (const DrivenPin& pin : model.driven_pins) driven[pin.mass] = true;
  for (std::size_t mass = 0; mass < model.masses.size(); ++mass)
    if (model.masses.pinned(mass) && !driven[mass] &&
        !(state.position.at(mass).allFinite() && state.velocity.at(mass).allFinite()))
      return false;
  return true;
}

}  // namespace taut
