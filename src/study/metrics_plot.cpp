#include "study/metrics_plot.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <utility>

#include "base/failure.h"
#include "base/nearest.h"

namespace taut {
namespace {

// A panel: its columns, the main one last, and what each is called beside its curve.
struct MetricPlot {
  std::string_view name, label;
  std::vector<std::pair<std::string_view, std::string_view>> columns;
  bool always = false;  // shown unasked, even where it is the same all along
};

const std::vector<MetricPlot>& metric_plots() {
  static const std::vector<MetricPlot> plots{
      {"energy",
       "energy (J)",
       {{"kinetic_energy", "kinetic"},
        {"potential_energy", "in gravity"},
        {"elastic_energy", "elastic"},
        {"total_energy", "all"}},
       true},
      {"strain", "strain", {{"mean_strain", "mean"}, {"largest_strain", "largest"}}, true},
      {"tension", "tension (N)", {{"largest_tension", "largest"}}},
      {"sag", "sag (m)", {{"sag", ""}}},
      {"speed", "speed (m/s)", {{"largest_speed", "largest"}}, true},
      {"breaks", "broken links", {{"broken_links", ""}}},
      {"error", "energy error", {{"energy_error", ""}}},
      {"penetration", "penetration (m)", {{"penetration", ""}}},
      {"halvings", "halved steps", {{"halved_steps", ""}}},
      {"stages", "ms of a processor", {}},
  };
  return plots;
}

constexpr std::array<std::string_view, 6> shown_unasked{"energy", "strain", "tension",
                                                        "sag",    "speed",  "breaks"};

using Value = std::function<std::optional<double>(const FrameMetrics&)>;

PlainCurve curve_of(const MetricsTable& metrics, const std::string& method, std::string name,
                    std::size_t style, const Value& value) {
  PlainCurve curve{std::move(name), style, {}};
  for (const FrameMetrics& row : metrics.rows)
    if (row.method == method)
      if (const std::optional<double> known = value(row)) curve.points.push_back({row.time, *known});
  return curve;
}

Value column_value(std::string_view name) {
  const auto columns = metric_columns();
  const auto found = std::ranges::find(columns, name, &MetricColumn::name);
  const auto index = static_cast<std::size_t>(found - columns.begin());
  return [index](const FrameMetrics& row) { return row.values.at(index); };
}

// Without stages that there was nothing to do for, such as those of a film where none is made.
TimeFigure::Panel stage_panel(const MetricsTable& metrics, const std::string& method) {
  TimeFigure::Panel panel{"ms of a processor", {}};
  panel.curves.reserve(metrics.stages.size());
  for (std::size_t i = 0; i < metrics.stages.size(); ++i)
    panel.curves.push_back(curve_of(metrics, method, metrics.stages[i], i, [i](const FrameMetrics& row) {
      return i < row.stage_seconds.size() ? std::optional(1e3 * row.stage_seconds[i]) : std::nullopt;
    }));
  std::erase_if(panel.curves, [](const PlainCurve& curve) {
    return std::ranges::all_of(curve.points, [](const auto& point) { return point[1] == 0.0; });
  });
  return panel;
}

TimeFigure::Panel panel_of(const MetricPlot& plot, const MetricsTable& metrics,
                           const std::vector<std::string>& methods) {
  if (plot.columns.empty()) return stage_panel(metrics, methods.front());
  TimeFigure::Panel panel{std::string(plot.label), {}};
  const auto& [main, what] = plot.columns.back();
  for (std::size_t i = 0; i < methods.size() && methods.size() > 1; ++i)
    panel.curves.push_back(curve_of(metrics, methods[i], methods[i], i, column_value(main)));
  if (methods.size() > 1) {
    if (!what.empty()) panel.label = fmt::format("{}, {}", plot.label, what);
    return panel;
  }
  for (std::size_t i = 0; i < plot.columns.size(); ++i)
    panel.curves.push_back(curve_of(metrics, methods.front(), std::string(plot.columns[i].second), i,
                                    column_value(plot.columns[i].first)));
  return panel;
}

bool known(const TimeFigure::Panel& panel) {
  return std::ranges::any_of(panel.curves, [](const PlainCurve& curve) { return !curve.points.empty(); });
}

bool changes(const TimeFigure::Panel& panel) {
  return std::ranges::any_of(panel.curves, [](const PlainCurve& curve) {
    return std::ranges::any_of(curve.points,
                               [&](const auto& point) { return point[1] != curve.points.front()[1]; });
  });
}

std::vector<std::string> methods_of(const MetricsTable& metrics) {
  std::vector<std::string> methods;
  for (const FrameMetrics& row : metrics.rows)
    if (std::ranges::find(methods, row.method) == methods.end()) methods.push_back(row.method);
  return methods;
}

const MetricPlot& plot_named(const std::string& name) {
  const auto found = std::ranges::find(metric_plots(), name, &MetricPlot::name);
  if (found != metric_plots().end()) return *found;
  const std::vector<std::string_view> names = metric_plot_names();
  const std::string_view nearest = nearest_name(name, names);
  throw BadRequest(fmt::format("--show is one or more of {}, not \"{}\"{}", fmt::join(names, ","), name,
                               nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest)));
}

}  // namespace

