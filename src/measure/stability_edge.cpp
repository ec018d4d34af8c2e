#include "measure/stability_edge.h"

#include <algorithm>
#include <cmath>

namespace taut {

double Edge::value() const {
  return std::sqrt(holds * fails);
}

Edge narrow_edge(const std::function<bool(double)>& test, Edge edge, double ratio) {
  while (edge.fails > edge.holds * ratio) {
    const double middle = edge.value();
    (test(middle) ? edge.holds : edge.fails) = middle;
  }
  return edge;
}

std::optional<Edge> find_edge(const std::function<bool(double)>& test, double least, double most,
                              double factor, double ratio) {
  if (!test(least)) return std::nullopt;
  Edge edge{least, least};
  while (edge.fails < most) {
    edge.fails = std::min(most, edge.holds * factor);
    if (!test(edge.fails)) return narrow_edge(test, edge, ratio);
    edge.holds = edge.fails;
  }
  return std::nullopt;
}

}  // namespace taut
