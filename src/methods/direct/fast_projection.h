#pragma once

#include <vector>

#include "direct/active_limits.h"
#include "direct/chain_blocks.h"
#include "direct/link_system.h"
#include "methods/method.h"

namespace taut {

/// Brings all links to their lengths by Newton's method on the multipliers alone, each round along the
/// links' directions of that round.
class FastProjection {
 public:
  /// For the links of the system, which belong to `model`.
  FastProjection(const Model& model, LinkSystem system, const State& state);

  /// Moves `position` to where the links allow at the end of a step of h seconds from `start`, and sets their
  /// tensions (N). It asks `predict` to put masses, all of them one extent after the other, where they would
  /// be without links. False, with the reason in the report, where it does not converge.
  bool solve(const Vectors& start, double h, const ExtentVisit& predict, Vectors& position,
             std::vector<double>& tension, StepReport& report);

  /// How a step goes over the links.
  const ChainBlocks& blocks() const { return blocks_; }

 private:
  double predict_all(const ExtentVisit& predict, Vectors& position);
  bool solve_round(double answer, Vectors& position);
  void measure(const Vectors& position, Extent moved);
  void keep_tensions(double h, std::vector<double>& tension) const;
  void prepare(const Vectors& start, double h, double answer);
  double look_at_misfit(const Vectors& position, double h, StepReport& report);
  Index worst_link(double size) const;
  void add_compliance(const Vectors& position, double h);

  const Model& model_;
  LinkSystem system_;
  ActiveLimits limits_;
  ChainBlocks blocks_;                  // several only of rigid links
  bool compliant_ = false;              // whether any link is
  std::vector<double> inverse_length_;  // 1/m
  Vectors direction_, start_vector_;
  double shortest_;  // length, m
  Misfit misfit_;
  GrowingExtent measured_;
  std::vector<double> distance_, residual_, multipliers_, diagonal_, scale_;
};

}  // namespace taut
