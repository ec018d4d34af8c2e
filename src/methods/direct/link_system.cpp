#include "direct/link_system.h"

#include <algorithm>

#include "base/vector_operations.h"
#include "direct/link_kernels.h"
#include "direct/link_matrices.h"

namespace taut {

namespace {

constexpr std::size_t least_row = 8;  // links in a row, on average, that pay for going row by row

std::vector<LinkRow> find_rows(const SystemLinks& links) {
  std::vector<LinkRow> rows;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const std::size_t a = links.a[i], b = links.b[i];
    if (!rows.empty() && a == rows.back().a + rows.back().count && b == rows.back().b + rows.back().count)
      ++rows.back().count;
    else
      rows.push_back({i, 1, a, b});
  }
  if (rows.size() * least_row > links.size()) rows.clear();
  return rows;
}

EndsToRead ends(const LinkRow& row, const Vectors& vectors) {
  return {row.count, to_read(vectors, row.a), to_read(vectors, row.b)};
}

// Calls visit with the rows, or with the parts of them that lie among some of the links.
template <class Visit>
void visit_rows(const SystemLinks& links, Extent some, const Visit& visit) {
  for (const LinkRow& row : links.rows) {
    const std::size_t begin = std::max(row.begin, some.begin),
                      end = std::min(row.begin + row.count, some.end);
    if (begin < end) visit(LinkRow{begin, end - begin, row.a + begin - row.begin, row.b + begin - row.begin});
  }
}

// What measure(ends, begin) finds, row after row; of all the links at once, whose vectors it then gets, where
// there are no rows.
template <class Measure>
Misfit measure_rows(const SystemLinks& links, const Vectors& position, Vectors& direction, Extent some,
                    const Measure& measure) {
  Misfit found;
  if (some.empty()) return found;
  if (links.rows.empty()) {
    link_vectors(links, position, direction, some);
    return measure(EndsToRead{some.size(), to_read(direction, some.begin), {}}, some.begin);
  }
  visit_rows(links, some, [&](const LinkRow& row) { found.add(measure(ends(row, position), row.begin)); });
  return found;
}

}  // namespace

std::vector<Index> whole_rigid_links(const Model& model, const State& state) {
  std::vector<Index> links;
  for (const Index link : solvable_links(model))
    if (model.links.rigid(link) && !state.broken(link)) links.push_back(link);
  return links;
}

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
  gathered.rows = find_rows(gathered);
  return gathered;
}

void link_vectors(const SystemLinks& links, const Vectors& position, Vectors& difference) {
  difference.resize(links.size());
  link_vectors(links, position, difference, links.all());
}

void link_vectors(const SystemLinks& links, const Vectors& position, Vectors& difference, Extent some) {
  if (!links.rows.empty()) {
    visit_rows(links, some, [&](const LinkRow& row) {
      measure_across(ends(row, position), to_write(difference, row.begin));
    });
    return;
  }
  for (std::size_t i = some.begin; i < some.end; ++i) {
    const Index a = links.a[i], b = links.b[i];
    difference.x[i] = position.x[a] - position.x[b];
    difference.y[i] = position.y[a] - position.y[b];
    difference.z[i] = position.z[a] - position.z[b];
  }
}

Misfit measure_lengths(const SystemLinks& links, const Vectors& position, const Vectors& start_direction,
                       const SquaredLengths& lengths, Vectors& direction, std::vector<double>& misfit,
                       Extent some) {
  return measure_rows(links, position, direction, some, [&](const EndsToRead& ends, std::size_t begin) {
    return measure_lengths(ends, to_read(start_direction, begin), &lengths.square[begin],
                           &lengths.inverse_square[begin], to_write(direction, begin), &misfit[begin]);
  });
}

