#include "stability_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "map_cells.h"
#include "methods/registry.h"

namespace taut {
namespace {

// Where a panel's axes lie on the page, as shares of it.
struct Place {
  double left, right, bottom, top;
};

// Which axes a panel has letters on, and how it is called.
struct Labels {
  std::string title, x, y;
};

// The bounds of the cell around a value, half way to its neighbours on the logarithm.
std::pair<double, double> cell_bounds(const std::vector<double>& values, std::size_t i) {
  if (values.size() == 1) return {0.9 * values[0], 1.1 * values[0]};
  const double below =
      i > 0 ? std::sqrt(values[i - 1] * values[i]) : values[0] * std::sqrt(values[0] / values[1]);
  const double above = i + 1 < values.size() ? std::sqrt(values[i] * values[i + 1])
                                             : values[i] * std::sqrt(values[i] / values[i - 1]);
  return {below, above};
}

// x, y, their bounds, of cells of one paint; empty when there are none.
std::string boxes(const StabilityMaps& maps, const MethodMap& map, const std::vector<PaintedCells>& cells,
                  std::size_t paint) {
  std::string text;
  for (const PaintedCells& part : cells) {
    if (part.paint != paint) continue;
    const double x = map.columns[part.column].value;
    const auto at = std::find(maps.grid.columns.begin(), maps.grid.columns.end(), x);
    const auto [left, right] =
        cell_bounds(maps.grid.columns, static_cast<std::size_t>(at - maps.grid.columns.begin()));
    const double bottom = cell_bounds(maps.grid.rows, part.first_row).first;
    const double top = cell_bounds(maps.grid.rows, part.last_row).second;
    fmt::format_to(std::back_inserter(text), "{} {} {} {} {} {}\n", x, maps.grid.rows[part.first_row], left,
                   right, bottom, top);
  }
  return text;
}

// Of so many columns that circles would run into each other only some are marked.
std::string edge_points(const MethodMap& map) {
  constexpr std::size_t most_marks = 14;
  const std::size_t stride = (map.columns.size() + most_marks - 1) / most_marks;
  std::string text;
  for (std::size_t i = 0; i < map.columns.size(); i += stride)
    if (const MapColumn& column = map.columns[i]; column.edge)
      fmt::format_to(std::back_inserter(text), "{} {}\n", column.value, column.edge->value());
  return text;
}

// The predicted edge, the part below the map drawn along its foot.
std::string predicted_points(const StabilityMaps& maps, const MethodMap& map) {
  std::string text;
  const double foot = cell_bounds(maps.grid.rows, 0).first;
  for (const MapColumn& column : map.columns)
    if (column.predicted)
      fmt::format_to(std::back_inserter(text), "{} {}\n", column.value,
                     std::max(column.predicted->value, foot));
  return text;
}

std::string ranges(const MapGrid& grid) {
  const auto range = [](const std::vector<double>& values) {
    return fmt::format("[{}:{}]", cell_bounds(values, 0).first,
                       cell_bounds(values, values.size() - 1).second);
  };
  return fmt::format("set logscale xy\nset xrange {}\nset yrange {}\n", range(grid.columns),
                     range(grid.rows));
}

// What an empty panel says: the first part of the refusal.
std::string why_empty(const MethodMap& map) {
  for (const MapColumn& column : map.columns)
    if (!column.refusal.empty()) return column.refusal.substr(0, column.refusal.find(';'));
  return "no columns yet";
}

// Labels one below the other, the text broken between words.
std::string lines_in_the_middle(const std::string& text) {
  constexpr std::size_t widest = 20;
  std::vector<std::string> lines(1);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (!lines.back().empty() && lines.back().size() + word.size() >= widest) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
    begin = end + 1;
  }
  std::string labels;
  for (std::size_t i = 0; i < lines.size(); ++i)
    labels += fmt::format("set label {} at graph 0.5,{} center font ',{}'\n", plot_text(lines[i]),
                          0.62 - 0.1 * static_cast<double>(i), plot_small_letters);
  return labels;
}

constexpr std::string_view cell_columns = "using 1:2:3:4:5:6 with boxxyerror";
constexpr std::string_view casing_style = "with lines lw 7 lc rgb '#ffffff'";
constexpr std::string_view predicted_style = "with lines lw 4 dt (14,7) lc rgb '#000000'";
constexpr std::string_view edge_ring_style = "with points pt 7 ps 2.4 lc rgb '#000000'";
constexpr std::string_view edge_core_style = "with points pt 7 ps 1.7 lc rgb '#ffffff'";

// One panel of a multiplot.
std::string panel(const StabilityMaps& maps, const MethodMap& map, const Place& place, const Labels& labels) {
  std::string script = fmt::format(
      "set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen {}\nset tmargin at screen "
      "{}\n",
      place.left, place.right, place.bottom, place.top);
  script += ranges(maps.grid);
  script += fmt::format("set title {} offset 0,-0.6\nset xlabel {}\nset ylabel {} offset 0.8,0\n",
                        plot_text(labels.title), plot_text(labels.x), plot_text(labels.y));
  const bool small = maps.grid.axes->whole;
  script += fmt::format("set format x '{}'\nset format y '{}'\n",
                        labels.x.empty() ? "" : (small ? "%g" : "10^{%L}"),
                        labels.y.empty() ? "" : (maps.grid.axes->rows == MapRows::passes ? "%g" : "10^{%L}"));
  const std::vector<PaintedCells> cells = painted_cells(map, shade_of(maps.grid));
  std::string data, plots;
  const auto add = [&](const std::string& name, const std::string& points, std::string_view how) {
    if (points.empty()) return;
    data += fmt::format("${} << END\n{}END\n", name, points);
    plots += fmt::format("{} ${} {}", plots.empty() ? "plot" : ", \\\n", name, how);
  };
  for (std::size_t paint = 0; paint <= paint_refused; ++paint)
    add(fmt::format("paint{}", paint), boxes(maps, map, cells, paint),
        fmt::format("{} fs {} noborder fc rgb '{}'", cell_columns,
                    paint == paint_diverged ? "pattern 4" : "solid 1.0", map_paint(paint)));
  const std::string edges = edge_points(map);
  add("edge", edges, edge_ring_style);
  add("inside", edges, edge_core_style);
  const std::string predicted = predicted_points(maps, map);
  add("casing", predicted, casing_style);
  add("predicted", predicted, predicted_style);
  if (plots.empty()) {
    plots = "plot 0 notitle";
    script += lines_in_the_middle(why_empty(map));
  }
  return script + data + plots + "\nunset label\n";
}

// The meaning of paints, circles and the line, along the foot of the page, in a frame of 100 × 10.
class Legend {
 public:
  explicit Legend(double height)
      : script_(fmt::format("set lmargin at screen 0.02\nset rmargin at screen 0.98\nset bmargin at screen "
                            "0.005\nset tmargin at "
                            "screen {}\nunset logscale\nset xrange [0:100]\nset yrange [0:10]\nunset "
                            "border\nunset tics\nunset "
                            "grid\nset title ''\nset xlabel ''\nset ylabel ''\n",
                            height)) {}

