#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/chart.h"

namespace taut {

/// What a curve needs for an error.
struct CostAt {
  double seconds = 0.0;
  bool extrapolated = false;  ///< beyond the curve's last point, along its last two
};

/// The time that a curve of a chart needs to reach an error: between two points of its own front along the
/// straight line of the logarithms. Nothing where the curve does not come that far and does not look as if it
/// would.
std::optional<CostAt> cost_at(const Chart& chart, std::size_t curve, ErrorKind kind, double error);

/// Which method when: for every chart the cheapest method at errors of 10 % to 0.01 %, as a Markdown table.
std::string cheapest_method_table(const std::vector<Chart>& charts);

/// The same at length: for every chart and errors of 10 % to 0.01 %, the cheapest method and how many times
/// dearer the others are, as a Markdown table.
std::string which_method_table(const std::vector<Chart>& charts);

}  // namespace taut
