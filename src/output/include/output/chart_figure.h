#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "output/gnuplot.h"

namespace taut {

/// A point of a chart; both coordinates above 0.
struct FigurePoint {
  double x = 0.0, y = 0.0;
  bool on_line = false;  ///< of its curve's line; else it is only a faint dot
};

/// A curve of a chart and its name, which stands beside it.
struct FigureCurve {
  std::string name;
  std::size_t colour = 0;  ///< of the house style's
  bool dashed = false;
  std::vector<FigurePoint> points;  ///< in the order of the line
};

/// A place on the front and what it is called.
struct FigureLabel {
  double x = 0.0, y = 0.0;
  std::string text;  ///< may be empty: part of the front, without a name
};

/// Curves over two logarithmic axes.
struct ChartFigure {
  std::string title, subtitle, x_label, y_label;
  std::vector<FigureCurve> curves;
  std::vector<FigureLabel>
      front;  ///< the best of all curves, from cheap to dear; drawn as a band behind them
  std::vector<std::string> notes;  ///< sentences below, wrapped
};

/// The figure as a plot.
PlotScript figure_script(const ChartFigure& figure);

}  // namespace taut
