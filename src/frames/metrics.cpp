#include "frames/metrics.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <system_error>

#include "base/bytes.h"
#include "base/failure.h"
#include "base/json_text.h"
#include "frames/colouring.h"
#include "panel_runs.h"

namespace taut {
namespace {

using Measures = const RunMeasures&;

constexpr std::array<MetricColumn, 17> all_columns{{
    {"kinetic_energy", [](Measures m, bool) { return std::optional(m.energy.kinetic); }},
    {"potential_energy", [](Measures m, bool) { return std::optional(m.energy.potential); }},
    {"elastic_energy", [](Measures m, bool) { return std::optional(m.energy.elastic); }},
    {"total_energy", [](Measures m, bool) { return std::optional(m.energy.total()); }},
    {"pin_work", [](Measures m, bool) { return std::optional(m.pin_work); }},
    {"load_work", [](Measures m, bool) { return std::optional(m.load_work); }},
    {"contact_work", [](Measures m, bool) { return std::optional(m.contact_work); }},
    {"broken_energy", [](Measures m, bool) { return std::optional(m.broken_energy); }},
    {"energy_error", [](Measures m, bool) { return std::optional(m.energy_error); }},
    {"largest_strain", [](Measures m, bool) { return std::optional(m.strain.largest); }},
    {"mean_strain", [](Measures m, bool) { return std::optional(m.strain.mean); }},
    {"largest_tension",
     [](Measures m, bool known) { return known ? std::optional(m.largest_tension) : std::nullopt; }},
    {"sag", [](Measures m, bool) { return std::optional(m.sag); }},
    {"largest_speed", [](Measures m, bool) { return std::optional(m.fastest_speed); }},
    {"broken_links", [](Measures m, bool) { return std::optional(static_cast<double>(m.broken_links)); }},
    {"penetration", [](Measures m, bool) { return std::optional(m.penetration); }},
    {"halved_steps",
     [](Measures m, bool) { return std::optional(static_cast<double>(m.report.halved_steps)); }},
}};

std::string stage_column(std::string_view stage) {
  return fmt::format("{}_seconds", stage);
}

std::string csv_header(std::span<const std::string_view> stages) {
  std::string header = "frame,time,method";
  for (const MetricColumn& column : all_columns) header += fmt::format(",{}", column.name);
  for (const std::string_view stage : stages) header += fmt::format(",{}", stage_column(stage));
  return header + "\n";
}

// Methods have commas in their names, and no quotes.
std::string csv_row(const FrameMetrics& row, std::size_t stages) {
  std::string text = fmt::format("{},{},\"{}\"", row.frame, row.time, row.method);
  for (const std::optional<double>& value : row.values)
    text += value ? fmt::format(",{}", *value) : std::string(",");
  for (std::size_t i = 0; i < stages; ++i)
    text += i < row.stage_seconds.size() ? fmt::format(",{:.6f}", row.stage_seconds[i]) : std::string(",");
  return text + "\n";
}

std::string json_row(const FrameMetrics& row, std::span<const std::string_view> stages) {
  using Json = nlohmann::ordered_json;
  Json json{{"frame", row.frame}, {"time", row.time}, {"method", row.method}};
  for (std::size_t i = 0; i < all_columns.size(); ++i)
    json[std::string(all_columns[i].name)] = row.values[i] ? Json(*row.values[i]) : Json();
  for (std::size_t i = 0; i < stages.size(); ++i)
    json[stage_column(stages[i])] =
        i < row.stage_seconds.size() ? Json(std::round(row.stage_seconds[i] * 1e6) * 1e-6) : Json();
  return json_text(json) + "\n";
}

}  // namespace

bool are_lines(const std::filesystem::path& file) {
  return file.extension() == ".jsonl";
}

std::span<const MetricColumn> metric_columns() {
  return all_columns;
}

FrameMetrics frame_metrics(const Scene& scene, int frame, const RunMeasures& measures) {
  const bool known = tension_known(scene, measures.time);
  FrameMetrics row{frame, measures.time, panel_title(scene), {}, {}};
  row.values.reserve(all_columns.size());
  for (const MetricColumn& column : all_columns) row.values.push_back(column.value(measures, known));
  return row;
}

void check_metrics_file(const std::filesystem::path& file) {
  if (file.extension() != ".csv" && file.extension() != ".jsonl")
    throw BadRequest(
        fmt::format("--metrics needs a file ending in .csv or .jsonl, not \"{}\"", file.string()));
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw BadRequest(fmt::format("{} is a folder, not a name for metrics", file.string()));
}

std::string metrics_text(std::span<const FrameMetrics> rows, std::span<const std::string_view> stages,
                         bool as_lines) {
  std::string text = as_lines ? std::string() : csv_header(stages);
  for (const FrameMetrics& row : rows) text += as_lines ? json_row(row, stages) : csv_row(row, stages.size());
  return text;
}

std::string metrics_to_bytes(std::span<const FrameMetrics> rows) {
  std::string bytes;
  append_bytes(static_cast<std::uint64_t>(rows.size()), bytes);
  for (const FrameMetrics& row : rows) {
    append_bytes(row.frame, bytes);
    append_bytes(row.time, bytes);
    append_bytes(row.method, bytes);
    std::vector<double> values;
    values.reserve(row.values.size());
    for (const std::optional<double>& value : row.values)
      values.push_back(value.value_or(std::numeric_limits<double>::quiet_NaN()));
    append_bytes(values, bytes);
    append_bytes(row.stage_seconds, bytes);
  }
  return bytes;
}

std::vector<FrameMetrics> metrics_from_bytes(std::string_view bytes) {
  ByteReader reader(bytes);
  std::uint64_t count = 0;
  reader.take(count);
  std::vector<FrameMetrics> rows;
  for (std::uint64_t i = 0; i < count; ++i) {
    FrameMetrics& row = rows.emplace_back();
    reader.take(row.frame);
    reader.take(row.time);
    reader.take(row.method);
    std::vector<double> values;
    reader.take(values);
    if (values.size() != all_columns.size()) throw BadRequest("these are metrics of other columns");
    row.values.reserve(values.size());
    for (const double value : values)
      row.values.push_back(std::isnan(value) ? std::nullopt : std::optional(value));
    reader.take(row.stage_seconds);
  }
  return rows;
}

}  // namespace taut
