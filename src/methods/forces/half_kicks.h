#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "forces/springs.h"
#include "methods/method.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// What methods of second order know as forces: gravity, loads, drag, wind, and links with stiffness, in half
/// kicks at both ends of a step.
///
///   v_k = v + (h/2) a(x, v)                                   at the start
///   x₁, v½ = (x₁ − x)/h                                       the method's: what rigid links make of v_k
///   u = v½ + (h/2) a(x₁, v½) + (v½ − v_k)/n                   a first guess at v₁
///   v₁ = v½ + (h/2) a(x₁, u)                                  at the end
///
/// Damping and wind ask for v₁ before it is known, and second order asks for it within O(h²). The guess
/// counts on rigid links doing in the second half what they did in the first; without that it is out by O(h),
/// and the method of first order. v½ − v_k is their answer to n half kicks: one where they also answer at the
/// end of a step (rattle), two where they do not (shake). Drag alone may be implicit in v₁: what it takes too
/// much of lies along the links, which put it right.
class HalfKicks {
 public:
  HalfKicks(const Model& model, double answered_at_once)
      : model_(model), answered_at_once_(answered_at_once) {}

  /// To be called before the first step and whenever links have broken.
  void links_changed(const State& state);

  /// Whether any force but drag depends on velocity.
  bool meet_velocity() const { return model_.wind.has_value() || damped_; }

  /// Whether there is nothing but gravity, loads and drag.
  bool only_fields() const { return springs_.empty() && !model_.wind; }

  /// Spring forces worked out in a step.
  std::int64_t solves() const {
    return (meet_velocity() ? 3 : 2) * static_cast<std::int64_t>(springs_.links.size());
  }

  /// Half a kick at the start: `kicked` from `velocity`; damping and wind meet the velocities `met`.
  void start(const State& whole, double time, double half, const Vectors& position, const Vectors& velocity,
             const Vectors& met, Vectors& kicked);

  /// Half a kick at the end, to the mean velocities of the step; `kicked` as start() left it, before rigid
  /// links had their say. Springs' tensions (N) go into `tension`, one a link of the model.
  void end(const State& whole, double time, double half, const Vectors& position, const Vectors& kicked,
           Vectors& velocity, std::vector<double>& tension);

  /// Accelerations but for what rigid links do, see free_accelerations(); springs' tensions as from end().
  void accelerations(const State& whole, double time, const Vectors& position, const Vectors& velocity,
                     Vectors& acceleration, std::vector<double>& tension);

 private:
  void keep_tensions(std::vector<double>& tension) const;

  const Model& model_;
  double answered_at_once_;  // n
  Springs springs_;
  bool damped_ = false;
  Vectors guess_;
  std::vector<double> spring_tension_;
};

/// Why a method that knows links with stiffness as forces refuses a run from a start: the stiffest vibrate
/// too fast for its steps, ω·h ≥ 2. Empty where they don't.
std::string too_stiff(const Model& model, const State& start, const Settings& settings);

}  // namespace taut
