#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/image.h"

namespace taut {

/// A plot as gnuplot commands, without terminal and output. The house style (plot_style()) comes before them.
struct PlotScript {
  std::string commands;
  Size size{1800, 1200};  ///< pixels of the PNG; letters keep their size, so a wider plot holds more
};

/// The text as a gnuplot string that shows it letter for letter, quotes included.
std::string plot_text(std::string_view text);

/// The i-th of eight colours that people with any kind of colour vision can tell apart, as #rrggbb; they
/// repeat from the ninth on. Line types 1 to 8 of gnuplot have them, too. (Okabe and Ito, Color Universal
/// Design, 2008.)
std::string_view plot_colour(std::size_t i);

/// The ink of axes and letters, and the light one of grids and of what is only hinted at, as #rrggbb.
inline constexpr std::string_view plot_ink = "#333333";
inline constexpr std::string_view plot_light_ink = "#dddddd";

/// Sizes of letters (pixels) that can still be read when a plot is shown at half its width.
inline constexpr int plot_letters = 30;
inline constexpr int plot_small_letters = 25;

/// The house style as gnuplot commands: colours, letters, a light grid, axes on two sides, no key (curves are
/// labelled where they are).
std::string plot_style();

/// Throws RunFailure when gnuplot is not installed: to be asked before work whose result is to be plotted.
void require_gnuplot();

/// Runs gnuplot twice, for `stem`.png and `stem`.svg; either both are there, complete, or both as they were.
/// Throws RunFailure with gnuplot's own words.
void write_plot(const PlotScript& plot, const std::filesystem::path& stem);

}  // namespace taut
