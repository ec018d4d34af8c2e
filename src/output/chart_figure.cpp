#include "output/chart_figure.h"

#include <fmt/format.h>

#include <cmath>

#include "figure_layout.h"
#include "output/plot_colour.h"

namespace taut {
namespace {

constexpr double room_left = 200, room_above = 150, room_below = 245;  // pixels around the plot
constexpr double page_margin = 30;                                     // pixels
constexpr std::string_view faint_grey = "#8c8c8c";                     // of leaders and guides

std::string data_block(const std::string& name, const std::vector<std::pair<double, double>>& points) {
  std::string block = fmt::format("${} << EOD\n", name);
  for (const auto& [x, y] : points) block += fmt::format("{:.9g} {:.9g}\n", x, y);
  return block + "EOD\n";
}

// The whole picture; places on it as gnuplot's screen coordinates.
struct Canvas {
  const FigureLayout& layout;

  int width() const { return static_cast<int>(std::ceil(room_left + layout.width + layout.margin)); }
  int height() const { return static_cast<int>(room_above + layout.height + room_below); }
  std::string at(double x, double y) const {
    return fmt::format("screen {:.5f},{:.5f}", (room_left + x) / width(), (room_below + y) / height());
  }
};

std::string label(const Canvas& canvas, std::string_view text, double x, double y, std::string_view how,
                  std::string_view colour, int letters) {
  return fmt::format("set label {} at {} {} front font ',{}' tc rgb '{}'\n", plot_text(text), canvas.at(x, y),
                     how, letters, colour);
}

std::string label(const Canvas& canvas, const PlacedText& text) {
  return label(canvas, text.text, text.box.left, 0.5 * (text.box.low + text.box.high), "left", plot_ink,
               figure_small_letters);
}

std::string line(const Canvas& canvas, const LabelLine& line, std::string_view how) {
  return fmt::format("set arrow from {} to {} nohead {}\n", canvas.at(line.from_x, line.from_y),
                     canvas.at(line.to_x, line.to_y), how);
}

// How the markers of a curve are drawn: a filled one, then its outline, each of a size times `size`.
std::vector<std::string> markers_of(const FigureCurve& curve, double size) {
  const PlotMarker marker = plot_marker(curve.style);
  const std::string_view colour = plot_colour(curve.style);
  if (marker.filled == marker.open)
    return {fmt::format("pt {} ps {:.3g}*marker lw 4 lc rgb '{}'", marker.open, size, colour)};
  return {fmt::format("pt {} ps {:.3g}*marker lc rgb '{}'", marker.filled, size,
                      curve.variant > 0 ? std::string_view("#ffffff") : colour),
          fmt::format("pt {} ps {:.3g}*marker lw 3 lc rgb '{}'", marker.open, size, colour)};
}

std::string dashes_of(const FigureCurve& curve) {
  return curve.variant == 0 ? "dt 1" : curve.variant == 1 ? "dt (11,7)" : "dt (3,4)";
}

constexpr double marker_size = 2.0;

// From a curve's end across to the margin, up or down to the name, a piece of the curve, and the name.
std::string name_commands(const ChartFigure& figure, const FigureLayout& layout, const Canvas& canvas) {
  std::string commands;
  for (const NameTag& tag : layout.names) {
    const FigureCurve& curve = figure.curves[tag.curve];
    const std::string_view colour = plot_colour(curve.style);
    const std::string thin = fmt::format("back lw 1.2 lc rgb '{}'", faint_grey);
    const double bend = layout.width + 8.0, sample = layout.width + figure_leader;
    if (bend - tag.point_x > 20.0)
      commands += line(canvas, {tag.point_x + 14.0, tag.point_y, bend, tag.point_y}, thin);
    commands += line(canvas, {bend, tag.point_y, sample - 6.0, tag.y}, thin);
    commands += line(canvas, {sample, tag.y, sample + figure_sample, tag.y},
                     fmt::format("front lw 4 {} lc rgb '{}'", dashes_of(curve), colour));
    for (const std::string& marker : markers_of(curve, marker_size))
      commands += fmt::format("set label '' at {} front point {}\n",
                              canvas.at(sample + 0.5 * figure_sample, tag.y), marker);
    commands += label(canvas, curve.name, sample + figure_sample + figure_name_gap, tag.y, "left",
                      plot_text_colour(curve.style), figure_name_letters);
  }
  return commands;
}

std::string guide_commands(const FigureLayout& layout, const Canvas& canvas) {
  std::string commands;
  for (const OrderGuide& guide : layout.guides) {
    commands += line(canvas, guide.line, fmt::format("back lw 2 lc rgb '{}'", faint_grey));
    commands += label(canvas, guide.name);
  }
  return commands;
}

std::string level_commands(const ChartFigure& figure, const FigureLayout& layout, const Canvas& canvas) {
  if (!layout.level) return "";
  std::string commands;
  if (layout.level_within) {
    const double y = layout.y.pixel(figure.level->y);
    commands +=
        line(canvas, {0.0, y, layout.width, y}, fmt::format("back lw 2.5 dt (3,4) lc rgb '{}'", plot_ink));
  }
  return commands + label(canvas, *layout.level);
}

std::string text_commands(const ChartFigure& figure, const FigureLayout& layout, const Canvas& canvas) {
  const double start = page_margin - room_left, top = layout.height + room_above;
  std::string commands =
      label(canvas, figure.title, start, top - 45.0, "left", plot_ink, plot_letters + 6) +
      label(canvas, figure.subtitle, start, top - 102.0, "left", plot_ink, figure_name_letters) +
      label(canvas, figure.x_label, 0.5 * layout.width, -122.0, "center", plot_ink, plot_letters) +
      label(canvas, figure.y_label, 38.0 - room_left, 0.5 * layout.height, "center rotate by 90", plot_ink,
            plot_letters) +
      label(canvas, figure.note, start, 32.0 - room_below, "left", plot_ink, figure_small_letters);
  commands += label(canvas, "more accurate →", layout.width, -170.0, "right", plot_ink, figure_small_letters);
  return commands;
}

// Marks at powers of ten and small ones between them. Where an axis has fewer than two powers, twice and five
// times them say how large it is, too.
// `room`: pixels that a text takes along the axis.
std::string tic_commands(char axis, const FigureAxis& range, double room) {
  constexpr double few = 1.7;  // decades
  const bool plain = range.decades() < few;
  const int stride = static_cast<int>(std::ceil(room * range.decades() / std::abs(range.to - range.from)));
  std::string tics;
  for (int power = static_cast<int>(std::floor(std::log10(range.low))); power <= std::log10(range.high);
       ++power)
    for (int digit = 1; digit < 10; ++digit) {
      const double value = digit * std::pow(10.0, power);
      if (value < range.low || value > range.high) continue;
      const bool named = plain ? digit == 1 || digit == 2 || digit == 5 : digit == 1 && power % stride == 0;
      const std::string text = !named  ? ""
                               : plain ? fmt::format("{:g}", value)
                                       : fmt::format("10^{{{}}}", power);
      tics += fmt::format("{}'{}' {:.9g} {}", tics.empty() ? "" : ", ", text, value, named ? 0 : 1);
    }
  return fmt::format("set {}tics font ',{}' ({})\n", axis, figure_name_letters, tics);
}

std::string axis_commands(const FigureLayout& layout, const Canvas& canvas) {
  const double width = canvas.width(), height = canvas.height();
  return fmt::format("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n", room_left / width,
                     (room_left + layout.width) / width) +
         fmt::format("set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n",
                     (room_below + layout.height) / height, room_below / height) +
         fmt::format("set logscale xy\nset xrange [{:.9g}:{:.9g}]\nset yrange [{:.9g}:{:.9g}]\n",
                     layout.x.high, layout.x.low, layout.y.low, layout.y.high) +
         tic_commands('x', layout.x, 105.0) + tic_commands('y', layout.y, 60.0);
}

// The curves as data, and the command that plots them: the front and faint dots, then lines, then markers.
std::string curve_commands(const ChartFigure& figure) {
  std::vector<std::pair<double, double>> front;
  for (const FigureLabel& point : figure.front) front.emplace_back(point.x, point.y);
  std::string data = data_block("front", front);
  std::string dots_drawn = "plot $front with lines lw 16 lc rgb '#e4e4e4'", lines_drawn, markers_drawn;
  for (std::size_t i = 0; i < figure.curves.size(); ++i) {
    const FigureCurve& curve = figure.curves[i];
    std::vector<std::pair<double, double>> on_line, dots;
    for (const FigurePoint& point : curve.points)
      (point.on_line ? on_line : dots).emplace_back(point.x, point.y);
    const std::string_view colour = plot_colour(curve.style);
    if (!dots.empty()) {
      data += data_block(fmt::format("dots{}", i), dots);
      dots_drawn +=
          fmt::format(", \\\n $dots{} with points pt 7 ps 0.8*marker lc rgb '#90{}'", i, colour.substr(1));
    }
    if (on_line.empty()) continue;
    data += data_block(fmt::format("line{}", i), on_line);
    lines_drawn += fmt::format(", \\\n $line{} with lines lw 4 {} lc rgb '{}'", i, dashes_of(curve), colour);
    for (const std::string& marker : markers_of(curve, marker_size))
      markers_drawn += fmt::format(", \\\n $line{} with points {}", i, marker);
  }
  return data + dots_drawn + lines_drawn + markers_drawn + "\n";
}

}  // namespace

PlotScript figure_script(const ChartFigure& figure) {
  const FigureLayout layout = layout_of(figure);
  const Canvas canvas{layout};
  std::string commands = axis_commands(layout, canvas) + text_commands(figure, layout, canvas) +
                         guide_commands(layout, canvas) + level_commands(figure, layout, canvas) +
                         name_commands(figure, layout, canvas);
  for (const PlacedText& text : layout.front) commands += label(canvas, text);
  return {commands + curve_commands(figure), {canvas.width(), canvas.height()}};
}

}  // namespace taut
