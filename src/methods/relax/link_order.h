#pragma once

#include <cstddef>
#include <vector>

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// The links that a relaxation pass visits, in the order of the visits.
struct OrderedLinks {
  std::vector<Index> links;
  std::vector<std::size_t> colour_ends;  ///< one past the last link of each colour
};

/// Every whole link with a free end, colour by colour: no two links of a colour share a free mass (links that
/// meet in a pin don't disturb each other), colours given greedily in file order. Within a colour the
/// corrections are independent, so their order does not matter and the processor need not wait for one before
/// it begins the next.
OrderedLinks coloured_order(const Model& model, const State& state);

}  // namespace taut
