#include "relax/link_order.h"

#include <algorithm>

namespace taut {
namespace {

// Colours already used at each mass, as growing sets of bits.
class ColoursUsed {
 public:
  explicit ColoursUsed(const Masses& masses) : masses_(masses), used_(masses.size()) {}

  std::size_t first_free(Index a, Index b) const {
    std::size_t colour = 0;
    while (has(a, colour) || has(b, colour)) ++colour;
    return colour;
  }
  void take(Index mass, std::size_t colour) {
    if (masses_.pinned(mass)) return;
    std::vector<bool>& used = used_[mass];
    if (used.size() <= colour) used.resize(colour + 1);
    used[colour] = true;
  }

 private:
  bool has(Index mass, std::size_t colour) const {
    return colour < used_[mass].size() && used_[mass][colour];
  }

  const Masses& masses_;
  std::vector<std::vector<bool>> used_;
};

}  // namespace

OrderedLinks coloured_order(const Model& model, const State& state) {
  ColoursUsed used(model.masses);
  std::vector<std::vector<Index>> by_colour;
  for (const Index link : solvable_links(model)) {
    if (state.broken(link)) continue;
    const Index a = model.links.a[link], b = model.links.b[link];
    const std::size_t colour = used.first_free(a, b);
    used.take(a, colour);
    used.take(b, colour);
    if (by_colour.size() <= colour) by_colour.resize(colour + 1);
    by_colour[colour].push_back(link);
  }
  OrderedLinks order;
  for (const auto& links : by_colour) {
    order.links.insert(order.links.end(), links.begin(), links.end());
    order.colour_ends.push_back(order.links.size());
  }
  return order;
}

}  // namespace taut
