#include "direct/link_topology.h"

#include <algorithm>

namespace taut {
namespace {

// For every mass, the positions in the list of the links at it; pins have none.
std::vector<std::vector<Index>> links_at_free_masses(const Model& model, const std::vector<Index>& links) {
  std::vector<std::vector<Index>> at(model.masses.size());
  for (std::size_t i = 0; i < links.size(); ++i)
    for (const Index mass : {model.links.a[links[i]], model.links.b[links[i]]})
      if (!model.masses.pinned(mass)) at[mass].push_back(static_cast<Index>(i));
  return at;
}

Index other_end(const Model& model, Index link, Index mass) {
  return model.links.a[link] == mass ? model.links.b[link] : model.links.a[link];
}

}  // namespace

std::optional<std::vector<Index>> path_order(const Model& model, const std::vector<Index>& links) {
  const auto at = links_at_free_masses(model, links);
  for (const auto& here : at)
    if (here.size() > 2) return std::nullopt;
  std::vector<bool> taken(links.size(), false);
  std::vector<Index> order;
  const auto is_end = [&](Index mass) { return model.masses.pinned(mass) || at[mass].size() == 1; };
  for (std::size_t first = 0; first < links.size(); ++first) {
    const Index a = model.links.a[links[first]], b = model.links.b[links[first]];
    if (taken[first] || (!is_end(a) && !is_end(b))) continue;
    Index mass = is_end(a) ? b : a;
    std::size_t link = first;
    while (link < links.size()) {
      taken[link] = true;
      order.push_back(static_cast<Index>(link));
      link = links.size();
      for (const Index next : at[mass])
        if (!taken[next]) link = next;
      if (link < links.size()) mass = other_end(model, links[link], mass);
    }
  }
  if (order.size() < links.size()) return std::nullopt;  // the rest are rings
  return order;
}

std::optional<std::vector<TreeStep>> tree_order(const Model& model, const std::vector<Index>& links) {
  const auto at = links_at_free_masses(model, links);
  std::vector<bool> seen_mass(model.masses.size(), false), seen_link(links.size(), false);
  std::vector<TreeStep> from_roots;
  const auto grow = [&](Index root) {
    std::vector<Index> frontier{root};
    seen_mass[root] = true;
    while (!frontier.empty()) {
      const Index above = frontier.back();
      frontier.pop_back();
      for (const Index link : at[above]) {
        if (seen_link[link]) continue;
        const Index below = other_end(model, links[link], above);
        if (model.masses.pinned(below) || seen_mass[below]) return false;  // a second pin, or a ring
        seen_link[link] = seen_mass[below] = true;
        from_roots.push_back({link, below, static_cast<std::ptrdiff_t>(above)});
        frontier.push_back(below);
      }
    }
    return true;
  };
  // A link to a pin can only be eliminated after the mass below it, so such links are the roots.
  for (std::size_t link = 0; link < links.size(); ++link) {
    const Index a = model.links.a[links[link]], b = model.links.b[links[link]];
    if (!model.masses.pinned(a) && !model.masses.pinned(b)) continue;
    const Index below = model.masses.pinned(a) ? b : a;
    if (seen_mass[below]) return std::nullopt;
    seen_link[link] = true;
    from_roots.push_back({static_cast<Index>(link), below, -1});
    if (!grow(below)) return std::nullopt;
  }
  for (std::size_t link = 0; link < links.size(); ++link)
    if (!seen_link[link] && !grow(model.links.a[links[link]])) return std::nullopt;
  std::reverse(from_roots.begin(), from_roots.end());
  return from_roots;
}

}  // namespace taut
