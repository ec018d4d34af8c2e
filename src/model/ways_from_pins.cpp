#include "model/ways_from_pins.h"

#include <queue>
#include <utility>

namespace taut {

WaysFromPins::WaysFromPins(const Model& model, std::function<bool(Index)> leads)
    : model_(model),
      leads_(std::move(leads)),
      first_(model.masses.size() + 1, 0),
      way_(model.masses.size(), infinity),
      pin_(model.masses.size(), no_mass) {
  list_neighbours();
  std::vector<Index> pins;
  for (Index mass = 0; mass < model.masses.size(); ++mass)
    if (model.masses.pinned(mass)) pins.push_back(mass);
  walk_from(pins);
}

// Links mass by mass, as stretches of one list.
void WaysFromPins::list_neighbours() {
  const Links& links = model_.links;
  for (Index link = 0; link < links.size(); ++link)
    if (leads_(link)) {
      ++first_[links.a[link] + 1];
      ++first_[links.b[link] + 1];
    }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  links_at_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (Index link = 0; link < links.size(); ++link)
    if (leads_(link)) {
      links_at_[next[links.a[link]]++] = link;
      links_at_[next[links.b[link]]++] = link;
    }
}

void WaysFromPins::walk_from(const std::vector<Index>& roots) {
  using Reached = std::pair<double, Index>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
  for (const Index root : roots) {
    way_[root] = 0.0;
    pin_[root] = root;
    open.emplace(0.0, root);
  }
  while (!open.empty()) {
    const auto [way, mass] = open.top();
    open.pop();
    if (way > way_[mass]) continue;
    for (std::size_t k = first_[mass]; k < first_[mass + 1]; ++k) {
      const Index link = links_at_[k];
      const Index other = model_.links.a[link] == mass ? model_.links.b[link] : model_.links.a[link];
      const double longer = way + model_.links.length[link];
      if (!(longer < way_[other])) continue;
      way_[other] = longer;
      pin_[other] = pin_[mass];
      open.emplace(longer, other);
    }
  }
}

void WaysFromPins::reach_parts_without_pins() {
  for (Index mass = 0; mass < way_.size(); ++mass)
    if (way_[mass] == infinity) walk_from({mass});
}

double WaysFromPins::longest() const {
  double longest = 0.0;
  for (const double way : way_)
    if (way < infinity) longest = std::max(longest, way);
  return longest;
}

}  // namespace taut
