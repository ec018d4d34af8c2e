#include "relax/along_relaxation.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace taut {

void AlongRelaxation::links_changed(const State& state) {
  Relaxation<double>::links_changed(state);
  multiplier_earlier_ = multiplier_before_;
}

void AlongRelaxation::begin_step(double h, double answer) {
  std::swap(multiplier_before_, multiplier_earlier_);
  Relaxation<double>::begin_step(h, answer);
}

void AlongRelaxation::take_back() {
  Relaxation<double>::take_back();
  std::swap(multiplier_before_, multiplier_earlier_);
}

double AlongRelaxation::continued(Index link, double scale) const {
  const std::size_t slot = slot_[link];
  return 2.0 * (arrays_.multiplier[slot] * arrays_.length[slot] * scale) -
         multiplier_before_[slot] * arrays_.length[slot] * scale;
}

void AlongRelaxation::give_continued(double scale, std::vector<double>& continued,
                                     std::vector<double>& last) const {
  for (std::size_t slot = 0; slot < visited_.size(); ++slot) {
    const Index link = visited_[slot];
    if (link == no_link) continue;
    last[link] = arrays_.multiplier[slot] * arrays_.length[slot] * scale;
    continued[link] = 2.0 * last[link] - multiplier_before_[slot] * arrays_.length[slot] * scale;
  }
}

AlongStart AlongRelaxation::pass_along(const Masses& start, Masses& position, PassPlace place, bool judged,
                                       const FreeMotion<double>* motion) {
  const LinkArrays<double> links = arrays();
  found_.resize(sections_.size());
  std::atomic<bool> finite{true};
  const auto visit = [&](std::size_t i, const FreeMotion<double>* moving) {
    found_[i].lost.clear();
    if (!relax_along_start(links, stretches_of(sections_[i]), start.data(), moving, sections_[i].masses,
                           place, judged, position.data(), found_[i]))
      finite.store(false);
  };
  const bool shared = sections_.size() > 1;
  if (shared) workers_->run([&](int part) { visit(static_cast<std::size_t>(part), motion); });
  visit(sections_.size() - 1, shared ? nullptr : motion);
  AlongStart result;
  result.finite = finite.load() && (!place.last || !shared || unsettled_are_finite(position));
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
