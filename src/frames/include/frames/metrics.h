#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/run_measures.h"
#include "scene/scene.h"

namespace taut {

/// A column of metrics: what it is called in files, and its value in what was measured of a run; none where
/// the method doesn't know it.
struct MetricColumn {
  std::string_view name;
  std::optional<double> (*value)(const RunMeasures& measures, bool tension_known);
};

/// What is measured of every frame, in the order of the file: energies (J), work (J), strain, tension (N),
/// sag (m), largest speed (m/s), broken links, halved steps.
std::span<const MetricColumn> metric_columns();

/// One frame of one run.
struct FrameMetrics {
  int frame = 0;
  double time = 0.0;                          ///< s
  std::string method;                         ///< which of several runs: its method and settings, in words
  std::vector<std::optional<double>> values;  ///< one a column
  std::vector<double> stage_seconds{};        ///< of a processor, one a stage; empty where it wasn't made now
};

/// What is measured of a run of a scene at a frame.
FrameMetrics frame_metrics(const Scene& scene, int frame, const RunMeasures& measures);

/// Throws BadRequest where the name doesn't end in .csv or .jsonl, or is a folder's.
void check_metrics_file(const std::filesystem::path& file);

/// Whether a file of that name holds an object a line.
bool are_lines(const std::filesystem::path& file);

/// Rows as a table with a header (.csv; what isn't known is an empty cell) or as an object a line (.jsonl;
/// null), in the order given. `stages` are the columns of stage_seconds; none: no such columns.
std::string metrics_text(std::span<const FrameMetrics> rows, std::span<const std::string_view> stages,
                         bool as_lines);

/// Rows as bytes, and back. Throws BadRequest where the bytes are none.
std::string metrics_to_bytes(std::span<const FrameMetrics> rows);
std::vector<FrameMetrics> metrics_from_bytes(std::string_view bytes);

}  // namespace taut
