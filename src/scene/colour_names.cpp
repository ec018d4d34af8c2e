#include "colour_names.h"

#include <array>
#include <cstddef>

namespace taut {
namespace {

// Picked so that they stay apart in this program's light, on pale ground and on dark.
constexpr std::array<std::string_view, 16> palette_names{
    "black", "grey",  "silver", "white", "red",  "orange", "gold", "yellow",
    "olive", "green", "teal",   "sky",   "blue", "violet", "pink", "brown"};
constexpr std::array<Colour, palette_names.size()> palette_colours{
    Colour{0.09, 0.09, 0.10}, Colour{0.45, 0.47, 0.50}, Colour{0.74, 0.76, 0.79}, Colour{0.95, 0.95, 0.94},
    Colour{0.76, 0.16, 0.16}, Colour{0.90, 0.47, 0.13}, Colour{0.80, 0.58, 0.18}, Colour{0.95, 0.81, 0.24},
    Colour{0.48, 0.52, 0.20}, Colour{0.22, 0.56, 0.27}, Colour{0.10, 0.52, 0.53}, Colour{0.36, 0.66, 0.88},
    Colour{0.15, 0.33, 0.68}, Colour{0.46, 0.29, 0.66}, Colour{0.90, 0.50, 0.62}, Colour{0.45, 0.29, 0.17}};

}  // namespace

std::optional<Colour> colour_named(std::string_view name) {
  for (std::size_t i = 0; i < palette_names.size(); ++i)
    if (palette_names.at(i) == name) return palette_colours.at(i);
  return std::nullopt;
}

std::span<const std::string_view> colour_names() {
  return palette_names;
}

}  // namespace taut
