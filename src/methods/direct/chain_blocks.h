#pragma once

#include <algorithm>
#include <span>

#include "base/vector_operations.h"
#include "direct/link_system.h"
#include "extent.h"

namespace taut {

/// How a step goes over the links of a system and the masses: block by block where they are one chain that
/// hangs or falls with gravity and drag alone. What follows each other in the step then meets links and
/// masses at hand, and only the last of it memory. Elsewhere all links are one block. In such a chain the
/// links are rigid, and all that there are, in the model's order; link i joins the masses i and i + 1, and
/// there are no others.
class ChainBlocks {
 public:
  ChainBlocks() = default;
  ChainBlocks(const Model& model, const SystemLinks& links);

  bool several() const { return several_; }
  Extent all_masses() const { return {0, masses_}; }

  /// Visits the links, one block after the other.
  template <class Visit>
  void visit(const Visit& visit_block) const {
    const std::size_t most = several_ ? block_size : links_;
    std::size_t begin = 0, end = 0;
    do {
      end = std::min(links_, begin + most);
      visit_block(Extent{begin, end});
      begin = end;
    } while (end < links_);
  }

  /// Visits the masses likewise.
  template <class Visit>
  void visit_masses(const Visit& visit_block) const {
    GrowingExtent masses;
    visit([&](Extent block) { masses.grow(masses_among({0, block.end}), visit_block); });
  }

  /// Masses all of whose links are among some.
  Extent masses_among(Extent links) const {
    return {links.begin == 0 ? 0 : links.begin + 1, links.end == links_ ? masses_ : links.end};
  }
  /// Masses that some links join.
  Extent masses_at(Extent links) const {
    return several_ ? Extent{links.begin, links.end + 1} : all_masses();
  }
  /// Links both of whose masses are among some.
  Extent links_among(Extent masses) const {
    return {masses.begin, masses.end == masses_ ? links_ : masses.end - 1};
  }

  /// apply_impulses() to some masses, one mass after the other and not one link. All links of theirs must
  /// have their strengths.
  void push(const Model& model, const SystemLinks& links, const Vectors& columns,
            std::span<const double> strength, Vectors& target, double factor, Extent masses) const;

 private:
  static constexpr std::size_t block_size = 256;  // links, like the blocks of both sides of a path's matrix

  bool several_ = false;
  std::size_t links_ = 0, masses_ = 0;
};

/// The numbers of an extent, for arithmetic on several at once.
template <class Numbers>
auto some_of(Numbers& numbers, Extent some) {
  return segment(numbers, some.begin, some.size());
}

/// along_links_falling() of a model that is one chain, see ChainBlocks, in some of its links.
void measure_falling_chain(const Model& model, const Vectors& columns, const Vectors& v,
                           std::vector<double>& result, Extent links);

}  // namespace taut
