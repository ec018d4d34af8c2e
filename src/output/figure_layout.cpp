#include "figure_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace taut {
namespace {

constexpr double figure_plot_width = 1120.0, figure_plot_height = 860.0;  // pixels
constexpr double marker_reach = 11.0;                                     // pixels around a point
constexpr double furthest_level = 1.5;  // decades that a plot is made higher for its level
constexpr double guide_length = 190.0;  // pixels

struct Range {
  double low = std::numeric_limits<double>::max(), high = 0.0;

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  // Wider by shares of its decades at both ends, and never less than half a decade.
  void widen(double below, double above) {
    const double decades = std::max(0.5, std::log10(high / low));
    low *= std::pow(10.0, -below * decades);
    high *= std::pow(10.0, above * decades);
  }
};

void set_axes(const ChartFigure& figure, FigureLayout& layout) {
  Range x, y;
  for (const FigureCurve& curve : figure.curves)
    for (const FigurePoint& point : curve.points) {
      x.include(point.x);
      y.include(point.y);
    }
  if (x.high == 0.0) x = y = {0.1, 1.0};
  x.widen(0.05, 0.05);
  if (figure.level) {
    const double off = std::max(std::log10(figure.level->y / y.high), std::log10(y.low / figure.level->y));
    layout.level_within = off < furthest_level;
    if (layout.level_within) y.include(figure.level->y);
  }
  y.widen(0.09, 0.07);
  layout.x = {x.low, x.high, layout.width, 0.0};
  layout.y = {y.low, y.high, 0.0, layout.height};
}

// The markers and lines of all curves.
struct Ink {
  std::vector<LabelBox> markers;
  std::vector<LabelLine> lines;

