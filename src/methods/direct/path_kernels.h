#pragma once

#include <cstddef>

#include "axes.h"

namespace taut {

/// What the tridiagonal matrix of `count` links along a path is made of, see path_matrix.cpp.
struct PathEntries {
  std::size_t count;
  const double* weight;           ///< w_a + w_b
  const double* coupling;         ///< ± w of the mass shared with the next link
  const double* diagonal;         ///< what is added to the entries
  double *entry, *above, *below;  ///< below: null where rows and columns are the same
};
void fill_path(const AxesToRead& rows, const AxesToRead& columns, const PathEntries& entries);

/// That matrix, and what elimination makes of it, from both ends to the middle.
struct PathElimination {
  std::size_t count, middle;
  const double *entry, *above, *below;  ///< the latter two may be read at −1, too
  double* inverse_pivot;
  double *inward, *outward;  ///< off-diagonals over the pivot: towards the middle's row, and its own
};

/// Eliminates it, along with a right side where there is one. False where a pivot or its inverse is zero or
/// not finite.
bool eliminate_path(const PathElimination& path, double* right_side);

}  // namespace taut
