#pragma once

#include <string_view>
#include <vector>

namespace taut {

/// A rectangle of a picture in pixels; y rises.
struct LabelBox {
  double left = 0.0, right = 0.0, low = 0.0, high = 0.0;

  bool meets(const LabelBox& other) const {
    return left < other.right && other.left < right && low < other.high && other.low < high;
  }
};

/// A straight line between two places of a picture, in pixels.
struct LabelLine {
  double from_x = 0.0, from_y = 0.0, to_x = 0.0, to_y = 0.0;
};

/// Whether any part of a line lies in a box.
bool meets(const LabelBox& box, const LabelLine& line);

/// Pixels that a text takes across in DejaVu Sans, rather more than less. `letters` is gnuplot's size of a
/// font, of which a pixel is three quarters.
double text_width(std::string_view text, int letters);

/// Pixels from line to line of letters of that size.
inline constexpr double text_height(int letters) {
  return 1.6 * letters;
}

/// Places for labels that would rather stand at `wanted` (in any order) but must be `gap` apart: in the same
/// order, between low and high, with the least squares of their moves. Where they do not fit they start at
/// `low` and go beyond `high`.
std::vector<double> spread_apart(const std::vector<double>& wanted, double gap, double low, double high);

}  // namespace taut
