#include <fmt/format.h>

#include <cmath>

#include "builder.h"

namespace taut {
namespace {

constexpr double written = 1e-6;  // of a length: what seven written digits tell apart

}  // namespace

void find_overreach(const Builder& builder, std::vector<Problem>& problems) {
  const Model& model = builder.model;
  for (const Limit& limit : model.limits) {
    if (limit.kind != LimitKind::reach || limit.compliance > 0.0) continue;
    const double distance = link_distance(model, builder.start.position, limit.link);
    const double strain = model.links.strain(limit.link, distance);
    if (!(std::abs(strain) > written)) continue;
    const Builder::Entry& entry = builder.entry_of(limit.link);
    const FreeRange& range = model.links.free_range[limit.link];
    const auto& names = model.masses.name;
    problems.push_back(
        {std::string(entry.section), entry.index, "acts",
         strain > 0.0
             ? fmt::format("at the start \"{}\" and \"{}\" are {:.6g} m apart, and their link, which is "
                           "rigid, lets them be {:.6g} m at most",
                           names[limit.masses[0]], names[limit.masses[1]], distance, range.longest)
             : fmt::format("at the start \"{}\" and \"{}\" are {:.6g} m apart, and their link, which is "
                           "rigid, lets them be {:.6g} m at least",
                           names[limit.masses[0]], names[limit.masses[1]], distance, range.shortest),
         ""});
    return;  // one tells of its kind
  }
}

}  // namespace taut
