#pragma once

#include <cstddef>

#include "axes.h"
#include "extent.h"

namespace taut {

/// The tridiagonal matrix of `count` links along a path (path_matrix.cpp), and what elimination makes of it.
struct PathElimination {
  std::size_t count;
  AxesToRead rows, columns;
  const double* weight;    ///< w_a + w_b
  const double* coupling;  ///< ± w of the mass shared with the next link
  const double* diagonal;  ///< what is added to the entries
  double *entry, *above, *below;
  double* inverse_pivot;
  double *inward, *outward;  ///< off-diagonals over the pivot: towards the middle's row, and its own

  /// Where rows and columns are the same, so are above and below, inward and outward.
  bool symmetric() const { return above == below; }
};

/// How far elimination has come from one end of a path: what the next row there takes over.
struct PathEnd {
  double last_inverse = 0.0;  ///< of the pivots
  double carried = 0.0;       ///< to the right side
};

/// Fills rows of it and eliminates them, counted from either end, along with a right side where there is one:
/// those from `begin` on, a multiple of path_block, to `front_end` and to `back_end`. False where a pivot or
/// its inverse is zero or not finite.
struct PathRows {
  std::size_t begin, front_end, back_end;
};
bool eliminate_path(const PathElimination& path, const PathRows& rows, PathEnd& front, PathEnd& back,
                    double* right_side);

/// So many rows at either end are eliminated together while they are at hand.
inline constexpr std::size_t path_block = 128;

}  // namespace taut
