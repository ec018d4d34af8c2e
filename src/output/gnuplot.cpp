#include "output/gnuplot.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <span>

#include "base/failure.h"
#include "output/atomic_file.h"
#include "output/child_process.h"
#include "output/plot_colour.h"
#include "output/png_check.h"

namespace taut {
namespace {

constexpr std::string_view font = "DejaVu Sans";

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

// Both terminals show letters and markers of the same size. Those of this one are letters of points, of which
// three make four pixels.
std::string png_terminal(Size size) {
  return fmt::format(
      "set terminal pngcairo enhanced background '#ffffff' size {},{} font '{},{}'\nmarker = 1\n", size.width,
      size.height, font, plot_letters);
}

// Here letters are of pixels, and markers grow with them.
std::string svg_terminal(Size size) {
  return fmt::format(
      "set terminal svg enhanced background '#ffffff' size {},{} font '{},{}' fontscale 1.3333\nmarker = "
      "0.31\n",
      size.width, size.height, font, plot_letters);
}

void run_gnuplot(const std::string& terminal, const PlotScript& plot, const PendingFile& file,
                 const StopTest& stop) {
  const std::string script =
      fmt::format("{}set output {}\n{}{}\nunset output\n", terminal,
                  single_quoted(file.temporary_name().string()), plot_style(), plot.commands);
  // Without the user's own settings: the same plot everywhere.
  ChildProcess gnuplot(gnuplot_program(), {"--default-settings"});
  const bool fed = gnuplot.feed(std::as_bytes(std::span(script)), stop);
  const ProcessEnd end = gnuplot.finish(stop);
  if (fed && end.status == 0) return;
  throw RunFailure(fmt::format("gnuplot could not draw {}: {}", file.final_name().string(),
                               end.last_lines.empty() ? end_text(end) : end.last_lines));
}

// On a full disk gnuplot ends with status 0, too.
[[noreturn]] void not_whole(const PendingFile& file) {
  throw RunFailure(fmt::format("gnuplot could not draw {}: what it made is cut short or blank",
                               file.final_name().string()));
}

void check_png(const PendingFile& file, Size size) {
  if (!is_whole_png(file.temporary_name(), size) || is_blank_png(file.temporary_name())) not_whole(file);
}

void check_svg(const PendingFile& file, std::string_view text) {
  const std::size_t end = text.find_last_not_of(" \n");
  const bool whole = text.substr(0, end == std::string_view::npos ? 0 : end + 1).ends_with("</svg>");
  const bool drawn = text.find("<path ") != std::string_view::npos;
  if (!whole || !drawn) not_whole(file);
}

// Cells of an image are to stay sharp however large a viewer shows them.
std::string with_sharp_images(std::string text) {
  constexpr std::string_view begin = "<image ",
                             sharp = "style='image-rendering:optimizeSpeed;image-rendering:pixelated' ";
  for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1))
    text.insert(at + begin.size(), sharp);
  return text;
}

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
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

std::string plot_style() {
  std::string style = "set encoding utf8\n";
  for (std::size_t i = 0; i < plot_styles; ++i)
    style += fmt::format("set linetype {} lc rgb '{}' lw 3 pt {} ps 1.8*marker\n", i + 1, plot_colour(i),
                         plot_marker(i).filled);
  style += fmt::format("set linetype cycle {}\n", plot_styles);
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

void write_plot(const PlotScript& plot, const std::filesystem::path& stem, const StopTest& stop) {
  PendingFile png(stem.string() + ".png"), svg(stem.string() + ".svg");
  run_gnuplot(png_terminal(plot.size), plot, png, stop);
  check_png(png, plot.size);
  run_gnuplot(svg_terminal(plot.size), plot, svg, stop);
  const std::string drawing = read_text(svg.temporary_name());
  check_svg(svg, drawing);
  svg.replace(with_sharp_images(drawing));
  png.commit();
  svg.commit();
}

}  // namespace taut
