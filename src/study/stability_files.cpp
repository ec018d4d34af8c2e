#include "study/stability_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/json_text.h"
#include "host/build_info.h"
#include "map_column_json.h"
#include "stability_plot.h"
#include "study/study_folder.h"

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

MapHeading heading_of(const StabilityMaps& maps, const Scene& scene) {
  MapHeading heading{scene.title, fmt::format("{} s of motion, no step halved", maps.grid.duration)};
  if (maps.grid.axes->rows == MapRows::step && lacks_references(maps))
    heading.subtitle += "; strain where no reference is certain";
  if (maps.count.completed < maps.count.planned)
    heading.subtitle += fmt::format("; {} of {} columns", maps.count.completed, maps.count.planned);
  return heading;
}

// What the pictures show and how to read them, a paragraph a line.
std::string caption_of(const StabilityMaps& maps, const Scene& scene) {
  const MapGrid& grid = maps.grid;
  const bool step = grid.axes->rows == MapRows::step;
  std::string text = fmt::format("{}: how each method fares over {} and {} ({} columns, {} rows).\n\n",
                                 scene.title, grid.axes->title, step ? "the step" : "passes a step",
                                 grid.columns.size(), grid.rows.size());
  text += fmt::format(
      "Every cell is one run of {} s that starts as the scene does, with the guard off: no step is halved. "
      "{} Light "
      "blue: the energy stayed within 1 % of its scale to the end. Dark red: it did not. Diagonal hatching: "
      "the run "
      "diverged, or a step could not be solved. Cross-hatching: the method refused it.\n\n",
      grid.duration,
      step ? "The darker a shade, the larger the distance of the farthest mass from where it should be, over "
             "the "
             "length of all links."
           : "The darker a shade, the larger the strain of any link.");
  text += fmt::format(
      "Circles: the edge of what holds, measured to 2 %. Dashed line: where theory has it, by the formula "
      "beside "
      "it.\n\n");
  if (step && lacks_references(maps))
    text += "Where no reference could be certified, shades are those of the largest strain.\n\n";
  for (const MethodMap& map : maps.maps)
    for (const MapColumn& column : map.columns)
      if (!column.refusal.empty()) {
        text += fmt::format("{}: {}.\n\n", map.method, column.refusal);
        break;
      }
  return text +
         fmt::format("{} of {} columns; {}.\n", maps.count.completed, maps.count.planned, build_info());
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
  return json_text(json, 1) + "\n";
}

void write_stability_files(const StabilityMaps& maps, const Scene& scene, const std::filesystem::path& folder,
                           const StopTest& stop) {
  StudyFolder files(folder, "stability");
  files.write("cells.csv", cells_csv(maps));
  files.write("edges.csv", edges_csv(maps));
  files.write("maps.json", stability_json(maps, scene));
  const MapHeading heading = heading_of(maps, scene);
  for (const MethodMap& map : maps.maps) files.draw(file_name(map), map_plot(maps, map, heading), stop);
  files.draw("overview", overview_plot(maps, heading), stop);
  files.write("overview.txt", caption_of(maps, scene));
  files.know("cases.jsonl");
  const CaseCount& count = maps.count;
  files.finish(scene.name, count.completed == count.planned
                               ? ""
                               : fmt::format("{} of {} columns are still to be run",
                                             count.planned - count.completed, count.planned));
}

}  // namespace taut
