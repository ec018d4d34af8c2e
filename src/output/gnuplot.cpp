#include "output/gnuplot.h"

#include <fmt/format.h>

#include <array>
#include <span>

#include "base/failure.h"
#include "output/atomic_file.h"
#include "output/child_process.h"

namespace taut {
namespace {

constexpr std::string_view font = "DejaVu Sans";

constexpr std::array<std::string_view, 8> palette{
    "#0072b2",  // blue
    "#d55e00",  // vermilion
    "#009e73",  // bluish green
    "#cc79a7",  // reddish purple
    "#e69f00",  // orange
    "#56b4e9",  // sky blue
    "#000000",  // black
    "#b8a900",  // yellow, darkened: the original can't be read on white
};

std::filesystem::path gnuplot_program() {
  if (auto program = find_program("gnuplot")) return *program;
  throw RunFailure(
      "a plot needs the program gnuplot, which is not on the PATH; on Debian: apt-get install gnuplot-nox");
}

// In single quotes a quote is doubled and a backslash is itself.
std::string single_quoted(std::string_view text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
  return result + "'";
}

std::string png_terminal(Size size) {
  return fmt::format("set terminal pngcairo enhanced background '#ffffff' size {},{} font '{},{}'\n",
                     size.width, size.height, font, plot_letters);
}

std::string svg_terminal(Size size) {
  return fmt::format("set terminal svg enhanced background '#ffffff' size {},{} font '{},{}'\n", size.width,
                     size.height, font, plot_letters);
}

void run_gnuplot(const std::string& terminal, const PlotScript& plot, const PendingFile& file) {
  const std::string script =
      fmt::format("{}set output {}\n{}{}\nunset output\n", terminal,
                  single_quoted(file.temporary_name().string()), plot_style(), plot.commands);
  // Without the user's own settings: the same plot everywhere.
  ChildProcess gnuplot(gnuplot_program(), {"--default-settings"});
  const bool fed = gnuplot.feed(std::as_bytes(std::span(script)));
  const ProcessEnd end = gnuplot.finish();
  if (fed && end.status == 0) return;
  throw RunFailure(fmt::format(
      "gnuplot could not draw {}: {}", file.final_name().string(),
      end.last_lines.empty() ? fmt::format("it ended with status {}", end.status) : end.last_lines));
}

}  // namespace

std::string plot_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    // What gnuplot takes for markup.
    if (std::string_view("{}^_@&~\\").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c == '\n' ? ' ' : c;
  }
  return single_quoted(escaped);
}

std::string_view plot_colour(std::size_t i) {
  return palette[i % palette.size()];
}

std::string plot_style() {
  std::string style = "set encoding utf8\n";
  for (std::size_t i = 0; i < palette.size(); ++i)
    style += fmt::format("set linetype {0} lc rgb '{1}' lw 3 pt 7 ps 1.4\n", i + 1, palette[i]);
  style += fmt::format("set linetype cycle {}\n", palette.size());
  style += fmt::format("set border 3 lc rgb '{}' lw 1.5\n", plot_ink);
  style += fmt::format("set tics nomirror out scale 1.2 textcolor rgb '{}'\n", plot_ink);
  style += fmt::format("set grid xtics ytics lt 1 lc rgb '{}' lw 1.2\n", plot_light_ink);
  style += fmt::format("set title tc rgb '{}'\n", plot_ink);
  style += fmt::format("set xlabel tc rgb '{0}'\nset ylabel tc rgb '{0}'\n", plot_ink);
  style += "unset key\n";
  return style;
}

void require_gnuplot() {
  gnuplot_program();
}

void write_plot(const PlotScript& plot, const std::filesystem::path& stem) {
  PendingFile png(stem.string() + ".png"), svg(stem.string() + ".svg");
  run_gnuplot(png_terminal(plot.size), plot, png);
  run_gnuplot(svg_terminal(plot.size), plot, svg);
  png.commit();
  svg.commit();
}

}  // namespace taut
