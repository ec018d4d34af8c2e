#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace taut {

// Colours of plots, as #rrggbb.

/// The ink of axes and letters, and the light one of grids and of what is only hinted at.
inline constexpr std::string_view plot_ink = "#333333";
inline constexpr std::string_view plot_light_ink = "#dddddd";

/// How many colours and markers differ; they repeat from there on.
inline constexpr std::size_t plot_styles = 9;

/// The i-th colour of lines and markers, to be seen on white (a contrast of 3 and more). Their hues follow
/// Okabe and Ito (Color Universal Design, 2008); each has a lightness of its own, so that they also differ
/// where all is grey, and for people with any kind of colour vision.
std::string_view plot_colour(std::size_t i);

/// The same, as dark as letters have to be: a contrast of 4.5 on white.
std::string plot_text_colour(std::size_t i);

/// The i-th marker as gnuplot's type of point.
struct PlotMarker {
  int filled;  ///< the same as `open` where the shape has no inside
  int open;
};
PlotMarker plot_marker(std::size_t i);

/// The contrast of two colours, from 1 to 21, as the Web Content Accessibility Guidelines 2.1 define it.
double contrast_ratio(std::string_view a, std::string_view b);

/// How light a colour looks, from 0 (black) to 100 (white): L* of CIE 1976, which is what is left of it in
/// grey.
double lightness(std::string_view colour);

}  // namespace taut
