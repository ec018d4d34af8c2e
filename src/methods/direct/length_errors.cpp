#include "direct/length_errors.h"

#include "base/vector_operations.h"

namespace taut {

void LengthErrors::links_changed(const SystemLinks& links) {
  start_direction.resize(links.size());
  direction.resize(links.size());
  residual.resize(links.size());
  lengths_ = {};
  for (const double length : links.length) {
    lengths_.square.push_back(length * length);
    lengths_.inverse_square.push_back(1.0 / lengths_.square.back());
  }
}

void LengthErrors::begin() {
  misfit_ = {};
  measured_ = {};
}

void LengthErrors::measure(const SystemLinks& links, const Vectors& position, Extent larger) {
  measured_.grow(larger, [&](Extent more) {
    misfit_.add(measure_lengths(links, position, start_direction, lengths_, direction, residual, more));
  });
}

bool LengthErrors::sound(const SystemLinks& links, StepReport& report) const {
  if (misfit_.finite && misfit_.directed) return true;
  report.status = misfit_.finite ? StepStatus::direction_lost : StepStatus::not_finite;
  report.worst_link = worst_link(links, report.status);
  return false;
}

Index LengthErrors::worst_link(const SystemLinks& links, StepStatus what) const {
  Eigen::Index place = 0;
  const auto inverse_square = all_of(lengths_.inverse_square);
  const auto along = [&](const auto& d, const auto& start) { return all_of(d) * all_of(start); };
  if (what == StepStatus::direction_lost)
    ((along(direction.x, start_direction.x) + along(direction.y, start_direction.y) +
      along(direction.z, start_direction.z)) *
     inverse_square)
        .minCoeff<Eigen::PropagateNaN>(&place);
  else
    (all_of(residual) * inverse_square).abs().maxCoeff<Eigen::PropagateNaN>(&place);
  return links.link[static_cast<std::size_t>(place)];
}

}  // namespace taut
