#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "output/gnuplot.h"

namespace taut {

/// A point of a chart; both coordinates above 0.
struct FigurePoint {
  double x = 0.0, y = 0.0;
  bool on_line = false;  ///< of its curve's line; else it is only a faint dot
};

/// A curve of a chart and its name, which stands in the margin, beside the end of smallest x.
struct FigureCurve {
  std::string name;
  std::size_t style = 0;  ///< of the house's colours and markers (plot_colour.h)
  int variant = 0;        ///< of its style: the second is dashed, others dotted, their markers hollow
  std::vector<FigurePoint> points;  ///< in the order of the line
};

/// A place on the front and what it is called.
struct FigureLabel {
  double x = 0.0, y = 0.0;
  std::string text;  ///< may be empty: part of the front, without a name
};

/// A height that means something by itself.
struct FigureLevel {
  double y = 0.0;
  std::string text;
};

/// Curves over two logarithmic axes. x falls from left to right, so that what is good lies at the right and
/// low.
struct ChartFigure {
  std::string title, subtitle, x_label, y_label;
  std::vector<FigureCurve> curves;
  std::vector<FigureLabel>
      front;  ///< the best of all curves, from cheap to dear; drawn as a band behind them
  std::optional<FigureLevel> level;  ///< a line across; where it lies far off, only an arrow and its text
  bool orders = true;  ///< with guides: how y rises as x falls where x is y to the power −1, −2, −4
  std::string note;    ///< one line below
};

/// The figure as a plot. All of its parts lie within the picture, and no two texts over each other.
PlotScript figure_script(const ChartFigure& figure);

}  // namespace taut
