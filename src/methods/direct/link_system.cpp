#include "direct/link_system.h"

#include <algorithm>

#include "direct/link_matrices.h"

namespace taut {

SystemLinks gather(const Model& model, std::span<const Index> links) {
  SystemLinks gathered;
  for (const Index link : links) {
    const Index a = model.links.a[link], b = model.links.b[link];
    gathered.link.push_back(link);
    gathered.a.push_back(a);
    gathered.b.push_back(b);
    gathered.weight_a.push_back(model.masses.inverse_mass[a]);
    gathered.weight_b.push_back(model.masses.inverse_mass[b]);
    gathered.length.push_back(model.links.length[link]);
    gathered.compliance.push_back(model.links.compliance(link));
    gathered.damping.push_back(model.links.damping[link]);
  }
  return gathered;
}

void link_vectors(const SystemLinks& links, const Vectors& position, Vectors& difference) {
  difference.resize(links.size());
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Index a = links.a[i], b = links.b[i];
    difference.x[i] = position.x[a] - position.x[b];
    difference.y[i] = position.y[a] - position.y[b];
    difference.z[i] = position.z[a] - position.z[b];
  }
}

void along_links(const SystemLinks& links, const Vectors& columns, const Vectors& u,
                 std::vector<double>& result) {
  result.resize(links.size());
  for (std::size_t i = 0; i < links.size(); ++i)
    result[i] = columns.at(i).dot(u.at(links.a[i]) - u.at(links.b[i]));
}

void apply_impulses(const SystemLinks& links, const Vectors& columns, std::span<const double> strength,
                    Vectors& target) {
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Index a = links.a[i], b = links.b[i];
    const double on_a = links.weight_a[i] * strength[i], on_b = links.weight_b[i] * strength[i];
    target.x[a] += on_a * columns.x[i];
    target.y[a] += on_a * columns.y[i];
    target.z[a] += on_a * columns.z[i];
    target.x[b] -= on_b * columns.x[i];
    target.y[b] -= on_b * columns.y[i];
    target.z[b] -= on_b * columns.z[i];
  }
}

LinkSystem make_link_system(const Model& model, const std::vector<Index>& links) {
  const auto in_order = [&](const auto& order, auto position) {
    std::vector<Index> ordered(links.size());
    std::transform(order.begin(), order.end(), ordered.begin(),
                   [&](const auto& entry) { return links[position(entry)]; });
    return gather(model, ordered);
  };
  if (const auto path = path_order(model, links)) {
    SystemLinks ordered = in_order(*path, [](Index i) { return i; });
    auto matrix = make_path_matrix(ordered);
    return {std::move(ordered), std::move(matrix)};
  }
  if (const auto tree = tree_order(model, links)) {
    SystemLinks ordered = in_order(*tree, [](const TreeStep& step) { return step.link; });
    auto matrix = make_tree_matrix(model, ordered, *tree);
    return {std::move(ordered), std::move(matrix)};
  }
  SystemLinks ordered =
      in_order(net_order(gather(model, links), model.masses.size()), [](Index i) { return i; });
  auto matrix = make_net_matrix(ordered, model.masses.size());
  return {std::move(ordered), std::move(matrix)};
}

}  // namespace taut
