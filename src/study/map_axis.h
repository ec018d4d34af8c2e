#pragma once

#include <string>
#include <vector>

namespace taut {

/// Where a value lies among the cells of an axis: 0 in the middle of the first one, 1 in that of the second.
/// Between and beyond them it goes by the logarithm. `values` rise.
double cell_place(const std::vector<double>& values, double value);

/// A mark on an axis, at a place among its cells; without a text a small one.
struct AxisMark {
  double place = 0.0;
  std::string text;  ///< gnuplot's, enhanced
};

/// Marks at the powers of ten that the cells reach over, and small ones at the numbers between them. Where
/// there are fewer than three powers of ten, twice and five times them have texts, too. `plain`: 100 in place
/// of 10². `most`: no more texts than that, then only every other one.
std::vector<AxisMark> axis_marks(const std::vector<double>& values, bool plain, int most);

}  // namespace taut