Misfit measure_stretches(const SystemLinks& links, const Vectors& position,
                         const std::vector<double>& inverse_length, Vectors& direction,
                         std::vector<double>& distance, std::vector<double>& stretch, Extent some) {
  return measure_rows(links, position, direction, some, [&](const EndsToRead& ends, std::size_t begin) {
    return measure_stretches(ends, {&links.length[begin], &inverse_length[begin], to_write(direction, begin),
                                    &distance[begin], &stretch[begin]});
  });
}

void along_links(const SystemLinks& links, const Vectors& columns, const Vectors& u,
                 std::vector<double>& result) {
  result.resize(links.size());
  along_links(links, columns, u, result, links.all());
}

void along_links(const SystemLinks& links, const Vectors& columns, const Vectors& u,
                 std::vector<double>& result, Extent some) {
  if (!links.rows.empty()) {
    visit_rows(links, some, [&](const LinkRow& row) {
      measure_along(ends(row, u), to_read(columns, row.begin), &result[row.begin]);
    });
    return;
  }
  for (std::size_t i = some.begin; i < some.end; ++i)
    result[i] = columns.at(i).dot(u.at(links.a[i]) - u.at(links.b[i]));
}

void along_links_moving(const SystemLinks& links, const Vectors& columns, const Vectors& u, const Vectors& v,
                        std::vector<double>& result) {
  result.resize(links.size());
  if (!links.rows.empty()) {
    for (const LinkRow& row : links.rows)
      measure_along_moving(ends(row, u), ends(row, v), to_read(columns, row.begin), &result[row.begin]);
    return;
  }
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Index a = links.a[i], b = links.b[i];
    result[i] = columns.at(i).dot(u.at(a) - u.at(b)) + (v.at(a) - v.at(b)).squaredNorm();
  }
}

bool along_links_falling(const Model& model, const SystemLinks& links, const Vectors& columns,
                         const Vectors& v, std::vector<double>& result) {
  if (links.rows.empty()) return false;
  result.resize(links.size());
  for (const LinkRow& row : links.rows)
    measure_along_falling({model.gravity, model.drag, &links.weight_a[row.begin], &links.weight_b[row.begin]},
                          ends(row, v), to_read(columns, row.begin), &result[row.begin]);
  return true;
}

void apply_impulses(const SystemLinks& links, const Vectors& columns, std::span<const double> strength,
                    Vectors& target, double factor) {
  if (!links.rows.empty()) {
    for (const LinkRow& row : links.rows) {
      if (row.b == row.a + 1) {
        push_row({row.count, &links.weight_a[row.begin], &links.weight_b[row.begin],
                  to_read(columns, row.begin), &strength[row.begin], factor},
                 to_write(target, row.a), {0, row.count + 1});
        continue;
      }
      const Eigen::Map<const Eigen::ArrayXd> pull(&strength[row.begin], static_cast<Eigen::Index>(row.count));
      const auto push_axis = [&](const std::vector<double>& column, std::vector<double>& axis) {
        const auto along = segment(column, row.begin, row.count);
        segment(axis, row.a, row.count) +=
            factor * segment(links.weight_a, row.begin, row.count) * pull * along;
        segment(axis, row.b, row.count) -=
            factor * segment(links.weight_b, row.begin, row.count) * pull * along;
      };
      for_each_axis(push_axis, columns, target);
    }
    return;
  }
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Index a = links.a[i], b = links.b[i];
    const double on_a = factor * links.weight_a[i] * strength[i],
                 on_b = factor * links.weight_b[i] * strength[i];
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
    return {std::move(ordered), std::move(matrix), true};
  }
  if (const auto tree = tree_order(model, links)) {
    SystemLinks ordered = in_order(*tree, [](const TreeStep& step) { return step.link; });
    auto matrix = make_tree_matrix(model, ordered, *tree);
    return {std::move(ordered), std::move(matrix), false};
  }
  SystemLinks ordered =
      in_order(net_order(gather(model, links), model.masses.size()), [](Index i) { return i; });
  auto matrix = make_net_matrix(ordered, model.masses.size());
  return {std::move(ordered), std::move(matrix), false};
}

}  // namespace taut
