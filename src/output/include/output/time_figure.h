#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "output/gnuplot.h"

namespace taut {

/// A curve and its name, which stands in the margin beside its end, in its colour.
struct PlainCurve {
  std::string name;
  std::size_t style = 0;                      ///< of the house's colours (plot_colour.h)
  std::vector<std::array<double, 2>> points;  ///< in the order of the line
};

/// Quantities over time, one below the other.
struct TimeFigure {
  struct Panel {
    std::string label;  ///< of the upward axis: what it shows, and its unit
    std::vector<PlainCurve> curves;
  };
  std::string title, subtitle;
  std::vector<Panel> panels;
};

/// Ways in a plane, both axes to one scale; a dot where each begins, a disk where it ends.
struct PathFigure {
  std::string title, subtitle, x_label, y_label;
  std::vector<PlainCurve> curves;
};

/// The figures as plots, no two names over each other. Curves without points are left out.
PlotScript figure_script(const TimeFigure& figure);
PlotScript figure_script(const PathFigure& figure);

}  // namespace taut