  void label(double x, double y, std::string_view gnuplot_text, std::string_view align) {
    script_ +=
        fmt::format("set label {} at {},{} {} font ',{}'\n", gnuplot_text, x, y, align, plot_small_letters);
  }
  void box(double left, double bottom, std::string_view fill, std::size_t paint) {
    draw(fmt::format("{0} {1} {0} {2} {1} {3}\n", left, bottom, left + box_width, bottom + 2.4),
         fmt::format("{} fs {} border lc rgb '{}' fc rgb '{}'", cell_columns, fill, plot_ink,
                     map_paint(paint)));
  }
  void draw(const std::string& points, std::string_view how) {
    data_ += fmt::format("$legend{} << END\n{}END\n", drawn_, points);
    plots_ += fmt::format("{} $legend{} {}", drawn_ == 0 ? "plot" : ", \\\n", drawn_, how);
    ++drawn_;
  }
  std::string text() const { return script_ + data_ + plots_ + "\n"; }

  static constexpr double box_width = 4.5;

 private:
  std::string script_, data_, plots_;
  int drawn_ = 0;
};

std::string legend(double height, ShadeOf what) {
  constexpr double left = 25.0, right = 64.0, upper = 6.2, lower = 3.2, middle = 1.2;
  Legend legend(height);
  const auto scale = [&](std::size_t first_paint, double bottom) {
    for (std::size_t i = 0; i < error_shades; ++i)
      legend.box(left + Legend::box_width * static_cast<double>(i), bottom, "solid 1.0", first_paint + i);
  };
  legend.label(left - 1.0, upper + middle,
               what == ShadeOf::error ? "'error/length, energy held'" : "'strain, energy held'", "right");
  scale(0, upper);
  legend.label(left - 1.0, lower + middle, "'energy over 1 % off'", "right");
  scale(error_shades, lower);
  for (std::size_t i = 0; i <= error_shades; i += 2)
    legend.label(left + Legend::box_width * static_cast<double>(i), 1.4,
                 fmt::format("'10^{{{}}}'",
                             static_cast<int>(std::lround(std::log10(least_error))) + static_cast<int>(i)),
                 "center");
  legend.box(right, upper, "pattern 4", paint_diverged);
  legend.label(right + 5.5, upper + middle, "'diverged'", "left");
  legend.box(right, lower, "solid 1.0", paint_refused);
  legend.label(right + 5.5, lower + middle, "'refused'", "left");
  const std::string edge = fmt::format("82 {}\n", upper + middle);
  legend.draw(edge, edge_ring_style);
  legend.draw(edge, edge_core_style);
  legend.label(85, upper + middle, "'measured edge'", "left");
  legend.draw(fmt::format("80 {0}\n84 {0}\n", lower + middle), predicted_style);
  legend.label(85, lower + middle, "'predicted'", "left");
  return legend.text();
}

std::string y_title(const MapGrid& grid) {
  return grid.axes->rows == MapRows::step ? "step (s)" : "passes a step";
}

// What theory the line stands for, where there is any.
std::string formula_of(const MethodMap& map) {
  for (const MapColumn& column : map.columns)
    if (column.predicted) return column.predicted->formula;
  return {};
}

std::string with_formula(const MethodMap& map) {
  const std::string formula = formula_of(map);
  return formula.empty() ? map.method : fmt::format("{}: {}", map.method, formula);
}

}  // namespace

