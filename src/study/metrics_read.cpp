#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <variant>

#include "base/failure.h"
#include "meshes/table.h"
#include "study/metrics_plot.h"

namespace taut {
namespace {

constexpr std::string_view stage_ending = "_seconds";

// What a row has by its columns' names: a number, a text, or nothing that is known.
using Cell = std::variant<std::monostate, double, std::string>;
using Row = std::function<Cell(std::string_view column)>;

std::optional<double> number_in(const Row& row, std::string_view column) {
  const Cell value = row(column);
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? std::optional(*number) : std::nullopt;
}

FrameMetrics metrics_of(const Row& row, const std::vector<std::string>& stages) {
  FrameMetrics metrics;
  metrics.frame = static_cast<int>(number_in(row, "frame").value_or(0.0));
  metrics.time = number_in(row, "time").value_or(0.0);
  const Cell method = row("method");
  if (const auto* name = std::get_if<std::string>(&method)) metrics.method = *name;
  metrics.values.reserve(metric_columns().size());
  for (const MetricColumn& column : metric_columns()) metrics.values.push_back(number_in(row, column.name));
  metrics.stage_seconds.reserve(stages.size());
  for (const std::string& stage : stages)
    metrics.stage_seconds.push_back(number_in(row, fmt::format("{}{}", stage, stage_ending)).value_or(0.0));
  return metrics;
}

void note_stage(const std::string& column, std::vector<std::string>& stages) {
  if (!column.ends_with(stage_ending)) return;
  const std::string stage = column.substr(0, column.size() - stage_ending.size());
  if (std::ranges::find(stages, stage) == stages.end()) stages.push_back(stage);
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw BadRequest(fmt::format("there is no file {}", file.string()));
  return {std::istreambuf_iterator<char>(stream), {}};
}

MetricsTable from_table(const std::string& text, const std::string& file) {
  const Table table(text, file);
  MetricsTable metrics;
  for (const std::string_view needed : {"frame", "time"})
    if (table.column(needed) == Table::no_column)
      table.fail(table.headings().front(), fmt::format("there is no column \"{}\" of metrics", needed));
  for (const TableField& heading : table.headings()) note_stage(heading.text, metrics.stages);
  for (std::size_t i = 0; i < table.row_count(); ++i)
    for (const std::string_view needed : {"frame", "time"})
      if (const std::size_t column = table.column(needed); !table.number(i, column))
        table.fail(table.field(i, column), fmt::format("there is no {}", needed));
  metrics.rows.reserve(table.row_count());
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    const Row row = [&](std::string_view name) -> Cell {
      const std::size_t column = table.column(name);
      if (column == Table::no_column || table.field(i, column).text.empty()) return {};
      if (name == "method") return table.field(i, column).text;
      return *table.number(i, column);
    };
    metrics.rows.push_back(metrics_of(row, metrics.stages));
  }
  return metrics;
}

MetricsTable from_lines(const std::string& text, const std::string& file) {
  MetricsTable metrics;
  std::istringstream lines(text);
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    const auto json = nlohmann::ordered_json::parse(line, nullptr, false);
    if (!json.is_object() || !json.value("time", nlohmann::ordered_json()).is_number())
      throw BadRequest(fmt::format("{}:{}: this is no object of JSON with a \"time\"", file, number));
    for (const auto& [name, value] : json.items()) note_stage(name, metrics.stages);
    const Row row = [&](std::string_view name) -> Cell {
      const auto found = json.find(name);
      if (found == json.end()) return {};
      if (found->is_string()) return found->get<std::string>();
      return found->is_number() ? Cell(found->get<double>()) : Cell();
    };
    metrics.rows.push_back(metrics_of(row, metrics.stages));
  }
  return metrics;
}

}  // namespace

MetricsTable read_metrics(const std::filesystem::path& file) {
  const std::string text = text_of(file);
  MetricsTable metrics = are_lines(file) ? from_lines(text, file.string()) : from_table(text, file.string());
  if (metrics.rows.empty()) throw BadRequest(fmt::format("{} has no metrics in it", file.string()));
  return metrics;
}

}  // namespace taut
