#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <vector>

#include "model/model.h"

namespace taut {

/// The ways along some of the links from each mass to the pin that is nearest that way (Dijkstra from all
/// pins at once), and so the shortest ways from pin to pin, through free masses, that a link closes.
class WaysFromPins {
 public:
  /// Refers to the model from then on. `leads`: whether a link is one of those.
  WaysFromPins(const Model& model, std::function<bool(Index)> leads);

  struct Way {
    Index from = 0, to = 0;  ///< pins
    Index link = 0;          ///< one of those that it takes
    double length = 0.0;     ///< m
  };

  /// Calls visit(way) with every way that a link closes.
  template <class Visit>
  void visit_closed(const Visit& visit) const {
    for (Index link = 0; link < model_.links.size(); ++link) {
      const Index a = model_.links.a[link], b = model_.links.b[link];
      if (!leads_(link) || (model_.masses.pinned(a) && model_.masses.pinned(b))) continue;
      if (pin_[a] == no_mass || pin_[b] == no_mass || pin_[a] == pin_[b]) continue;
      visit(Way{std::min(pin_[a], pin_[b]), std::max(pin_[a], pin_[b]), link,
                way_[a] + model_.links.length[link] + way_[b]});
    }
  }

  /// Goes on in the parts without pins, from the first mass of each as if it were one.
  void reach_parts_without_pins();
  /// The longest of the ways to a mass so far (m).
  double longest() const;

 private:
  static constexpr Index no_mass = std::numeric_limits<Index>::max();
  void list_neighbours();
  void walk_from(const std::vector<Index>& roots);

  const Model& model_;
  std::function<bool(Index)> leads_;
  std::vector<std::size_t> first_;  // where each mass's stretch of links_at_ begins
  std::vector<Index> links_at_;
  std::vector<double> way_;  // m, from the nearest pin; infinity where no such links lead to one
  std::vector<Index> pin_;   // which pin that is
};

}  // namespace taut
