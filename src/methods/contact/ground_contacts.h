#pragma once

#include <vector>

#include "model/model.h"

namespace taut {

/// Contact of single masses with the ground, half-spaces that give nothing back: the plain case, without a
/// list of what is near, without memory, and all that some methods know. Every mass is looked at in every
/// pass, so that nothing passes through however far it is pushed.
class GroundContacts {
 public:
  explicit GroundContacts(const Model& model);

  bool empty() const { return grounds_.empty() || masses_.empty(); }

  /// One pass: pushes masses that have entered the ground back to its surface, and takes from their way along
  /// it since `start` what Coulomb's law allows. Returns whether there were any.
  bool solve(const Vectors& start, Vectors& position) const;

 private:
  struct Ground {
    HalfSpace half_space;
    double friction;
  };

  std::vector<Ground> grounds_;
  std::vector<Index> masses_;   // the free ones that are plain contact points …
  std::vector<double> radius_;  // … and how far their surfaces are from their middles (m)
};

}  // namespace taut
