#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "figure_layout.h"
#include "output/chart_figure.h"
#include "output/plot_colour.h"
#include "plot_texts.h"

namespace taut {
namespace {

// So many curves that all end at the same, topmost point, with names as long as they come.
ChartFigure crowded(int curves) {
  ChartFigure figure;
  figure.title = "A title";
  figure.subtitle = "and what stands below it";
  figure.x_label = "position error / size (size = 1.23e+04 m)";
  figure.y_label = "processor time (s)";
  figure.note = "12 of 34 cases, the others are still to be run; looked at until 1.42 s of 10 s";
  for (int i = 0; i < curves; ++i)
    figure.curves.push_back({fmt::format("spring-implicit {}", i),
                             static_cast<std::size_t>(i),
                             i % 2 == 1,
                             {{1.0, 0.01, true}, {0.1, 0.02 + 0.02 * i, true}, {0.001, 1.0, true}}});
  return figure;
}

// Curves as steep as those of four orders, with their front named.
ChartFigure of_orders() {
  ChartFigure figure = crowded(0);
  for (const int order : {1, 2, 4, 8}) {
    FigureCurve curve{fmt::format("of order {}", order), static_cast<std::size_t>(order), false, {}};
    for (int halving = 0; halving < 12; ++halving)
      curve.points.push_back({std::pow(0.5, order * halving), 1e-4 * std::exp2(halving), true});
    figure.curves.push_back(curve);
  }
  for (const FigurePoint& point : figure.curves.back().points)
    figure.front.push_back({point.x, point.y, "61440/s × 256"});
  figure.level = FigureLevel{2.0, "real time: 2 s of motion in 2 s"};
  return figure;
}

std::vector<ChartFigure> figures() {
  std::vector<ChartFigure> all{crowded(1), crowded(5), crowded(14), of_orders(), ChartFigure{}};
  all.back().title = "empty";
  for (const double level : {1e-9, 0.3, 1e9}) {
    all.push_back(crowded(5));
    all.back().level = FigureLevel{level, "real time"};
  }
  return all;
}

TEST(ChartFigure, ShowsAllOfItsTextsApartAndWithinThePicture) {
  for (const ChartFigure& figure : figures()) {
    const PlotScript script = figure_script(figure);
    const std::vector<testing::PlotTextShown> texts = testing::texts_of(testing::svg_of(script));
    testing::expect_texts_apart(texts, script.size);
    for (const FigureCurve& curve : figure.curves)
      EXPECT_EQ(std::ranges::count(texts, curve.name, &testing::PlotTextShown::text), 1) << curve.name;
  }
}

TEST(ChartFigure, EveryTextCanBeReadOnWhite) {
  for (const testing::PlotTextShown& text : testing::texts_of(testing::svg_of(figure_script(crowded(9)))))
    EXPECT_GE(contrast_ratio(text.colour, "#ffffff"), 4.5) << text.text;
}

// gnuplot's own size of markers in an SVG grows with its letters.
TEST(ChartFigure, MarkersAreSmallInTheSvgToo) {
  const std::string svg = testing::svg_of(figure_script(crowded(9)));
  int markers = 0;
  for (std::size_t at = svg.find(") scale("); at != std::string::npos; at = svg.find(") scale(", at + 1)) {
    const double radius = std::stod(svg.substr(at + 8));
    EXPECT_GT(radius, 4.0);
    EXPECT_LT(radius, 10.0);
    ++markers;
  }
  EXPECT_GE(markers, 9 * (3 + 1)) << "three points each, and one in the margin";
}

TEST(ChartFigure, NamesStandInTheMarginInTheOrderOfTheirEnds) {
  const FigureLayout layout = layout_of(of_orders());
  ASSERT_EQ(layout.names.size(), 4U);
  for (const NameTag& a : layout.names)
    for (const NameTag& b : layout.names)
      if (a.point_y > b.point_y) {
        EXPECT_GE(a.y - b.y, text_height(figure_name_letters) - 1e-6);
      }
}

TEST(ChartFigure, GuidesAreAsSteepAsCurvesOfTheirOrder) {
  const ChartFigure figure = of_orders();
  const FigureLayout layout = layout_of(figure);
  ASSERT_EQ(layout.guides.size(), 3U);
  for (const OrderGuide& guide : layout.guides) {
    const auto curve =
        std::ranges::find(figure.curves, fmt::format("of {}", guide.name.text), &FigureCurve::name);
    ASSERT_NE(curve, figure.curves.end()) << guide.name.text;
    const FigurePoint &a = curve->points.front(), &b = curve->points.back();
    const double slope =
        (layout.y.pixel(b.y) - layout.y.pixel(a.y)) / (layout.x.pixel(b.x) - layout.x.pixel(a.x));
    EXPECT_NEAR((guide.line.to_y - guide.line.from_y) / (guide.line.to_x - guide.line.from_x), slope, 1e-9);
  }
}

TEST(ChartFigure, NothingStandsOverACurve) {
  for (const ChartFigure& figure : figures()) {
    const FigureLayout layout = layout_of(figure);
    std::vector<PlacedText> texts = layout.front;
    for (const OrderGuide& guide : layout.guides) texts.push_back(guide.name);
    for (const FigureCurve& curve : figure.curves)
      for (std::size_t i = 1; i < curve.points.size(); ++i) {
        const FigurePoint &a = curve.points[i - 1], &b = curve.points[i];
        const LabelLine line{layout.x.pixel(a.x), layout.y.pixel(a.y), layout.x.pixel(b.x),
                             layout.y.pixel(b.y)};
        for (const PlacedText& text : texts) EXPECT_FALSE(meets(text.box, line)) << text.text;
      }
  }
}

TEST(ChartFigure, DrawsALineAtItsLevelUnlessThatIsFarOff) {
  ChartFigure figure = crowded(2);
  figure.level = FigureLevel{3.0, "real time"};
  const FigureLayout layout = layout_of(figure);
  EXPECT_TRUE(layout.level_within);
  EXPECT_LT(layout.y.pixel(3.0), layout.height);
  EXPECT_EQ(layout.level.value_or(PlacedText{}).text, "real time");
  figure.level->y = 1e6;
  EXPECT_FALSE(layout_of(figure).level_within);
  EXPECT_EQ(layout_of(figure).level.value_or(PlacedText{}).text, "↑ real time");
}

}  // namespace
}  // namespace taut
