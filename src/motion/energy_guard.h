#pragma once

#include <vector>

#include "model/model.h"
#include "model/state.h"
#include "motion/work_ledger.h"

namespace taut {

/// Tells states that have more energy than they can have come by.
///
/// The energy E of free masses and whole links, less the work done on them, must not exceed what it was at
/// the start by more than a tenth of the scene's energies S, and by what a symplectic method's energy swings:
///
///   E − W ≤ E₀ + S/10 + (h²/8) Σ w |F|²
///
/// S: weight and full loads through the total link length, kinetic and elastic energy at the start, mass ×
/// (speed of the fastest pin so far)², and all work done so far, either way. W is as good as the tensions it
/// is summed from. F is the force of springs, gravity and loads on a mass. For springs that vibrate,
/// Störmer–Verlet keeps E − (h²/8) Σ w |F|² to the last digit for any ω·h < 2, while E alone swings by as
/// much as it likes: so no step that a stable method makes is refused, at whatever moment the run began. (A
/// bound on the gain of single steps that the swing does reach takes away the rising steps and keeps the
/// falling ones, and brings a spring to rest.) In wind S and mass × air speed² are allowed in full: it may
/// lift everything, and take it along.
class EnergyGuard {
 public:
  EnergyGuard(const Model& model, const State& start);

  /// From now on masses are free that were pins; the work tells of the energy they bring.
  void go_on_with(const Model& model);

  /// Whether the state that a step of h seconds has come to has energy from nothing, after so much work.
  bool exceeded(Stepper& stepper, double h, const Work& work);

 private:
  double energy_of(const State& state) const;
  void gather_springs_of(const Model& model);
  double swing(const State& state, double h);

  const Model* model_;
  double mass_ = 0.0;                           // kg, of the free masses
  double energy_at_start_ = 0.0, scale_ = 0.0;  // J
  std::vector<Index> springs_;                  // links with stiffness that have a free end
  Vectors force_;                               // N
};

}  // namespace taut
