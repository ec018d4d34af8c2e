#pragma once

#include <vector>

#include "high_order/equations.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// Looks out for what changes the equations of motion: a link that comes to its threshold, a stop that is met
/// or left.
class EventWatch {
 public:
  explicit EventWatch(const Model& model);

  /// What is whole and held from now on.
  void begin(const State& state);

  /// Whether nothing can happen at all.
  bool none() const { return links_.empty() && model_.limits.empty(); }

  /// How far beyond the first event these positions are, with the tensions and pushes of the last evaluation
  /// there: negative before it. A share of a threshold, an angle (rad) or a torque (N m).
  double past(const Vectors& position, const Equations& equations);

  /// The links at their thresholds there, within 1e-9 of them, in file order.
  std::vector<Index> breaking(const Vectors& position, const Equations& equations);

 private:
  double past_break(const Vectors& position, Index link) const;
  double past_limit(const Vectors& position, std::size_t limit) const;

  const Model& model_;
  double slack_;              // N m
  std::vector<Index> links_;  // that are whole and can break
  std::vector<HeldStop> held_;
  std::vector<bool> let_go_;  // one a limit
  std::vector<double> tension_;
};

}  // namespace taut
