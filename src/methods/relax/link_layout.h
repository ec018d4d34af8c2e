#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/model.h"
#include "relax/kernels.h"
#include "relax/mass_places.h"
#include "relax/visit_order.h"

namespace taut {

/// Stretches that one thread visits.
struct LinkSection {
  std::size_t begin, end;
  MassRange masses;
};

/// Where the links and the masses of a relaxation lie in memory, for kernels to go over them.
template <class Real>
struct LinkLayout : MassPlaces<Real> {
  std::vector<LinkStretch> stretches;
  std::vector<LinkSection> sections;  ///< of the threads; where there are several, one more for the rest
  std::vector<std::uint32_t> a, b;    ///< ends, as LinkStretch::ends has it
  std::vector<Index> visited;         ///< link by slot; no_link where there is none
  AlignedVector<Real> length;         ///< by slot (m)
  std::vector<Index> special;         ///< link by special place; no_link likewise
  std::size_t adjoining = 0;          ///< links in stretches with a stride
};

/// For these links, visited in this order, whose masses lie as it has them, shared among as many threads.
/// `equal_weight`: the inverse mass of links that are to be kept apart, 1/kg.
template <class Real>
LinkLayout<Real> lay_out_links(const Model& model, const VisitOrder& order, Layout layout,
                               double equal_weight, std::size_t threads);

}  // namespace taut
