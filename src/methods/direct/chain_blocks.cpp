#include "direct/chain_blocks.h"

#include <algorithm>

#include "direct/link_kernels.h"
#include "forces/forces.h"

namespace taut {
namespace {

bool only_falls(const Model& model) {
  return !pushed_from_outside(model) && model.bends.empty() && model.limits.empty() && model.joints.empty();
}

bool is_whole_chain(const Model& model, const SystemLinks& links) {
  if (links.rows.size() != 1 || links.rows[0].a != 0 || links.rows[0].b != 1) return false;
  return links.size() == model.links.size() && links.size() + 1 == model.masses.size() &&
         std::is_sorted(links.link.begin(), links.link.end());
}

}  // namespace

ChainBlocks::ChainBlocks(const Model& model, const SystemLinks& links)
    : several_(only_falls(model) && is_whole_chain(model, links) &&
               std::all_of(links.compliance.begin(), links.compliance.end(),
                           [](double compliance) { return compliance == 0.0; })),
      links_(links.size()),
      masses_(model.masses.size()) {}

void ChainBlocks::push(const Model& model, const SystemLinks& links, const Vectors& columns,
                       std::span<const double> strength, Vectors& target, double factor,
                       Extent masses) const {
  if (!several_) {
    apply_impulses(links, columns, strength, target, factor);
    return;
  }
  // What links know of their ends is what others read of the masses, too.
  const double* inverse_mass = model.masses.inverse_mass.data();
  push_row({links_, inverse_mass, inverse_mass + 1, to_read(columns), strength.data(), factor},
           to_write(target), masses);
}

void measure_falling_chain(const Model& model, const Vectors& columns, const Vectors& v,
                           std::vector<double>& result, Extent links) {
  const double* inverse_mass = &model.masses.inverse_mass[links.begin];
  measure_along_falling({model.gravity, model.drag, inverse_mass, inverse_mass + 1},
                        {links.size(), to_read(v, links.begin), to_read(v, links.begin + 1)},
                        to_read(columns, links.begin), &result[links.begin]);
}

}  // namespace taut
