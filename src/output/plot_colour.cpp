#include "output/plot_colour.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace taut {
namespace {

constexpr std::array<std::string_view, plot_styles> palette{
    "#0a8cd9",  // sky blue
    "#c48807",  // orange
    "#006f4f",  // bluish green
    "#5c178a",  // violet
    "#8f3c00",  // vermilion, darkened
    "#0575a1",  // blue
    "#000000",  // black
    "#867b00",  // yellow, darkened
    "#7f255d",  // reddish purple
};

// Triangle down, square, circle, diamond, triangle up, pentagon; then star, plus and cross.
constexpr std::array<PlotMarker, plot_styles> markers{
    {{11, 10}, {5, 4}, {7, 6}, {13, 12}, {9, 8}, {15, 14}, {3, 3}, {1, 1}, {2, 2}}};

constexpr double letters_need = 4.5;  // WCAG 2.1, 1.4.3

// From 0 to 255 each.
std::array<int, 3> parts_of(std::string_view colour) {
  std::array<int, 3> parts{};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const char* digits = colour.data() + 1 + 2 * i;
    std::from_chars(digits, digits + 2, parts[i], 16);
  }
  return parts;
}

// Light that an sRGB colour gives, as seen, of that of white.
double luminance(std::string_view colour) {
  constexpr std::array weights{0.2126, 0.7152, 0.0722};
  const std::array<int, 3> parts = parts_of(colour);
  double sum = 0.0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double share = parts[i] / 255.0;
    sum += weights[i] * (share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4));
  }
  return sum;
}

}  // namespace

std::string_view plot_colour(std::size_t i) {
  return palette[i % palette.size()];
}

std::string plot_text_colour(std::size_t i) {
  std::array<int, 3> parts = parts_of(plot_colour(i));
  for (;;) {
    std::string colour = fmt::format("#{:02x}{:02x}{:02x}", parts[0], parts[1], parts[2]);
    if (contrast_ratio(colour, "#ffffff") >= letters_need) return colour;
    for (int& part : parts) part = part * 19 / 20;
  }
}

PlotMarker plot_marker(std::size_t i) {
  return markers[i % markers.size()];
}

double contrast_ratio(std::string_view a, std::string_view b) {
  const auto [darker, lighter] = std::minmax({luminance(a), luminance(b)});
  return (lighter + 0.05) / (darker + 0.05);
}

double lightness(std::string_view colour) {
  const double light = luminance(colour);
  return light > 216.0 / 24389.0 ? 116.0 * std::cbrt(light) - 16.0 : light * 24389.0 / 27.0;
}

}  // namespace taut
