#pragma once

#include <functional>
#include <optional>

namespace taut {

/// Where something stops holding as a number grows: the largest value known to hold and the smallest known to
/// fail.
struct Edge {
  double holds = 0.0, fails = 0.0;

  /// The geometric mean of the two.
  double value() const;
};

/// Narrows an edge down by bisection on the logarithm, until the two values are within the given ratio (1.02:
/// to 2 %) of each other. `holds` and `fails` must be so to begin with.
Edge narrow_edge(const std::function<bool(double)>& test, Edge edge, double ratio = 1.02);

/// Climbs from `least` by the given factor until the test fails, and narrows down the first edge met. Nothing
/// when `least` itself fails or everything up to `most` holds.
std::optional<Edge> find_edge(const std::function<bool(double)>& test, double least, double most,
                              double factor = 1.3, double ratio = 1.02);

}  // namespace taut
