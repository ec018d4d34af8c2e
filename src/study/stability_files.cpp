#include "study/stability_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "host/build_info.h"
#include "map_column_json.h"
#include "output/atomic_file.h"
#include "stability_plot.h"

namespace taut {
namespace {

using Json = nlohmann::ordered_json;

// Empty where there is no number.
std::string csv_number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : std::string();
}

std::string cells_csv(const StabilityMaps& maps) {
  std::string text = "method,column,row,fate,steps,error,strain,energy_drift\n";
  for (const MethodMap& map : maps.maps)
    for (const MapColumn& column : map.columns)
      for (std::size_t row = 0; row < column.cells.size(); ++row) {
        const RunOutcome& cell = column.cells[row];
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{}\n", map.method, column.value,
                       maps.grid.rows[row], fate_name(cell.fate), cell.steps, csv_number(cell.error),
                       csv_number(cell.strain), csv_number(cell.energy_drift));
      }
  return text;
}

std::string edges_csv(const StabilityMaps& maps) {
  std::string text = "method,column,holds,fails,predicted,formula\n";
  for (const MethodMap& map : maps.maps)
    for (const MapColumn& column : map.columns)
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{}\n", map.method, column.value,
                     column.edge ? csv_number(column.edge->holds) : "",
                     column.edge ? csv_number(column.edge->fails) : "",
                     column.predicted ? csv_number(column.predicted->value) : "",
                     column.predicted ? column.predicted->formula : "");
  return text;
}

// Whether the shades of some columns are those of strain, for want of a reference.
bool lacks_references(const StabilityMaps& maps) {
  for (const MethodMap& map : maps.maps)
    for (const MapColumn& column : map.columns)
      for (const RunOutcome& cell : column.cells)
        if (!cell.failed() && !std::isfinite(cell.error)) return true;
  return false;
}

// A label without what has a meaning in paths or shells.
std::string file_name(const MethodMap& map) {
  std::string name = map.method;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == ':' || c == '=' || c == '/'; }, '-');
  return name;
}

std::string title_of(const StabilityMaps& maps, const Scene& scene) {
  std::string title = fmt::format("{}, {} s, guard off", scene.title, maps.grid.duration);
  if (maps.grid.axes->rows == MapRows::step && lacks_references(maps))
    title += ", strain where no reference is certain";
  if (maps.count.completed < maps.count.planned)
    title += fmt::format(", {} of {} columns", maps.count.completed, maps.count.planned);
  return title;
}

}  // namespace

std::string stability_json(const StabilityMaps& maps, const Scene& scene) {
  Json methods = Json::array();
  for (const MethodMap& map : maps.maps) {
    Json columns = Json::array();
    for (const MapColumn& column : map.columns) columns.push_back(Json::parse(map_column_to_json(column)));
    methods.push_back({{"name", map.method}, {"columns", std::move(columns)}});
  }
  const Json json{
      {"scene", scene.name},           {"axes", maps.grid.axes->name}, {"duration", maps.grid.duration},
      {"columns", maps.grid.columns},  {"rows", maps.grid.rows},       {"completed", maps.count.completed},
      {"planned", maps.count.planned}, {"build", build_info()},        {"methods", std::move(methods)}};
  return json.dump(1) + "\n";
}

void write_stability_files(const StabilityMaps& maps, const Scene& scene,
                           const std::filesystem::path& folder) {
  write_file(folder / "cells.csv", cells_csv(maps));
  write_file(folder / "edges.csv", edges_csv(maps));
  write_file(folder / "maps.json", stability_json(maps, scene));
  const std::string title = title_of(maps, scene);
  for (const MethodMap& map : maps.maps) write_plot(map_plot(maps, map, title), folder / file_name(map));
  write_plot(overview_plot(maps, title), folder / "overview");
}

}  // namespace taut
