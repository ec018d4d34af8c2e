#pragma once

#include <optional>
#include <vector>

#include "direct/link_system.h"

namespace taut {

/// One place in a tree elimination: a link, the free mass below it, and where its upper end leads.
struct TreeStep {
  Index link;            ///< position in the given list of links
  Index below;           ///< free mass that only this link joins to the rest that is not yet eliminated
  std::ptrdiff_t above;  ///< free mass at the other end, −1 for a pin
};

/// The links ordered along paths, when every free mass has at most two of them and no path closes into a
/// ring.
std::optional<std::vector<Index>> path_order(const Model& model, const std::vector<Index>& links);

/// The links ordered from the leaves to the roots, when free masses and links form trees with at most one pin
/// each.
std::optional<std::vector<TreeStep>> tree_order(const Model& model, const std::vector<Index>& links);

}  // namespace taut
