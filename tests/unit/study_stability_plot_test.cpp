#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "map_axis.h"
#include "map_cells.h"
#include "measure/stability_variant.h"
#include "output/plot_colour.h"
#include "plot_texts.h"
#include "stability_plot.h"

namespace taut {
namespace {

// Maps of so many methods, of which the upper right diverges and the lower left drifts.
StabilityMaps maps_of(int methods, const std::string& label = "xpbd") {
  StabilityMaps maps;
  maps.grid = {&find_map_axes("step,mass-ratio"), spread_values(1.0, 1e5, 9, false),
               spread_values(1e-5, 0.1, 7, false), 0.6};
  for (int i = 0; i < methods; ++i) {
    MethodMap map{i % 2 == 0 ? label : fmt::format("{}{}", label, i), {}};
    for (std::size_t column = 0; column < maps.grid.columns.size(); ++column) {
      MapColumn one;
      one.value = maps.grid.columns[column];
      for (std::size_t row = 0; row < maps.grid.rows.size(); ++row) {
        RunOutcome cell;
        cell.fate = row + column > 9 ? Fate::diverged : row + column < 3 ? Fate::drifted : Fate::held;
        cell.error = std::pow(10.0, -6.5 + static_cast<double>(row));
        one.cells.push_back(cell);
      }
      one.edge = Edge{1e-3, 2e-3};
      one.predicted = Prediction{0.03 / std::sqrt(one.value), "√(m l/T)"};
      map.columns.push_back(one);
    }
    maps.maps.push_back(map);
  }
  return maps;
}

const MapHeading heading{"Ten links released level", "0.6 s of motion, no step halved; 3 of 4 columns"};

TEST(MapPaint, TellsByLightnessAloneWhetherTheEnergyHeld) {
  constexpr double apart = 12.0, by_shade = 3.4;
  EXPECT_GE(lightness(map_paint(error_shades - 1)) - lightness(map_paint(error_shades)), apart);
  for (const std::size_t first : {std::size_t{0}, error_shades})
    for (std::size_t i = first + 1; i < first + error_shades; ++i)
      EXPECT_GE(lightness(map_paint(i - 1)) - lightness(map_paint(i)), by_shade) << i;
}

// The line is black within white: one of the two can be seen on any paint.
TEST(MapPaint, TheoryCanBeSeenOverEveryPaint) {
  for (std::size_t paint = 0; paint <= paint_missing; ++paint)
    EXPECT_GE(
        std::max(contrast_ratio(map_paint(paint), "#000000"), contrast_ratio(map_paint(paint), "#ffffff")),
        4.5)
        << paint;
}

TEST(MapPaint, OfEveryCell) {
  const StabilityMaps maps = maps_of(1);
  const std::vector<std::size_t> paints = map_paints(maps.grid, maps.maps[0]);
  ASSERT_EQ(paints.size(), 63U);
  EXPECT_EQ(paints[0], error_shades) << "drifted, the smallest error";
  EXPECT_EQ(paints[3 * 9], 3U) << "held, an error of 10^-3.5";
  EXPECT_EQ(paints.back(), paint_diverged);
  StabilityMaps fewer = maps;
  fewer.maps[0].columns.erase(fewer.maps[0].columns.begin() + 1);
  EXPECT_EQ(map_paints(fewer.grid, fewer.maps[0])[1], paint_missing);
  std::size_t cells = 0;
  for (const CellBox& box : boxes_of(paints, 9, paint_diverged)) cells += box.last_row - box.first_row + 1;
  EXPECT_EQ(cells, static_cast<std::size_t>(std::ranges::count(paints, paint_diverged)));
}

TEST(CellPlace, GoesByTheLogarithmBetweenCells) {
  const std::vector<double> even{1.0, 10.0, 100.0};
  EXPECT_NEAR(cell_place(even, 10.0), 1.0, 1e-12);
  EXPECT_NEAR(cell_place(even, std::sqrt(1000.0)), 1.5, 1e-12);
  EXPECT_NEAR(cell_place(even, 1000.0), 3.0, 1e-12);
  EXPECT_NEAR(cell_place(even, 0.1), -1.0, 1e-12);
  EXPECT_NEAR(cell_place({2.0, 3.0, 5.0, 8.0}, 5.0), 2.0, 1e-12);
}

TEST(AxisMarks, StandAtRoundNumbers) {
  int named = 0;
  for (const AxisMark& mark : axis_marks({1.0, 10.0, 100.0, 1000.0}, false, 9)) {
    if (mark.text.empty()) continue;
    EXPECT_EQ(mark.text, fmt::format("10^{{{}}}", named));
    EXPECT_NEAR(mark.place, named, 1e-12);
    ++named;
  }
  EXPECT_EQ(named, 4);
  std::vector<std::string> texts;
  for (const AxisMark& mark : axis_marks({2.0, 4.0, 9.0, 20.0, 40.0}, true, 9))
    if (!mark.text.empty()) texts.push_back(mark.text);
  EXPECT_EQ(texts, (std::vector<std::string>{"2", "5", "10", "20", "50"}));
}

TEST(StabilityPlot, ShowsAllOfItsTextsApartAndWithinThePicture) {
  for (const int methods : {1, 2, 3, 8, 13})
    for (const char* label : {"xpbd", "spring-implicit", "xpbd:precision=single:passes=4"}) {
      const StabilityMaps maps = maps_of(methods, label);
      const PlotScript script = overview_plot(maps, heading);
      testing::expect_texts_apart(testing::texts_of(testing::svg_of(script)), script.size);
    }
  const StabilityMaps maps = maps_of(1);
  const PlotScript script = map_plot(maps, maps.maps[0], heading);
  const std::vector<testing::PlotTextShown> texts = testing::texts_of(testing::svg_of(script));
  testing::expect_texts_apart(texts, script.size);
  EXPECT_EQ(std::ranges::count(texts, "√(m l/T)", &testing::PlotTextShown::text), 1)
      << "the theory has its name";
}

// A picture of cells has no seams, and stays one of cells when it is shown larger.
TEST(StabilityPlot, CellsAreAnImageThatStaysSharp) {
  const std::string svg = testing::svg_of(overview_plot(maps_of(3), heading));
  std::size_t images = 0;
  for (std::size_t at = svg.find("<image "); at != std::string::npos; at = svg.find("<image ", at + 1)) {
    ++images;
    EXPECT_NE(svg.substr(at, 120).find("image-rendering:pixelated"), std::string::npos);
  }
  EXPECT_EQ(images, 3U + 2U) << "a map each, and two in the legend";
}

}  // namespace
}  // namespace taut
