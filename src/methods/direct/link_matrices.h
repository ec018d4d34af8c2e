#pragma once

#include <cmath>
#include <memory>
#include <optional>

#include "direct/link_topology.h"

namespace taut {

/// A pivot that elimination has left at less than 1e-11 of its matrix entry is rounding: the link is
/// redundant (a taut straight row between two pins). It is given a share of the entry instead, which acts as
/// a compliance in that link alone; where the lengths can be met Newton's method still meets them, because
/// residuals are not touched.
inline constexpr double least_pivot_share = 1e-11;
inline double mended_pivot(double pivot, double entry) {
  return std::abs(pivot) < least_pivot_share * std::abs(entry) ? 1e-7 * entry : pivot;
}

/// For links in path_order().
std::unique_ptr<LinkMatrix> make_path_matrix(const SystemLinks& links);

/// For links in the order of the steps, whose `link` then counts 0, 1, 2 …
std::unique_ptr<LinkMatrix> make_tree_matrix(const Model& model, const SystemLinks& links,
                                             const std::vector<TreeStep>& steps);

/// An order of any links that fills their matrix little when it is factorised: their places in it.
std::vector<Index> net_order(const SystemLinks& links, std::size_t mass_count);

/// The place of the first link, in the order of a factorisation, whose row those before it leave no say
/// (nothing where none is): of any links along their directions.
std::optional<std::size_t> dependent_row(const SystemLinks& links, const Vectors& directions,
                                         std::size_t mass_count);

/// For links in that order.
std::unique_ptr<LinkMatrix> make_net_matrix(const SystemLinks& links, std::size_t mass_count);

}  // namespace taut