PlotScript map_plot(const StabilityMaps& maps, const MethodMap& map, const std::string& title) {
  PlotScript plot;
  plot.commands = "set multiplot\n";
  plot.commands += panel(maps, map, {0.12, 0.97, 0.30, 0.92},
                         {fmt::format("{} – {}", with_formula(map), title),
                          std::string(maps.grid.axes->title), y_title(maps.grid)});
  plot.commands += legend(0.15, shade_of(maps.grid)) + "unset multiplot\n";
  return plot;
}

PlotScript overview_plot(const StabilityMaps& maps, const std::string& title) {
  const std::size_t across = std::clamp<std::size_t>(maps.maps.size(), 1, 4);
  const std::size_t down = (maps.maps.size() + across - 1) / across;
  PlotScript plot;
  plot.size = {std::max(1800, 600 * static_cast<int>(across)), 320 + 560 * static_cast<int>(down)};
  const double pixel = 1.0 / plot.size.height, across_pixel = 1.0 / plot.size.width;
  const double pitch = (1.0 - 145.0 * across_pixel) / static_cast<double>(across);
  plot.commands = fmt::format("set multiplot\nset label {} at screen 0.5,{} center\n", plot_text(title),
                              1.0 - 32.0 * pixel);
  for (std::size_t i = 0; i < maps.maps.size(); ++i) {
    const std::size_t column = i % across, row = i / across;
    const double left = 200.0 * across_pixel + pitch * static_cast<double>(column);
    const double right = left + pitch - 90.0 * across_pixel;
    const double top = 1.0 - (130.0 + 560.0 * static_cast<double>(row)) * pixel;
    const bool lowest = i + across >= maps.maps.size();
    plot.commands += panel(maps, maps.maps[i], {left, right, top - 440.0 * pixel, top},
                           {with_formula(maps.maps[i]), lowest ? std::string(maps.grid.axes->title) : "",
                            column == 0 ? y_title(maps.grid) : ""});
  }
  plot.commands += legend(130.0 * pixel, shade_of(maps.grid)) + "unset multiplot\n";
  return plot;
}

}  // namespace taut
