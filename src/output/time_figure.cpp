#include "output/time_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "output/label_layout.h"
#include "output/plot_colour.h"

namespace taut {
namespace {

constexpr double left = 210.0, above = 150.0, below = 150.0, name_gap = 16.0, edge = 30.0;  // pixels
constexpr double panel_width = 1200.0, panel_gap = 44.0;                                    // pixels

// The range of one coordinate of curves, with some room beyond.
struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void see(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void add_room(double share) {
    if (!(low <= high)) low = high = 0.0;
    const double size = high - low, least = 1e-9 * std::max(1.0, std::abs(high) + std::abs(low));
    const double room = size > least ? share * size : std::max(0.1 * std::abs(high), 1.0);
    low -= room;
    high += room;
  }
  double share(double value) const { return (value - low) / (high - low); }
};

Extent extent_of(const std::vector<PlainCurve>& curves, std::size_t coordinate) {
  Extent extent;
  for (const PlainCurve& curve : curves)
    for (const auto& point : curve.points) extent.see(point.at(coordinate));
  return extent;
}

// Where a plot lies on its page, in pixels from below.
struct Frame {
  double width, height;  // of the page
  double low, high;      // of the plot on it
  double right;

  std::string margins() const {
    return fmt::format(
        "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\n"
        "set bmargin at screen {:.6f}\nset tmargin at screen {:.6f}\n",
        left / width, right / width, low / height, high / height);
  }
  std::string at(double x, double y) const {
    return fmt::format("screen {:.6f},{:.6f}", x / width, y / height);
  }
};

std::string text_at(const Frame& frame, double x, double y, std::string_view how, std::string_view text,
                    int letters, std::string_view colour) {
  return fmt::format("set label {} at {} {} front font ',{}' tc rgb '{}'\n", plot_text(text), frame.at(x, y),
                     how, letters, colour);
}

std::string head(const Frame& page, const std::string& title, const std::string& subtitle) {
  return text_at(page, edge, page.height - 48.0, "left", title, plot_letters + 6, plot_ink) +
         text_at(page, edge, page.height - 102.0, "left", subtitle, plot_small_letters, plot_ink);
}

double room_for_names(const std::vector<PlainCurve>& curves) {
  double widest = 0.0;
  for (const PlainCurve& curve : curves)
    widest = std::max(widest, text_width(curve.name, plot_small_letters));
  return widest;
}

// Beside the right edge, each as near to its curve's end as the others leave it room.
std::string names(const Frame& frame, const std::vector<PlainCurve>& curves, const Extent& heights) {
  std::vector<double> wanted;
  wanted.reserve(curves.size());
  for (const PlainCurve& curve : curves)
    wanted.push_back(frame.low + heights.share(curve.points.back()[1]) * (frame.high - frame.low));
  const std::vector<double> places =
      spread_apart(wanted, text_height(plot_small_letters), frame.low, frame.high);
  std::string commands;
  for (std::size_t i = 0; i < curves.size(); ++i)
    commands += text_at(frame, frame.right + name_gap, places[i], "left", curves[i].name, plot_small_letters,
                        plot_text_colour(curves[i].style));
  return commands;
}

std::string data_of(const std::vector<PlainCurve>& curves, std::size_t panel) {
  std::string data;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    data += fmt::format("$p{}c{} << EOD\n", panel, i);
    for (const auto& point : curves[i].points) data += fmt::format("{:.9g} {:.9g}\n", point[0], point[1]);
    data += "EOD\n";
  }
  return data;
}

std::string lines_of(const std::vector<PlainCurve>& curves, std::size_t panel) {
  std::string commands;
  for (std::size_t i = 0; i < curves.size(); ++i)
    commands += fmt::format("{}$p{}c{} with lines lw 4 lc rgb '{}'", commands.empty() ? "plot " : ", \\\n ",
                            panel, i, plot_colour(curves[i].style));
  return commands;
}

// What is counted has no marks between whole numbers.
std::string marks_up(const std::vector<PlainCurve>& curves, const Extent& heights) {
  const bool counted = std::ranges::all_of(curves, [](const PlainCurve& curve) {
    return std::ranges::all_of(curve.points,
                               [](const auto& point) { return point[1] == std::floor(point[1]); });
  });
  return counted && heights.high - heights.low < 5.0 ? "set ytics 1\n" : "set ytics autofreq\n";
}

std::string ranges(const Extent& x, const Extent& y) {
  return fmt::format("set xrange [{:.9g}:{:.9g}]\nset yrange [{:.9g}:{:.9g}]\n", x.low, x.high, y.low,
                     y.high);
}

std::vector<PlainCurve> with_points(std::vector<PlainCurve> curves) {
  std::erase_if(curves, [](const PlainCurve& curve) { return curve.points.empty(); });
  return curves;
}

}  // namespace

