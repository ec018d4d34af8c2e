#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "frames/metrics.h"
#include "output/time_figure.h"

namespace taut {

/// Metrics, and what their stage_seconds are of.
struct MetricsTable {
  std::vector<FrameMetrics> rows;
  std::vector<std::string> stages{};
};

/// Reads what --metrics wrote, .csv or .jsonl. Throws BadRequest with file and line where it is no such file.
MetricsTable read_metrics(const std::filesystem::path& file);

/// What can be plotted of metrics: energy, strain, tension, sag, speed, breaks, error, penetration, halvings,
/// stages.
std::vector<std::string_view> metric_plot_names();

/// Throws BadRequest with the nearest name where nothing is called so.
void require_metric_plot(const std::string& name);

/// Metrics over time, a panel for each of `shown` (names of metric_plot_names(); none: what says something of
/// every run, and what is not the same all along). Of several runs each panel has a curve each, of its main
/// quantity. Throws BadRequest for a name there is none of, or where nothing is known of all that is shown.
TimeFigure metrics_figure(const MetricsTable& metrics, const std::string& title,
                          std::span<const std::string> shown);

/// The ways of masses, seen along the axis that they take least room along.
PathFigure path_figure(const std::string& title, const std::vector<std::string>& names,
                       const std::vector<std::vector<Vec3>>& ways);

}  // namespace taut