  bool meets(const LabelBox& box) const {
    return std::ranges::any_of(markers, [&](const LabelBox& marker) { return marker.meets(box); }) ||
           std::ranges::any_of(lines, [&](const LabelLine& line) { return taut::meets(box, line); });
  }
};

Ink ink_of(const ChartFigure& figure, const FigureLayout& layout) {
  Ink ink;
  for (const FigureCurve& curve : figure.curves) {
    const FigurePoint* last = nullptr;
    for (const FigurePoint& point : curve.points) {
      const double x = layout.x.pixel(point.x), y = layout.y.pixel(point.y);
      const double reach = point.on_line ? marker_reach : 0.5 * marker_reach;
      ink.markers.push_back({x - reach, x + reach, y - reach, y + reach});
      if (!point.on_line) continue;
      if (last != nullptr) ink.lines.push_back({layout.x.pixel(last->x), layout.y.pixel(last->y), x, y});
      last = &point;
    }
  }
  if (layout.level_within) {
    const double y = layout.y.pixel(figure.level->y);
    ink.lines.push_back({0.0, y, layout.width, y});
  }
  return ink;
}

PlacedText placed(const std::string& text, double left, double middle, int letters) {
  const double half = 0.5 * text_height(letters);
  return {text, {left, left + text_width(text, letters), middle - half, middle + half}};
}

// Beyond the plot's right edge every name stands at the height of its curve's end, or near it.
void place_names(const ChartFigure& figure, FigureLayout& layout) {
  std::vector<double> wanted;
  double widest = 0.0;
  for (std::size_t i = 0; i < figure.curves.size(); ++i) {
    const FigurePoint* end = nullptr;
    for (const FigurePoint& point : figure.curves[i].points)
      if (point.on_line && (end == nullptr || point.x < end->x)) end = &point;
    if (end == nullptr) continue;
    layout.names.push_back({i, layout.x.pixel(end->x), layout.y.pixel(end->y), 0.0});
    wanted.push_back(layout.names.back().point_y);
    widest = std::max(widest, text_width(figure.curves[i].name, figure_name_letters));
  }
  const double gap = text_height(figure_name_letters);
  const std::vector<double> places = spread_apart(wanted, gap, 0.5 * gap, layout.height - 0.5 * gap);
  for (std::size_t i = 0; i < places.size(); ++i) layout.names[i].y = places[i];
  layout.margin = figure_leader + figure_sample + figure_name_gap + widest + 20.0;
}

// Below and right of its point, where nothing is, for no point is better; those that find no room are left
// out.
void place_front(const ChartFigure& figure, const Ink& ink, FigureLayout& layout) {
  for (const FigureLabel& label : figure.front) {
    if (label.text.empty()) continue;
    const PlacedText text =
        placed(label.text, layout.x.pixel(label.x) + 13.0,
               layout.y.pixel(label.y) - 0.75 * text_height(figure_small_letters), figure_small_letters);
    const bool free = text.box.right < layout.width && text.box.low > 0.0 && !ink.meets(text.box) &&
                      std::ranges::none_of(
                          layout.front, [&](const PlacedText& other) { return other.box.meets(text.box); });
    if (free) layout.front.push_back(text);
  }
}

bool is_free(const LabelBox& box, const Ink& ink, const FigureLayout& layout) {
  return !ink.meets(box) &&
         std::ranges::none_of(layout.front, [&](const PlacedText& other) { return other.box.meets(box); }) &&
         !(layout.level && layout.level->box.meets(box));
}

// Over its line, at the first place from the right that is free; at the plot's upper or lower edge where the
// line lies beyond it.
void place_level(const ChartFigure& figure, const Ink& ink, FigureLayout& layout) {
  if (!figure.level) return;
  const double line = layout.y.pixel(figure.level->y), half = 0.5 * text_height(figure_small_letters);
  std::string text = figure.level->text;
  if (!layout.level_within) text = (line > layout.height ? "↑ " : "↓ ") + text;
  const double width = text_width(text, figure_small_letters);
  const auto at = [&](double left, double middle) {
    return placed(text, left, std::clamp(middle, half + 2.0, layout.height + half), figure_small_letters);
  };
  layout.level = at(layout.width - width, line + half + 3.0);
  for (double left = layout.width - width; left >= 0.0; left -= 20.0)
    for (const double middle : {line + half + 3.0, line - half - 3.0})
      if (const PlacedText place = at(left, middle); !ink.meets(place.box)) {
        layout.level = place;
        return;
      }
}

// Guides from a point at the lower left of a box that holds them and their names.
std::vector<OrderGuide> guides_from(double left, double low, const FigureLayout& layout) {
  const double per_decade_x = layout.width / layout.x.decades();
  const double per_decade_y = layout.height / layout.y.decades();
  constexpr std::array orders{4, 2, 1};
  std::vector<OrderGuide> guides;
  std::vector<double> ends;
  for (const int order : orders) {
    const double slope = per_decade_y / per_decade_x / order, across = guide_length / std::hypot(1.0, slope);
    guides.push_back({{left, low, left + across, low + slope * across}, {}});
    ends.push_back(low + slope * across);
  }
  const double gap = text_height(figure_small_letters);
  const std::vector<double> middles = spread_apart(ends, gap, low, std::numeric_limits<double>::max());
  for (std::size_t i = 0; i < guides.size(); ++i)
    guides[i].name = placed(orders[i] == 1   ? "order 1"
                            : orders[i] == 2 ? "order 2"
                                             : "order 4",
                            guides[i].line.to_x + 10.0, middles[i], figure_small_letters);
  return guides;
}

LabelBox box_of(const std::vector<OrderGuide>& guides) {
  LabelBox box{guides[0].line.from_x, guides[0].line.to_x, guides[0].line.from_y, guides[0].line.to_y};
  for (const OrderGuide& guide : guides) {
    box.right = std::max(box.right, guide.name.box.right);
    box.low = std::min(box.low, guide.name.box.low);
    box.high = std::max(box.high, guide.name.box.high);
  }
  return box;
}

// In a corner of the plot that is free, the lower right one if it is; false where there is none.
bool place_guides(const Ink& ink, FigureLayout& layout) {
  constexpr double edge = 8.0, step = 24.0;
  const LabelBox size = box_of(guides_from(0.0, 0.0, layout));
  for (double low = edge - size.low; low < 0.35 * layout.height; low += step)
    for (double left = layout.width - size.right - edge; left > edge; left -= step) {
      std::vector<OrderGuide> guides = guides_from(left, low, layout);
      if (!is_free(box_of(guides), ink, layout)) continue;
      layout.guides = std::move(guides);
      return true;
    }
  return false;
}

}  // namespace

double FigureAxis::pixel(double value) const {
  return from + (to - from) * std::log(value / low) / std::log(high / low);
}

double FigureAxis::decades() const {
  return std::log10(high / low);
}

FigureLayout layout_of(const ChartFigure& figure) {
  FigureLayout layout;
  layout.width = figure_plot_width;
  layout.height = figure_plot_height;
  set_axes(figure, layout);
  constexpr int most_tries = 8;
  for (int tries = 0; tries < most_tries; ++tries) {
    layout.names.clear();
    layout.front.clear();
    layout.level.reset();
    const Ink ink = ink_of(figure, layout);
    place_names(figure, layout);
    place_front(figure, ink, layout);
    place_level(figure, ink, layout);
    if (!figure.orders || place_guides(ink, layout)) break;
    // Below all that is drawn there is always room: as much more of it as it takes.
    layout.y.low *= std::pow(10.0, -0.06 * layout.y.decades());
  }
  return layout;
}

}  // namespace taut
