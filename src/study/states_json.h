#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "model/state.h"

namespace taut {

/// Times, positions, velocities and tensions of states as JSON. What is read is otherwise like `start`: no
/// link is broken.
nlohmann::ordered_json states_to_json(const std::vector<State>& states);
std::vector<State> states_from_json(const nlohmann::ordered_json& json, const State& start);

}  // namespace taut
