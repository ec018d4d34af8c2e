#pragma once

#include <vector>

#include "model/model.h"

namespace taut {

/// Links one behind the other: masses[i] and masses[i + 1] are those that links[i] joins.
struct LinkRun {
  std::vector<Index> masses, links;

  /// Whether it ends where it begins.
  bool closed() const { return links.size() > 2 && masses.front() == masses.back(); }
};

/// The longest runs of those links that `drawn` marks; each of these is in exactly one. A run goes on through
/// a mass where just two links of one line meet, whatever else meets there. A line is a chain, a sheet's
/// family of links in one direction (its rows, its columns), or all links that stand for themselves. Runs
/// come in the order of their first links.
std::vector<LinkRun> link_runs(const Model& model, const std::vector<bool>& drawn);

/// Masses in which more than one run ends, or runs cross, in rising order.
std::vector<Index> knots(const Model& model, const std::vector<LinkRun>& runs);

}  // namespace taut
