#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "model/model.h"

namespace taut {

/// No mass lies there.
inline constexpr Index empty_place = std::numeric_limits<Index>::max();

/// In what order a relaxation goes over the links of a model, and how their masses lie in memory.
struct VisitOrder {
  /// Links that can be visited in any order, or all at once: of one colour, no two of which share a free
  /// mass (links that meet in a pin don't disturb each other).
  using Run = std::vector<Index>;

  /// The free masses, in the order in which they lie; between them there may be empty places.
  std::vector<Index> masses;
  std::vector<Run> runs;  ///< to be visited one after another
};

/// The free masses of a model in the order in which they are to lie for these links: as they are numbered,
/// or, where that leaves the ends of links further apart, in the order of Cuthill and McKee (Reducing the
/// Bandwidth of Sparse Symmetric Matrices, 1969).
std::vector<Index> mass_order(const Model& model, const std::vector<Index>& links);

/// The free masses with every second one of a row first, and then the others: every fourth, where links reach
/// over one mass. A row are masses numbered one after another of which each is linked to the next. So the
/// ends of a sheet's links of one kind and colour lie beside each other.
std::vector<Index> row_order(const Model& model, const std::vector<Index>& links, std::size_t width);

/// Whether most of the links follow another one of their kind, as those of sheets do: the next mass's, or
/// that of one soon after it.
bool follow_each_other(const Model& model, const std::vector<Index>& links);

/// The links as they are, or, where only so they follow each other, in the order of sheets: by how far apart
/// their ends are numbered, and then by their first ends. So a sheet whose links are listed at random is
/// relaxed like any other.
std::vector<Index> listed_as_in_sheets(const Model& model, std::vector<Index> links);

/// The result of visiting links in this order is that of visiting them colour by colour, with colours given
/// greedily in the order of `links`. Where there are more masses than a cache holds the colours go over them
/// as a wave, each a little behind the one before: a run has the links of one colour in a block of masses,
/// and comes after all that it depends on. Within a run they are in the order of their masses. `masses`: the
/// free ones, in any order.
VisitOrder visit_order(const Model& model, const std::vector<Index>& links, std::vector<Index> masses);

}  // namespace taut
