#pragma once

#include <vector>

#include "direct/link_system.h"
#include "extent.h"
#include "methods/method.h"

namespace taut {

/// How far rigid links are from their lengths within a step: g = (|d|² − l²)/2, judged by |g|/l².
class LengthErrors {
 public:
  void links_changed(const SystemLinks& links);

  /// Begins anew: nothing is measured.
  void begin();
  /// Measures links that have not been since begin(): all those of an extent that holds the ones before.
  void measure(const SystemLinks& links, const Vectors& position, Extent larger);

  /// The largest |g|/l² of all that have been measured.
  double worst() const { return misfit_.worst; }
  /// Whether all links have a direction, and finite numbers; reports one that has not.
  bool sound(const SystemLinks& links, StepReport& report) const;
  /// The link with the least share of its direction left, or the largest error; one that is not finite.
  Index worst_link(const SystemLinks& links, StepStatus what) const;

  const std::vector<double>& inverse_square() const { return lengths_.inverse_square; }

  Vectors start_direction;       ///< d at the start of the step, m
  Vectors direction;             ///< d as measured, m
  std::vector<double> residual;  ///< g as measured, m²; room for what a solve makes of it

 private:
  SquaredLengths lengths_;
  Misfit misfit_;
  GrowingExtent measured_;
};

}  // namespace taut
