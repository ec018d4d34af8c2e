#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "output/chart_figure.h"

namespace taut {
namespace {

// So many curves that all end at the same, topmost point.
ChartFigure crowded(int curves) {
  ChartFigure figure;
  figure.title = "title";
  figure.subtitle = "subtitle";
  for (int i = 0; i < curves; ++i)
    figure.curves.push_back({fmt::format("curve{}", i), 0, false, {{1.0, 0.01, true}, {0.01, 1.0, true}}});
  return figure;
}

// How far below the picture's upper edge a label stands, in pixels.
double depth_of(const std::string& text, const PlotScript& script) {
  const std::string head = fmt::format("set label '{}' at screen ", text);
  const std::size_t at = script.commands.find(head);
  EXPECT_NE(at, std::string::npos) << text;
  const std::size_t comma = script.commands.find(',', at);
  return (1.0 - std::stod(script.commands.substr(comma + 1))) * script.size.height;
}

TEST(ChartFigure, HasRoomBelowTheTitleForNamesThatMakeWayForOthers) {
  for (const int curves : {1, 5, 20}) {
    const PlotScript script = figure_script(crowded(curves));
    for (int i = 0; i < curves; ++i)
      EXPECT_GT(depth_of(fmt::format("curve{}", i), script), depth_of("subtitle", script) + plot_letters)
          << curves << " curves";
  }
}

TEST(ChartFigure, KeepsNamesApart) {
  const PlotScript script = figure_script(crowded(20));
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < i; ++j)
      EXPECT_GT(
          std::abs(depth_of(fmt::format("curve{}", i), script) - depth_of(fmt::format("curve{}", j), script)),
          plot_letters);
}

}  // namespace
}  // namespace taut
