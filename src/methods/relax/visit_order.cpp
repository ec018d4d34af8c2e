#include "relax/visit_order.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace taut {
namespace {

// What stays in the cache nearest to a processor while the colours go over it.
constexpr std::size_t masses_in_block = 2048;
constexpr std::size_t masses_in_cache = 2048;
// A longer row is taken as several.
constexpr std::size_t masses_in_row = 1024;

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

// Links by colour, given greedily.
std::vector<std::vector<Index>> coloured(const Model& model, const std::vector<Index>& links) {
  ColoursUsed used(model.masses);
  std::vector<std::vector<Index>> by_colour;
  for (const Index link : links) {
    const Index a = model.links.a[link], b = model.links.b[link];
    const std::size_t colour = used.first_free(a, b);
    used.take(a, colour);
    used.take(b, colour);
    if (by_colour.size() <= colour) by_colour.resize(colour + 1);
    by_colour[colour].push_back(link);
  }
  return by_colour;
}

// The free masses at the other ends of each free mass's links.
std::vector<std::vector<Index>> neighbours_of(const Model& model, const std::vector<Index>& links) {
  std::vector<std::vector<Index>> neighbours(model.masses.size());
  for (const Index link : links) {
    const Index a = model.links.a[link], b = model.links.b[link];
    if (model.masses.pinned(a) || model.masses.pinned(b)) continue;
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  return neighbours;
}

// Breadth first from a mass of few links, and at each mass those of fewest links first.
std::vector<Index> breadth_first(const Model& model, const std::vector<Index>& links,
                                 std::vector<Index> masses) {
  std::vector<std::vector<Index>> neighbours = neighbours_of(model, links);
  const auto fewer = [&](Index a, Index b) {
    return std::pair(neighbours[a].size(), a) < std::pair(neighbours[b].size(), b);
  };
  std::ranges::sort(masses, fewer);
  std::vector<bool> seen(model.masses.size(), false);
  std::vector<Index> order;
  const auto see = [&](Index mass) {
    if (seen[mass]) return;
    seen[mass] = true;
    order.push_back(mass);
  };
  std::size_t next = 0;
  for (const Index first : masses) {
    see(first);
    for (; next < order.size(); ++next) {
      std::vector<Index>& around = neighbours[order[next]];
      std::ranges::sort(around, fewer);
      for (const Index mass : around) see(mass);
    }
  }
  return order;
}

// The place of each mass in an order; pins have none.
std::vector<Index> places_in(const std::vector<Index>& order, std::size_t count) {
  std::vector<Index> place(count, 0);
  for (std::size_t i = 0; i < order.size(); ++i)
    if (order[i] != empty_place) place[order[i]] = static_cast<Index>(i);
  return place;
}

// How far the ends of links lie apart, summed over the links.
double spread(const Model& model, const std::vector<Index>& links, const std::vector<Index>& place) {
  double sum = 0.0;
  for (const Index link : links) {
    const Index a = model.links.a[link], b = model.links.b[link];
    if (!model.masses.pinned(a) && !model.masses.pinned(b))
      sum += std::abs(static_cast<double>(place[a]) - static_cast<double>(place[b]));
  }
  return sum;
}

// The places of a link's free ends, the lower one first.
std::pair<Index, Index> ends_of(const Model& model, Index link, const std::vector<Index>& place) {
  const Index a = model.links.a[link], b = model.links.b[link];
  if (model.masses.pinned(a)) return {place[b], place[b]};
  if (model.masses.pinned(b)) return {place[a], place[a]};
  return std::minmax(place[a], place[b]);
}

// With a place at least in which there is no mass, so that gaps of links end there and not over the next row.
void end_row(std::vector<Index>& order, std::size_t width) {
  order.push_back(empty_place);
  while (order.size() % width != 0) order.push_back(empty_place);
}

}  // namespace

std::vector<Index> mass_order(const Model& model, const std::vector<Index>& links) {
  std::vector<Index> numbered;
  for (std::size_t mass = 0; mass < model.masses.size(); ++mass)
    if (!model.masses.pinned(mass)) numbered.push_back(static_cast<Index>(mass));
  std::vector<Index> sought = breadth_first(model, links, numbered);
  const std::size_t count = model.masses.size();
  const bool nearer =
      spread(model, links, places_in(sought, count)) < spread(model, links, places_in(numbered, count));
  return nearer ? sought : numbered;
}

std::vector<Index> row_order(const Model& model, const std::vector<Index>& links, std::size_t width) {
  const std::size_t count = model.masses.size();
  std::vector<bool> linked_to_next(count, false), linked_over_one(count, false);
  for (const Index link : links) {
    const auto [low, high] = std::minmax(model.links.a[link], model.links.b[link]);
    if (high - low == 1) linked_to_next[low] = true;
    if (high - low == 2) linked_over_one[low] = true;
  }
  std::vector<Index> order;
  for (std::size_t begin = 0; begin < count;) {
    std::size_t end = begin + 1;
    bool over_one = linked_over_one[begin];
    for (; end < count && end - begin < masses_in_row && linked_to_next[end - 1]; ++end)
      over_one = over_one || linked_over_one[end];
    const std::size_t step = end - begin < 2 * width ? 1 : over_one ? 4 : 2;
    for (std::size_t first = begin; first < begin + step; ++first) {
      for (std::size_t mass = first; mass < end; mass += step)
        if (!model.masses.pinned(mass))
          order.push_back(static_cast<Index>(mass));
        else if (step > 1)
          order.push_back(empty_place);
      if (step > 1) end_row(order, width);
    }
    begin = end;
  }
  return order;
}

bool follow_each_other(const Model& model, const std::vector<Index>& links) {
  constexpr std::int64_t soon = 4;
  std::unordered_map<std::int64_t, std::int64_t> last;  // first end of the last link of a kind
  std::size_t following = 0;
  for (const Index link : links) {
    const std::int64_t a = model.links.a[link], b = model.links.b[link];
    const auto [before, first] = last.try_emplace(b - a, a);
    if (!first && a > before->second && a - before->second <= soon) ++following;
    before->second = a;
  }
  return 4 * following >= 3 * links.size();
}

std::vector<Index> listed_as_in_sheets(const Model& model, std::vector<Index> links) {
  if (follow_each_other(model, links)) return links;
  std::vector<Index> sorted = links;
  std::ranges::sort(sorted, {}, [&](Index link) {
    const std::int64_t a = model.links.a[link], b = model.links.b[link];
    return std::tuple(b - a, a, link);
  });
  return follow_each_other(model, sorted) ? sorted : links;
}

// A link is visited with the block of its lower mass, or with the last of the blocks of those links of
// earlier colours that share a mass with it: so each of them comes before it, in an earlier block or, in the
// same one, with its earlier colour.
VisitOrder visit_order(const Model& model, const std::vector<Index>& links, std::vector<Index> masses) {
  VisitOrder order;
  order.masses = std::move(masses);
  const std::vector<Index> place = places_in(order.masses, model.masses.size());
  const std::size_t block_size =
      order.masses.size() > masses_in_cache ? masses_in_block : std::max<std::size_t>(1, order.masses.size());
  std::vector<std::size_t> last_block(order.masses.size(), 0);
  std::map<std::pair<std::size_t, std::size_t>, VisitOrder::Run> runs;  // by block and colour
  std::size_t colour = 0;
  for (const std::vector<Index>& of_colour : coloured(model, links)) {
    for (const Index link : of_colour) {
      const auto [low, high] = ends_of(model, link, place);
      const std::size_t block = std::max({low / block_size, last_block[low], last_block[high]});
      last_block[low] = last_block[high] = block;
      runs[{block, colour}].push_back(link);
    }
    ++colour;
  }
  for (auto& [key, run] : runs) {
    std::ranges::sort(run, {}, [&](Index link) { return std::pair(ends_of(model, link, place), link); });
    order.runs.push_back(std::move(run));
  }
  return order;
}

}  // namespace taut
