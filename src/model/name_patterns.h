#pragma once

#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "model/model.h"

namespace taut {

/// Finds the masses whose dotted names fit a pattern of as many parts, where a part * fits any. All names are
/// gone through once for each set of places that stars stand at, not once for each pattern. The masses must
/// outlive it.
class NamePatterns {
 public:
  explicit NamePatterns(const Masses& masses) : masses_(masses) {}

  /// The masses that fit, rising; none where no name does. To be used before the next call.
  const std::vector<Index>& fitting(std::string_view pattern);

 private:
  using ByRest = std::unordered_map<std::string, std::vector<Index>>;

  const ByRest& names_without(const std::vector<bool>& stars);

  const Masses& masses_;
  std::map<std::vector<bool>, ByRest> by_stars_;  // names with * where the pattern has one
  const std::vector<Index> none_;
};

}  // namespace taut
