#pragma once

#include <vector>

#include "direct/link_system.h"
#include "methods/method.h"

namespace taut {

/// The relative error in lengths that a direct solve is to reach: 1e-12, or where positions are so large
/// beside the links that rounding forbids it, 16 units in the last place of a position over the shortest
/// link.
double length_tolerance(const SystemLinks& links, const Vectors& position);

/// How many rounds of Newton's method a solve may take.
inline constexpr int most_newton_rounds = 30;
/// A solve that is further off than this after so many rounds wanders about until the rounds run out: halving
/// the step at once is cheaper (on 1000 light links with a heavy tip at 60 steps/s it saves half of all
/// rounds).
inline constexpr int rounds_to_settle = 6;
inline constexpr double settled_error = 0.05;

/// Tells steps that make energy out of nothing. The gain of kinetic, gravity and elastic energy over a step,
/// less the work of loads and driven pins, and mass × air speed² where there is wind, must stay below a tenth
/// of the scene's energies: (weight and full loads) × total link length, kinetic and elastic energy before,
/// and mass × pin speed².
class EnergyWatch {
 public:
  explicit EnergyWatch(const Model& model);

  /// Whether such steps fail. They do until told otherwise.
  void set(bool on) { on_ = on; }

  /// Ends a step of h seconds: swaps the new positions, velocities and tensions into the state and moves its
  /// time on, or reports not_finite or energy_jump and leaves the state untouched.
  void take_over(State& state, Vectors& position, Vectors& velocity, std::vector<double>& tension, double h,
                 StepReport& report) const;

 private:
  bool jumped(const State& before, const Vectors& position, const Vectors& velocity,
              const std::vector<double>& tension, double h) const;
  double elastic(const State& state, const Vectors& position) const;
  double pin_work(const State& before, const Vectors& position, const std::vector<double>& tension) const;

  const Model& model_;
  bool on_ = true;
  double mass_ = 0.0;                // kg, of the free masses
  double force_scale_ = 0.0;         // J
  std::vector<Index> springs_;       // links with stiffness
  std::vector<Index> driven_links_;  // links with a driven pin
  std::vector<bool> driven_;
};

}  // namespace taut
