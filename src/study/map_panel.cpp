#include "map_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "map_axis.h"
#include "map_cells.h"
#include "output/gnuplot.h"
#include "output/label_layout.h"
#include "output/plot_colour.h"

namespace taut {
namespace {

// Blocks of data, and the plot command that draws them one over the other.
class Drawn {
 public:
  void add(const std::string& points, std::string_view how) {
    if (points.empty()) return;
    data_ += fmt::format("$part{} << END\n{}END\n", count_, points);
    plots_ += fmt::format("{} $part{} {}", count_ == 0 ? "plot" : ", \\\n", count_, how);
    ++count_;
  }
  std::string text() const { return data_ + (count_ == 0 ? "plot NaN" : plots_) + "\n"; }

 private:
  std::string data_, plots_;
  int count_ = 0;
};

// A panel's cells and pixels.
struct PanelScale {
  const MapGrid& grid;
  double width, height;  // pixels

  double x(double value) const { return pixel(cell_place(grid.columns, value), grid.columns.size(), width); }
  double y(double value) const { return pixel(cell_place(grid.rows, value), grid.rows.size(), height); }

  static double pixel(double place, std::size_t cells, double length) {
    return (place + 0.5) / static_cast<double>(cells) * length;
  }
  static double place(double pixel, std::size_t cells, double length) {
    return pixel / length * static_cast<double>(cells) - 0.5;
  }
  // A place in pixels as the plot's coordinates.
  std::string at(double pixel_x, double pixel_y) const {
    return fmt::format("{:.5g} {:.5g}", place(pixel_x, grid.columns.size(), width),
                       place(pixel_y, grid.rows.size(), height));
  }
};

std::string image_of(const MapGrid& grid, const std::vector<std::size_t>& paints) {
  std::string text;
  for (std::size_t i = 0; i < paints.size(); ++i) {
    const std::size_t column = i % grid.columns.size(), row = i / grid.columns.size();
    text += image_cell(static_cast<double>(column), static_cast<double>(row), map_paint(paints[i]));
  }
  return text;
}

std::string hatched(const MapGrid& grid, const std::vector<std::size_t>& paints, std::size_t paint) {
  std::string text;
  for (const CellBox& box : boxes_of(paints, grid.columns.size(), paint)) {
    const auto column = static_cast<double>(box.column);
    const double bottom = static_cast<double>(box.first_row) - 0.5,
                 top = static_cast<double>(box.last_row) + 0.5;
    fmt::format_to(std::back_inserter(text), "{} {} {} {} {} {}\n", column, bottom, column - 0.5,
                   column + 0.5, bottom, top);
  }
  return text;
}

using Pixels = std::vector<std::pair<double, double>>;

// Of so many columns that circles would run into each other only some are marked.
Pixels edge_of(const MethodMap& map, const PanelScale& scale) {
  constexpr std::size_t most_marks = 14;
  const std::size_t stride = (map.columns.size() + most_marks - 1) / most_marks;
  Pixels points;
  for (std::size_t i = 0; i < map.columns.size(); i += stride)
    if (const MapColumn& column = map.columns[i]; column.edge)
      points.emplace_back(scale.x(column.value), scale.y(column.edge->value()));
  return points;
}

// The predicted edge; what lies below the map is drawn along its foot.
Pixels predicted_of(const MethodMap& map, const PanelScale& scale) {
  constexpr double foot = 6.0;  // pixels
  Pixels points;
  for (const MapColumn& column : map.columns)
    if (column.predicted)
      points.emplace_back(scale.x(column.value), std::max(scale.y(column.predicted->value), foot));
  return points;
}

std::string points_text(const Pixels& points, const PanelScale& scale) {
  std::string text;
  for (const auto& [x, y] : points) text += scale.at(x, y) + "\n";
  return text;
}

std::string box_text(const LabelBox& box, const PanelScale& scale) {
  const std::string low = scale.at(box.left, box.low), high = scale.at(box.right, box.high);
  const auto x = [](const std::string& place) { return place.substr(0, place.find(' ')); };
  const auto y = [](const std::string& place) { return place.substr(place.find(' ') + 1); };
  return fmt::format("{0} {1} {0} {2} {1} {3}\n", x(low), y(low), x(high), y(high));
}

std::string formula_of(const MethodMap& map) {
  for (const MapColumn& column : map.columns)
    if (column.predicted) return column.predicted->formula;
  return {};
}

// A place for the formula beside its line: within the panel, above the line if there is room, over neither
// the line nor a circle, and as far right as can be.
std::optional<LabelBox> formula_box(const std::string& formula, const Pixels& line, const Pixels& circles,
                                    const PanelScale& scale) {
  const double width = text_width(formula, map_text_letters) + 10.0, height = text_height(map_text_letters);
  constexpr double away = 12.0, step = 6.0, reach = 12.0;
  const auto free = [&](const LabelBox& box) {
    for (std::size_t i = 1; i < line.size(); ++i)
      if (meets(box, {line[i - 1].first, line[i - 1].second, line[i].first, line[i].second})) return false;
    return std::ranges::none_of(circles, [&](const auto& circle) {
      return box.meets(
          {circle.first - reach, circle.first + reach, circle.second - reach, circle.second + reach});
    });
  };
  std::optional<LabelBox> best;
  double nearest = infinity;
  for (double low = away; low + height <= scale.height - away; low += step)
    for (double left = scale.width - width - away; left >= away; left -= step) {
      const LabelBox box{left, left + width, low, low + height};
      double off = infinity;  // how far the box's middle is from the line
      for (const auto& [x, y] : line)
        off = std::min(off, std::hypot(x - 0.5 * (box.left + box.right), y - 0.5 * (box.low + box.high)) +
                                (0.5 * (box.low + box.high) < y ? 20.0 : 0.0));
      if (off < nearest && free(box)) {
        nearest = off;
        best = box;
      }
    }
  return best;
}

// What an empty panel says: the first part of the refusal.
std::string why_empty(const MethodMap& map) {
  for (const MapColumn& column : map.columns)
    if (!column.refusal.empty()) return column.refusal.substr(0, column.refusal.find(';'));
  return "no columns yet";
}

// One below the other in the middle of the panel, the text broken between words.
std::string lines_in_the_middle(const std::string& text, const PanelPlace& place) {
  std::vector<std::string> lines(1);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const std::string longer = lines.back().empty() ? word : fmt::format("{} {}", lines.back(), word);
    if (!lines.back().empty() && text_width(longer, map_text_letters) > 0.92 * (place.right - place.left))
      lines.push_back(word);
    else
      lines.back() = longer;
    begin = end + 1;
  }
  std::string labels;
  const double height = text_height(map_text_letters);
  double y = 0.5 * (place.bottom + place.top) + 0.5 * height * static_cast<double>(lines.size() - 1);
  for (const std::string& line : lines) {
    labels += page_label(place, line, 0.5 * (place.left + place.right), y, "center front", map_text_letters);
    y -= height;
  }
  return labels;
}

std::string marks_text(const std::vector<AxisMark>& marks, bool texts) {
  std::string text;
  for (const AxisMark& mark : marks)
    text += fmt::format("{}'{}' {:.5g} {}", text.empty() ? "" : ", ", texts ? mark.text : "", mark.place,
                        mark.text.empty() ? 1 : 0);
  return text;
}

std::string axes(const MapGrid& grid, const PanelPlace& place, const PanelTexts& texts) {
  constexpr double room_for_one = 84.0, room_above_one = 60.0;  // pixels
  const auto marks = [&](const std::vector<double>& values, bool plain, double length, double room) {
    return axis_marks(values, plain, std::max(2, static_cast<int>(length / room)));
  };
  const bool passes = grid.axes->rows == MapRows::passes;
  return fmt::format(
      "set xrange [-0.5:{}]\nset yrange [-0.5:{}]\nset xtics out nomirror offset 0,0.6 font ',{}' ({})\nset "
      "ytics out "
      "nomirror "
      "font ',{}' ({})\nunset grid\n",
      static_cast<double>(grid.columns.size()) - 0.5, static_cast<double>(grid.rows.size()) - 0.5,
      map_tic_letters,
      marks_text(marks(grid.columns, grid.axes->whole, place.right - place.left, room_for_one), texts.x),
      map_tic_letters,
      marks_text(marks(grid.rows, passes, place.top - place.bottom, room_above_one), texts.y));
}

}  // namespace