std::vector<std::string_view> metric_plot_names() {
  std::vector<std::string_view> names;
  names.reserve(metric_plots().size());
  for (const MetricPlot& plot : metric_plots()) names.push_back(plot.name);
  return names;
}

void require_metric_plot(const std::string& name) {
  plot_named(name);
}

TimeFigure metrics_figure(const MetricsTable& metrics, const std::string& title,
                          std::span<const std::string> shown) {
  const std::vector<std::string> methods = methods_of(metrics);
  TimeFigure figure{title, methods.size() == 1 ? methods.front() : "the same scene by several methods", {}};
  for (const std::string& name : shown) {
    TimeFigure::Panel panel = panel_of(plot_named(name), metrics, methods);
    if (!known(panel)) throw BadRequest(fmt::format("nothing is known of \"{}\" in these metrics", name));
    figure.panels.push_back(std::move(panel));
  }
  for (const std::string_view name : shown_unasked) {
    if (!shown.empty()) break;
    const MetricPlot& plot = plot_named(std::string(name));
    TimeFigure::Panel panel = panel_of(plot, metrics, methods);
    if (known(panel) && (plot.always || changes(panel))) figure.panels.push_back(std::move(panel));
  }
  return figure;
}

PathFigure path_figure(const std::string& title, const std::vector<std::string>& names,
                       const std::vector<std::vector<Vec3>>& ways) {
  constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
  Eigen::AlignedBox3d box;
  for (const auto& way : ways)
    for (const Vec3& place : way) box.extend(place);
  Eigen::Index along = 2;  // of ways that take none along several: z
  for (const Eigen::Index axis : {0, 1})
    if (box.sizes()[axis] < box.sizes()[along]) along = axis;
  const Eigen::Index across = along == 0 ? 2 : 0, up = along == 1 ? 2 : 1;
  const auto name = [&](Eigen::Index axis) {
    return fmt::format("{} (m)", axes.at(static_cast<std::size_t>(axis)));
  };
  PathFigure figure{
      title,
      fmt::format("ways from the ring to the disk, seen along {}", axes.at(static_cast<std::size_t>(along))),
      name(across),
      name(up),
      {}};
  for (std::size_t i = 0; i < ways.size(); ++i) {
    PlainCurve& curve = figure.curves.emplace_back();
    curve.name = names[i];
    curve.style = i;
    curve.points.reserve(ways[i].size());
    for (const Vec3& place : ways[i]) curve.points.push_back({place[across], place[up]});
  }
  return figure;
}

}  // namespace taut
