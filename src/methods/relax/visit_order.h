#pragma once

#include <vector>

#include "model/model.h"

namespace taut {

/// In what order a relaxation goes over the links of a model, and how their masses lie in memory.
struct VisitOrder {
  /// Links that can be visited in any order, or all at once: of one colour, no two of which share a free
  /// mass (links that meet in a pin don't disturb each other).
  using Run = std::vector<Index>;

  std::vector<Index> masses;  ///< the free masses, in the order in which they lie
  std::vector<Run> runs;      ///< to be visited one after another
};

/// The free masses of a model in the order in which they are to lie for these links: as they are numbered,
/// or, where that leaves the ends of links further apart, in the order of Cuthill and McKee (Reducing the
/// Bandwidth of Sparse Symmetric Matrices, 1969).
std::vector<Index> mass_order(const Model& model, const std::vector<Index>& links);

/// The result of visiting links in this order is that of visiting them colour by colour, with colours given
/// greedily in the order of `links`. Where there are more masses than a cache holds the colours go over them
/// as a wave, each a little behind the one before: a run has the links of one colour in a block of masses,
/// and comes after all that it depends on. Within a run they are in the order of their masses. `masses`: the
/// free ones, in any order.
VisitOrder visit_order(const Model& model, const std::vector<Index>& links, std::vector<Index> masses);

}  // namespace taut