std::string margins(const PanelPlace& place) {
  return fmt::format(
      "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\nset bmargin at screen {:.6f}\nset tmargin "
      "at "
      "screen {:.6f}\n",
      place.left / place.page_width, place.right / place.page_width, place.bottom / place.page_height,
      place.top / place.page_height);
}

std::string page_label(const PanelPlace& page, std::string_view text, double x, double y,
                       std::string_view how, int letters) {
  return fmt::format("set label {} at screen {:.6f},{:.6f} {} font ',{}' tc rgb '{}'\n", plot_text(text),
                     x / page.page_width, y / page.page_height, how, letters, plot_ink);
}

std::string image_cell(double x, double y, std::string_view colour) {
  const auto part = [&](std::size_t first) {
    int value = 0;
    std::from_chars(colour.data() + first, colour.data() + first + 2, value, 16);
    return value;
  };
  return fmt::format("{} {} {} {} {}\n", x, y, part(1), part(3), part(5));
}

std::string map_panel(const StabilityMaps& maps, const MethodMap& map, const PanelPlace& place,
                      const PanelTexts& texts) {
  const MapGrid& grid = maps.grid;
  const PanelScale scale{grid, place.right - place.left, place.top - place.bottom};
  std::string script = margins(place) + axes(grid, place, texts);
  double y = place.top + 12.0 + 0.5 * text_height(map_title_letters);
  for (std::size_t i = texts.title.size(); i-- > 0; y += 0.85 * text_height(map_title_letters))
    script +=
        page_label(place, texts.title[i], 0.5 * (place.left + place.right), y, "center", map_title_letters);
  Drawn drawn;
  const bool empty =
      std::ranges::all_of(map.columns, [](const MapColumn& column) { return column.cells.empty(); });
  if (empty) {
    script += lines_in_the_middle(why_empty(map), place);
  } else {
    const std::vector<std::size_t> paints = map_paints(grid, map);
    drawn.add(image_of(grid, paints), map_image);
    for (const auto& [paint, hatch] :
         {std::pair(paint_diverged, map_hatch_diverged), std::pair(paint_refused, map_hatch_refused)})
      drawn.add(hatched(grid, paints, paint), fmt::format("{} {}", map_cell_boxes, hatch));
    const Pixels circles = edge_of(map, scale), line = predicted_of(map, scale);
    drawn.add(points_text(line, scale), map_casing_line);
    drawn.add(points_text(line, scale), map_predicted_line);
    drawn.add(points_text(circles, scale), map_edge_ring);
    drawn.add(points_text(circles, scale), map_edge_core);
    const std::string formula = formula_of(map);
    if (const auto box = formula.empty() ? std::nullopt : formula_box(formula, line, circles, scale)) {
      drawn.add(box_text(*box, scale),
                fmt::format("{} fs solid 1.0 noborder fc rgb '#ffffff'", map_cell_boxes));
      script += page_label(place, formula, place.left + 0.5 * (box->left + box->right),
                           place.bottom + 0.5 * (box->low + box->high), "center front", map_text_letters);
    }
  }
  return script + drawn.text() + "unset label\n";
}

}  // namespace taut
