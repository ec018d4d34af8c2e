#pragma once

#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace taut::testing {

/// The objects of a file of metrics, one a line.
inline std::vector<nlohmann::json> lines_of(const std::string& text) {
  std::vector<nlohmann::json> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(nlohmann::json::parse(line));
  return lines;
}

/// What doesn't differ from run to run: all but what the stages took.
inline std::string measured_part(const std::string& text) {
  std::string measured;
  for (nlohmann::json line : lines_of(text)) {
    for (auto it = line.begin(); it != line.end();)
      it = it.key().ends_with("_seconds") ? line.erase(it) : std::next(it);
    measured += line.dump() + "\n";
  }
  return measured;
}

}  // namespace taut::testing
