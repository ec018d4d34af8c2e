#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <string>

#include "output/plot_colour.h"

namespace taut {
namespace {

TEST(PlotColour, ContrastAndLightnessAreThoseOfTheStandards) {
  EXPECT_NEAR(contrast_ratio("#000000", "#ffffff"), 21.0, 1e-9);
  EXPECT_NEAR(contrast_ratio("#ffffff", "#ffffff"), 1.0, 1e-9);
  EXPECT_NEAR(contrast_ratio("#ffffff", "#777777"), 4.48, 5e-3);
  EXPECT_NEAR(contrast_ratio("#0000ff", "#ffffff"), 8.59, 5e-3);
  EXPECT_NEAR(lightness("#ffffff"), 100.0, 1e-9);
  EXPECT_NEAR(lightness("#777777"), 50.03, 5e-3);
  EXPECT_NEAR(lightness("#ff0000"), 53.24, 5e-2);
}

TEST(PlotColour, LettersCanBeReadOnWhiteAndLinesBeSeen) {
  for (std::size_t i = 0; i < plot_styles; ++i) {
    EXPECT_GE(contrast_ratio(plot_text_colour(i), "#ffffff"), 4.5) << i;
    EXPECT_GE(contrast_ratio(plot_colour(i), "#ffffff"), 3.0) << i;
  }
  EXPECT_GE(contrast_ratio(plot_ink, "#ffffff"), 7.0);
}

TEST(PlotColour, StaysApartInGrey) {
  for (std::size_t i = 0; i < plot_styles; ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GE(std::abs(lightness(plot_colour(i)) - lightness(plot_colour(j))), 4.5) << i << " and " << j;
}

using Three = std::array<double, 3>;

double linear_part(std::string_view colour, std::size_t i) {
  const double share = std::stoi(std::string(colour.substr(1 + 2 * i, 2)), nullptr, 16) / 255.0;
  return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
}

Three lab(const Three& light) {
  const auto bent = [](double t) {
    return t > 216.0 / 24389.0 ? std::cbrt(t) : t * 841.0 / 108.0 + 4.0 / 29.0;
  };
  const double x = bent((0.4124 * light[0] + 0.3576 * light[1] + 0.1805 * light[2]) / 0.95047);
  const double y = bent(0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2]);
  const double z = bent((0.0193 * light[0] + 0.1192 * light[1] + 0.9505 * light[2]) / 1.08883);
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

// As someone sees it without the cones for green. (Machado, Oliveira and Fernandes, A Physiologically-based
// Model for Simulation of Color Vision Deficiency, 2009.)
Three seen_by_a_deuteranope(std::string_view colour) {
  constexpr std::array<Three, 3> rows{
      {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
  Three seen{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) seen[i] += rows[i][j] * linear_part(colour, j);
    seen[i] = std::clamp(seen[i], 0.0, 1.0);
  }
  return lab(seen);
}

TEST(PlotColour, StaysApartForADeuteranope) {
  for (std::size_t i = 0; i < plot_styles; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Three a = seen_by_a_deuteranope(plot_colour(i)), b = seen_by_a_deuteranope(plot_colour(j));
      EXPECT_GE(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 10.0) << i << " and " << j;
    }
}

TEST(PlotColour, EveryStyleHasAMarkerOfItsOwn) {
  std::set<int> shapes;
  for (std::size_t i = 0; i < plot_styles; ++i) {
    shapes.insert(plot_marker(i).filled);
    shapes.insert(plot_marker(i).open);
  }
  EXPECT_EQ(shapes.size(), 6U * 2U + 3U);
}

}  // namespace
}  // namespace taut