PlotScript figure_script(const TimeFigure& figure) {
  std::vector<TimeFigure::Panel> panels = figure.panels;
  double names_wide = 0.0;
  Extent times;
  for (TimeFigure::Panel& panel : panels) {
    panel.curves = with_points(std::move(panel.curves));
    names_wide = std::max(names_wide, room_for_names(panel.curves));
    const Extent own = extent_of(panel.curves, 0);
    times.see(own.low);
    times.see(own.high);
  }
  if (!(times.high > times.low)) times.add_room(0.0);
  const auto count = static_cast<double>(panels.size());
  const double tall = panels.size() == 1 ? 640.0 : panels.size() == 2 ? 400.0 : 270.0;
  Frame frame{left + panel_width + name_gap + names_wide + edge,
              above + count * tall + (count - 1.0) * panel_gap + below, 0.0, 0.0, left + panel_width};
  std::string commands = "set multiplot\n" + head(frame, figure.title, figure.subtitle);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const std::vector<PlainCurve>& curves = panels[i].curves;
    frame.high = frame.height - above - static_cast<double>(i) * (tall + panel_gap);
    frame.low = frame.high - tall;
    Extent heights = extent_of(curves, 1);
    heights.add_room(0.07);
    const bool last = i + 1 == panels.size();
    commands += data_of(curves, i) + frame.margins() + ranges(times, heights) + marks_up(curves, heights) +
                fmt::format("set ytics font ',{0}'\nset xtics font ',{0}' format '{1}'\n", plot_small_letters,
                            last ? "%g" : "") +
                text_at(frame, 42.0, 0.5 * (frame.low + frame.high), "center rotate by 90", panels[i].label,
                        plot_small_letters, plot_ink) +
                names(frame, curves, heights);
    if (last)
      commands +=
          text_at(frame, left + 0.5 * panel_width, 36.0, "center", "time (s)", plot_letters, plot_ink);
    commands += lines_of(curves, i) + "\nunset label\n";
  }
  return {commands + "unset multiplot\n",
          {static_cast<int>(std::ceil(frame.width)), static_cast<int>(frame.height)}};
}

PlotScript figure_script(const PathFigure& figure) {
  const std::vector<PlainCurve> curves = with_points(figure.curves);
  Extent across = extent_of(curves, 0), up = extent_of(curves, 1);
  across.add_room(0.06);
  up.add_room(0.06);
  // One scale for both: the narrower one is given more room, up to a picture that is not too narrow.
  const double most_tall = 1000.0, least_tall = 420.0;
  double scale = panel_width / (across.high - across.low);
  const double tall = std::clamp(scale * (up.high - up.low), least_tall, most_tall);
  const auto widen = [](Extent& extent, double size) {
    const double room = 0.5 * (size - (extent.high - extent.low));
    extent.low -= room;
    extent.high += room;
  };
  scale = std::min(scale, tall / (up.high - up.low));
  widen(across, panel_width / scale);
  widen(up, tall / scale);
  const Frame frame{left + panel_width + name_gap + room_for_names(curves) + edge, above + tall + below,
                    below, below + tall, left + panel_width};
  std::string commands =
      head(frame, figure.title, figure.subtitle) + data_of(curves, 0) + frame.margins() + ranges(across, up) +
      fmt::format("set tics font ',{}'\n", plot_small_letters) +
      text_at(frame, left + 0.5 * panel_width, 36.0, "center", figure.x_label, plot_letters, plot_ink) +
      text_at(frame, 42.0, below + 0.5 * tall, "center rotate by 90", figure.y_label, plot_letters,
              plot_ink) +
      names(frame, curves, up);
  for (const PlainCurve& curve : curves) {
    const auto &first = curve.points.front(), &last = curve.points.back();
    commands += fmt::format("set label '' at {:.9g},{:.9g} front point pt 6 ps 2*marker lw 3 lc rgb '{}'\n",
                            first[0], first[1], plot_colour(curve.style));
    commands += fmt::format("set label '' at {:.9g},{:.9g} front point pt 7 ps 2.4*marker lc rgb '{}'\n",
                            last[0], last[1], plot_colour(curve.style));
  }
  return {commands + lines_of(curves, 0) + "\n",
          {static_cast<int>(std::ceil(frame.width)), static_cast<int>(std::ceil(frame.height))}};
}

}  // namespace taut
