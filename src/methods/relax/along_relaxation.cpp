#include "relax/along_relaxation.h"

#include <algorithm>

namespace taut {

AlongStart AlongRelaxation::pass_along(const Masses& start, Masses& position, bool first, bool judged) {
  const LinkArrays<double> links = arrays();
  found_.resize(sections_.size());
  const auto visit = [&](std::size_t i) {
    found_[i].lost.clear();
    relax_along_start(links, stretches_of(sections_[i]), start.data(), first, judged, position.data(),
                      found_[i]);
  };
  if (sections_.size() > 1) workers_->run([&](int part) { visit(static_cast<std::size_t>(part)); });
  visit(sections_.size() - 1);
  AlongStart result;
  for (const AlongFound& each : found_) {
    result.worst = std::max(result.worst, each.worst);
    // The first one of the model, so that it is the same whatever the parts.
    for (const LostLink& lost : each.lost)
      if (visited_[lost.slot] < result.lost_link) {
        result.lost_link = visited_[lost.slot];
        result.lost_along = lost.along;
      }
  }
  return result;
}

}  // namespace taut
