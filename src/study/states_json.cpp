#include "states_json.h"

namespace taut {
namespace {

using Json = nlohmann::ordered_json;

Json vectors_to_json(const Vectors& v) {
  return {v.x, v.y, v.z};
}

Vectors vectors_from_json(const Json& json) {
  Vectors v;
  json.at(0).get_to(v.x);
  json.at(1).get_to(v.y);
  json.at(2).get_to(v.z);
  return v;
}

}  // namespace

Json states_to_json(const std::vector<State>& states) {
  Json json = Json::array();
  for (const State& state : states)
    json.push_back({{"time", state.time},
                    {"position", vectors_to_json(state.position)},
                    {"velocity", vectors_to_json(state.velocity)},
                    {"tension", state.tension}});
  return json;
}

std::vector<State> states_from_json(const Json& json, const State& start) {
  std::vector<State> states;
  for (const Json& entry : json) {
    State state = start;
    entry.at("time").get_to(state.time);
    state.position = vectors_from_json(entry.at("position"));
    state.velocity = vectors_from_json(entry.at("velocity"));
    entry.at("tension").get_to(state.tension);
    states.push_back(std::move(state));
  }
  return states;
}

}  // namespace taut
