#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/image.h"
#include "base/stop.h"

namespace taut {

/// A plot as gnuplot commands, without terminal and output. The house style (plot_style()) comes before them.
/// Sizes of points are to be multiplied by the variable `marker`: then they are the same in PNG and SVG.
struct PlotScript {
  std::string commands;
  Size size{1800, 1200};  ///< pixels of the PNG; letters keep their size, so a wider plot holds more
};

/// The text as a gnuplot string that shows it letter for letter, quotes included.
std::string plot_text(std::string_view text);

/// Sizes of letters (pixels) that can still be read when a plot is shown at half its width.
inline constexpr int plot_letters = 30;
inline constexpr int plot_small_letters = 25;

/// The house style as gnuplot commands: colours, letters, a light grid, axes on two sides, no key (curves are
/// labelled where they are).
std::string plot_style();

/// Throws RunFailure when gnuplot is not installed: to be asked before work whose result is to be plotted.
void require_gnuplot();

/// Runs gnuplot twice, for `stem`.png and `stem`.svg, and looks whether both are whole and show something
/// before either gets its name. Throws RunFailure with gnuplot's own words, and Interrupted.
void write_plot(const PlotScript& plot, const std::filesystem::path& stem, const StopTest& stop = {});

}  // namespace taut
