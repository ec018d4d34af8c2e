#pragma once

#include <cstddef>
#include <vector>

#include "base/workers.h"
#include "relax/visit_order.h"

namespace taut {

/// A visit order shared out among threads. Each part has masses that lie together, and those links between
/// them that depend on no other part; the rest, around where two parts meet, comes after all parts. So any
/// number of parts gives the result of one.
struct VisitParts {
  struct Part {
    std::size_t begin = 0, end = 0;  ///< its masses, as places in VisitOrder::masses
    /// Those of them that no link of the rest touches; others may lie before and after.
    std::size_t settled_begin = 0, settled_end = 0;
    std::vector<VisitOrder::Run> runs;
  };
  std::vector<Part> parts;
  std::vector<VisitOrder::Run> rest;
};

/// How many threads so many links are shared among: few stay on one.
std::size_t threads_for(const Workers* workers, std::size_t links);

/// At least one part.
VisitParts share_out(const Model& model, const VisitOrder& order, std::size_t parts);

}  // namespace taut
