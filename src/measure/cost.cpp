#include "measure/cost.h"

#include <algorithm>
#include <cmath>

namespace taut {

double predicted_seconds(const Model& model, const StepReport& counts, double steps) {
  constexpr double per_solve = 15e-9, per_factor = 4e-9;  // s
  const double rows = static_cast<double>(model.links.size());
  return per_solve * std::max(static_cast<double>(counts.link_solves), steps * rows) +
         per_factor * static_cast<double>(counts.factorisations) * rows * std::sqrt(rows);
}

}  // namespace taut
