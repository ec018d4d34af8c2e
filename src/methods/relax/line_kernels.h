#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "relax/vector_room.h"

namespace taut {

/// How many lines lie side by side, whatever the width of vectors.
inline constexpr std::size_t lines_at_once = 4;

/// Lines side by side, in lanes: each lane a row of masses, and a link from each to the next or none. So a
/// lane may have several lines one after another. The mass of lane i in row r has slot begin + 4 r + i, and
/// so has the link from it to the mass in row r + 1.
struct LineGroup {
  std::size_t begin = 0, rows = 0;
  std::size_t special = 0;  ///< place of its first slot in the special arrays
  bool soft = false;        ///< with compliance
  bool damped = false;      ///< and damping
};

/// What the kernel reads and writes, one array each; line_relaxation.h has the formulas.
struct LineArrays {
  // One a slot.
  const std::uint32_t* place;  // of the mass, bytes from the first
  const double* move;          // answer·w of the mass
  const double* length;        // m, of the link; 0 where there is none
  const double* diagonal;      // D, of the link; 1 where there is none
  double* multiplier;          // λ
  // One a special place.
  const double* scaled;  // α̃, of soft links
  const double* gamma;   // γ, of damped ones
  const double* damped;  // 1/(1 + γ)
};

/// How many numbers a group of so many rows is worked out in.
constexpr std::size_t line_scratch(std::size_t rows) {
  return 3 * lines_at_once * rows;
}

/// One pass over all lines of some groups. `start` is read where links are damped. In the `first` pass of a
/// step multipliers are 0, whatever they hold. `scratch`: line_scratch() of the longest.
void relax_lines(const LineArrays& lines, std::span<const LineGroup> groups, RoomView<const double> start,
                 bool first, double* scratch, RoomView<double> position);

}  // namespace taut
