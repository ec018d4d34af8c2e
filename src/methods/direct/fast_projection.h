#pragma once

#include <vector>

#include "direct/active_limits.h"
#include "direct/link_system.h"
#include "methods/method.h"

namespace taut {

/// Brings all links to their lengths by Newton's method on the multipliers alone, each round along the
/// links' directions of that round.
class FastProjection {
 public:
  /// For the links of the system, which belong to `model`.
  FastProjection(const Model& model, LinkSystem system, const State& state);

  /// Moves `position`, where the masses would be at the end of a step of h seconds from `start` without
  /// links, to where the links allow; sets their tensions (N). False, with the reason in the report, where it
  /// does not converge.
  bool solve(const Vectors& start, double h, Vectors& position, std::vector<double>& tension,
             StepReport& report);

 private:
  void prepare(const Vectors& start, double h, double answer);
  double measure_residual(const Vectors& position, double h, StepReport& report);
  Index worst_link(double size) const;
  void add_compliance(const Vectors& position, double h);

  const Model& model_;
  LinkSystem system_;
  ActiveLimits limits_;
  bool compliant_ = false;              // whether any link is
  std::vector<double> inverse_length_;  // 1/m
  Vectors direction_, start_vector_;
  std::vector<double> distance_, residual_, multipliers_, diagonal_, scale_;
};

}  // namespace taut
