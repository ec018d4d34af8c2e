#include "relax/along_relaxation.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace taut {

void AlongRelaxation::links_changed(const State& state) {
  Relaxation<double>::links_changed(state);
  multiplier_before_ = multiplier_earlier_ = arrays_.multiplier;
}

void AlongRelaxation::begin_step(double h, double answer) {
  std::swap(multiplier_before_, multiplier_earlier_);
  std::swap(arrays_.multiplier, multiplier_before_);
  Relaxation<double>::begin_step(h, answer);
}

void AlongRelaxation::take_back() {
  std::swap(arrays_.multiplier, multiplier_before_);
  std::swap(multiplier_before_, multiplier_earlier_);
}

double AlongRelaxation::continued(Index link, double scale) const {
  const std::size_t slot = slot_[link];
  return 2.0 * (arrays_.multiplier[slot] * lay_.length[slot] * scale) -
         multiplier_before_[slot] * lay_.length[slot] * scale;
}

void AlongRelaxation::give_continued(double scale, std::vector<double>& continued,
                                     std::vector<double>& last) const {
  for (std::size_t slot = 0; slot < lay_.visited.size(); ++slot) {
    const Index link = lay_.visited[slot];
    if (link == no_link) continue;
    last[link] = arrays_.multiplier[slot] * lay_.length[slot] * scale;
    continued[link] = 2.0 * last[link] - multiplier_before_[slot] * lay_.length[slot] * scale;
  }
}

AlongStart AlongRelaxation::pass_along(const Masses& start, Masses& position, PassPlace place, bool judged,
                                       const FreeMotion<double>* motion) {
  const LinkArrays<double> links = arrays();
  found_.resize(lay_.sections.size());
  std::atomic<bool> finite{true};
  const auto visit = [&](std::size_t i, const FreeMotion<double>* moving) {
    found_[i].lost.clear();
    if (!relax_along_start(lay_.layout, links, stretches_of(lay_.sections[i]), start.read(), moving,
                           lay_.sections[i].masses, place, judged, position.view(), found_[i]))
      finite.store(false);
  };
  const bool shared = lay_.sections.size() > 1;
  if (shared) workers_->run([&](int part) { visit(static_cast<std::size_t>(part), motion); });
  visit(lay_.sections.size() - 1, shared ? nullptr : motion);
  AlongStart result;
  result.finite = finite.load() && (!place.last || !shared || unsettled_are_finite(position));
  for (const AlongFound& each : found_) {
    result.worst = std::max(result.worst, each.worst);
    // The first one of the model, so that it is the same whatever the parts.
    for (const LostLink& lost : each.lost)
      if (lay_.visited[lost.slot] < result.lost_link) {
        result.lost_link = lay_.visited[lost.slot];
        result.lost_along = lost.along;
      }
  }
  return result;
}

}  // namespace taut
