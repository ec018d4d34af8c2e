#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "base/failure.h"
#include "study/metrics_plot.h"

namespace taut {
namespace {

constexpr std::string_view stage_ending = "_seconds";

using Cells = std::map<std::string, std::optional<std::string>, std::less<>>;  // by column; none: unknown

// A line's fields; quotes hold commas.
std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      fields.emplace_back();
    else if (c != '\r')
      fields.back() += c;
  }
  return fields;
}

template <class Number>
Number number_from(const Cells& cells, std::string_view column) {
  const auto cell = cells.find(column);
  if (cell == cells.end() || !cell->second) throw BadRequest(fmt::format("there is no \"{}\"", column));
  Number number{};
  const std::string& text = *cell->second;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size())
    throw BadRequest(fmt::format("\"{}\" is no number for \"{}\"", text, column));
  return number;
}

FrameMetrics row_of(const Cells& cells, const std::vector<std::string>& stages) {
  FrameMetrics row;
  row.frame = number_from<int>(cells, "frame");
  row.time = number_from<double>(cells, "time");
  const auto method = cells.find("method");
  if (method != cells.end()) row.method = method->second.value_or("");
  const auto value = [&](std::string_view column) -> std::optional<double> {
    const auto cell = cells.find(column);
    if (cell == cells.end() || !cell->second) return std::nullopt;
    return number_from<double>(cells, column);
  };
  row.values.reserve(metric_columns().size());
  for (const MetricColumn& column : metric_columns()) row.values.push_back(value(column.name));
  row.stage_seconds.reserve(stages.size());
  for (const std::string& stage : stages)
    row.stage_seconds.push_back(value(fmt::format("{}{}", stage, stage_ending)).value_or(0.0));
  return row;
}

void note_stage(const std::string& column, std::vector<std::string>& stages) {
  if (!column.ends_with(stage_ending)) return;
  const std::string stage = column.substr(0, column.size() - stage_ending.size());
  if (std::ranges::find(stages, stage) == stages.end()) stages.push_back(stage);
}

// Makes a table's lines into cells, the first of them being the header.
class TableLines {
 public:
  std::optional<Cells> cells(const std::string& line, std::vector<std::string>& stages) {
    std::vector<std::string> fields = fields_of(line);
    if (header_.empty()) {
      if (std::ranges::find(fields, "time") == fields.end())
        throw BadRequest("this is no header of metrics: no column \"time\"");
      header_ = std::move(fields);
      for (const std::string& column : header_) note_stage(column, stages);
      return std::nullopt;
    }
    if (fields.size() != header_.size())
      throw BadRequest(fmt::format("{} fields, and the header has {}", fields.size(), header_.size()));
    Cells cells;
    for (std::size_t i = 0; i < fields.size(); ++i)
      cells[header_[i]] = fields[i].empty() ? std::nullopt : std::optional(fields[i]);
    return cells;
  }

 private:
  std::vector<std::string> header_;
};

Cells cells_of_object(const std::string& line, std::vector<std::string>& stages) {
  nlohmann::ordered_json json;
  try {
    json = nlohmann::ordered_json::parse(line);
  } catch (const std::exception&) {
    throw BadRequest("this is no object of JSON");
  }
  if (!json.is_object()) throw BadRequest("this is no object of JSON");
  Cells cells;
  for (const auto& [name, value] : json.items()) {
    note_stage(name, stages);
    cells[name] = value.is_null()     ? std::nullopt
                  : value.is_string() ? std::optional(value.get<std::string>())
                                      : std::optional(value.dump());
  }
  return cells;
}

}  // namespace

MetricsTable read_metrics(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw BadRequest(fmt::format("there is no file {}", file.string()));
  MetricsTable metrics;
  TableLines table;
  std::string line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    if (line.empty()) continue;
    try {
      const std::optional<Cells> cells = are_lines(file)
                                             ? std::optional(cells_of_object(line, metrics.stages))
                                             : table.cells(line, metrics.stages);
      if (cells) metrics.rows.push_back(row_of(*cells, metrics.stages));
    } catch (const BadRequest& problem) {
      throw BadRequest(fmt::format("{}:{}: {}", file.string(), number, problem.what()));
    }
  }
  if (metrics.rows.empty()) throw BadRequest(fmt::format("{} has no metrics in it", file.string()));
  return metrics;
}

}  // namespace taut
