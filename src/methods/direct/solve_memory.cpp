#include "direct/solve_memory.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/parts.h"

namespace taut {
namespace {

constexpr double bytes_of_row = 300.0, bytes_of_pair = 15.0;

// Of some of a model's links.
struct Net {
  double links = 0.0, free_masses = 0.0;
  double pairs = 0.0;  // of links that share a mass that moves
};

template <class Counts>
Net count_links(const Model& model, const Counts& counts) {
  Net net;
  std::vector<double> links_at(model.masses.size(), 0.0);
  for (std::size_t i = 0; i < model.links.size(); ++i)
    if (counts(i)) {
      ++net.links;
      for (const Index mass : {model.links.a[i], model.links.b[i]}) ++links_at[mass];
    }
  for (std::size_t mass = 0; mass < links_at.size(); ++mass)
    if (!model.masses.pinned(mass)) {
      ++net.free_masses;
      net.pairs += 0.5 * links_at[mass] * (links_at[mass] - 1.0);
    }
  return net;
}

Net all_links(const Model& model) {
  return count_links(model, [](std::size_t) { return true; });
}

double bytes_of_factor(const Net& net) {
  return share_of_net(net.links, net.free_masses) *
         (bytes_of_row * net.links + bytes_of_pair * net.pairs * std::log2(std::max(1.0, net.links)));
}

}  // namespace

double bytes_of_links_factor(const Model& model) {
  return bytes_of_factor(all_links(model));
}

double bytes_of_rigid_links_factor(const Model& model) {
  return bytes_of_factor(count_links(model, [&](std::size_t link) { return model.links.rigid(link); }));
}

double bytes_of_masses_factor(const Model& model, double bytes) {
  const Net net = all_links(model);
  return std::lerp(0.5, 1.0, share_of_net(net.links, net.free_masses)) * bytes * net.links *
         std::log2(std::max(1.0, static_cast<double>(model.masses.size())));
}

}  // namespace taut
