#include "map_column_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/json_text.h"

namespace taut {
namespace {

using Json = nlohmann::ordered_json;

// JSON has no NaN: what is no number is null.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

double number(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

Fate fate_from(const std::string& name) {
  for (const Fate fate : {Fate::held, Fate::drifted, Fate::diverged, Fate::refused})
    if (fate_name(fate) == name) return fate;
  throw std::invalid_argument("unknown fate " + name);
}

Json cell_to_json(const RunOutcome& cell) {
  return {{"fate", fate_name(cell.fate)},
          {"steps", cell.steps},
          {"error", number(cell.error)},
          {"strain", number(cell.strain)},
          {"energy_drift", number(cell.energy_drift)}};
}

RunOutcome cell_from_json(const Json& json) {
  RunOutcome cell;
  cell.fate = fate_from(json.at("fate").get<std::string>());
  cell.steps = json.at("steps").get<std::int64_t>();
  cell.error = number(json.at("error"));
  cell.strain = number(json.at("strain"));
  cell.energy_drift = number(json.at("energy_drift"));
  return cell;
}

}  // namespace

std::string map_column_to_json(const MapColumn& column) {
  Json cells = Json::array();
  for (const RunOutcome& cell : column.cells) cells.push_back(cell_to_json(cell));
  Json json{{"value", column.value},
            {"refusal", column.refusal},
            {"edge", nullptr},
            {"predicted", nullptr},
            {"cells", std::move(cells)}};
  if (column.edge) json["edge"] = {{"holds", column.edge->holds}, {"fails", column.edge->fails}};
  if (column.predicted)
    json["predicted"] = {{"value", column.predicted->value}, {"formula", column.predicted->formula}};
  return json_text(json);
}

MapColumn map_column_from_json(const std::string& text) {
  const Json json = Json::parse(text);
  MapColumn column;
  column.value = json.at("value").get<double>();
  column.refusal = json.at("refusal").get<std::string>();
  for (const Json& cell : json.at("cells")) column.cells.push_back(cell_from_json(cell));
  if (const Json& edge = json.at("edge"); !edge.is_null())
    column.edge = {edge.at("holds").get<double>(), edge.at("fails").get<double>()};
  if (const Json& predicted = json.at("predicted"); !predicted.is_null())
    column.predicted = {predicted.at("value").get<double>(), predicted.at("formula").get<std::string>()};
  return column;
}

}  // namespace taut
