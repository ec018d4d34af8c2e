#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/chart_figure.h"
#include "output/label_layout.h"

namespace taut {

/// A logarithmic axis and where it lies on the picture.
struct FigureAxis {
  double low = 0.1, high = 1.0;  ///< of the numbers
  double from = 0.0, to = 1.0;   ///< pixels at `low` and at `high`

  double pixel(double value) const;
  double decades() const;
};

/// A text within a box, in pixels from the plot's lower left corner.
struct PlacedText {
  std::string text;
  LabelBox box;
};

/// A curve's name in the margin.
struct NameTag {
  std::size_t curve = 0;                ///< its place in the figure
  double point_x = 0.0, point_y = 0.0;  ///< the curve's end
  double y = 0.0;                       ///< the middle of the name
};

/// Lines from one point, as steep as curves of an order are, each with a name at its end.
struct OrderGuide {
  LabelLine line;
  PlacedText name;
};

/// Where all parts of a figure lie, in pixels from the plot's lower left corner.
struct FigureLayout {
  FigureAxis x, y;                   ///< x falls to the right: from > to
  double width = 0.0, height = 0.0;  ///< of the plot
  double margin = 0.0;               ///< right of it, for names
  std::vector<NameTag> names;        ///< in the order of the curves that have a line
  std::vector<PlacedText> front;     ///< names of places on the front that found room
  std::vector<OrderGuide> guides;
  bool level_within = false;        ///< whether the level's line lies within the plot
  std::optional<PlacedText> level;  ///< its text
};

inline constexpr int figure_name_letters = 28, figure_small_letters = 23;  ///< sizes of a font
/// Pixels from the plot's edge to where a sample of a curve begins, and across it, and to its name.
inline constexpr double figure_leader = 46.0, figure_sample = 62.0, figure_name_gap = 14.0;

/// Lays a figure out.
FigureLayout layout_of(const ChartFigure& figure);

}  // namespace taut
