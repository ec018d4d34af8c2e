#include "model/model.h"

namespace taut {

double total_link_length(const Model& model) {
  double sum = 0.0;
  for (const double length : model.links.length) sum += length;
  return sum;
}

std::vector<Index> solvable_links(const Model& model) {
  std::vector<Index> links;
  for (std::size_t i = 0; i < model.links.size(); ++i)
    if (!model.masses.pinned(model.links.a[i]) || !model.masses.pinned(model.links.b[i]))
      links.push_back(static_cast<Index>(i));
  return links;
}

}  // namespace taut
