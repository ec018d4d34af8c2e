#include "direct/solve_memory.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace taut {
namespace {

constexpr double bytes_of_row = 300.0, bytes_of_pair = 15.0;

// 0 for chains and trees to 1 for nets, in which every other link or more closes a ring.
double share_of_rings(const Model& model) {
  const auto links = static_cast<double>(model.links.size()),
             free = static_cast<double>(std::ranges::count_if(model.masses.inverse_mass,
                                                              [](double weight) { return weight > 0.0; }));
  return links <= free ? 0.0 : std::min(1.0, 2.0 * (links - free) / links);
}

double pairs_that_share_a_mass(const Model& model) {
  std::vector<double> links_at(model.masses.size(), 0.0);
  for (std::size_t i = 0; i < model.links.size(); ++i)
    for (const Index mass : {model.links.a[i], model.links.b[i]})
      if (!model.masses.pinned(mass)) ++links_at[mass];
  double pairs = 0.0;
  for (const double links : links_at) pairs += 0.5 * links * (links - 1.0);
  return pairs;
}

}  // namespace

double bytes_of_links_factor(const Model& model) {
  if (model.links.size() == 0) return 0.0;
  const auto rows = static_cast<double>(model.links.size());
  return share_of_rings(model) *
         (bytes_of_row * rows + bytes_of_pair * pairs_that_share_a_mass(model) * std::log2(rows));
}

double bytes_of_masses_factor(const Model& model, double bytes) {
  if (model.masses.size() == 0) return 0.0;
  return std::lerp(0.5, 1.0, share_of_rings(model)) * bytes * static_cast<double>(model.links.size()) *
         std::log2(static_cast<double>(model.masses.size()));
}

}  // namespace taut
