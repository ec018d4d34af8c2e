#include "model/size.h"

#include "builder.h"

namespace taut {
namespace {

// As measured with sheets and chains of a million links; see docs/scale.md.
constexpr double bytes_per_mass = 1150.0, bytes_per_link = 250.0, bytes_per_triangle = 48.0,
                 bytes_per_knot = 120.0;
constexpr double seconds_per_part = 0.7e-6;

template <typename Spec>
Counts count_all(const std::vector<Spec>& specs) {
  Counts sum;
  for (const Spec& spec : specs) sum += count(spec);
  return sum;
}

}  // namespace

Counts& Counts::operator+=(const Counts& other) {
  masses += other.masses;
  links += other.links;
  triangles += other.triangles;
  knots += other.knots;
  return *this;
}

Counts count(const Description& description) {
  Counts sum = count_all(description.chains);
  sum += count_all(description.sheets);
  sum += count_all(description.meshes);
  sum += count_all(description.points);
  sum += count_all(description.ragdolls);
  sum += {static_cast<double>(description.masses.size()), static_cast<double>(description.links.size()), 0.0,
          0.0};
  return sum;
}

double bytes_needed(const Counts& counts) {
  return counts.masses * bytes_per_mass + counts.links * bytes_per_link +
         counts.triangles * bytes_per_triangle + counts.knots * bytes_per_knot;
}

double seconds_to_build(const Counts& counts) {
  return seconds_per_part * (counts.masses + counts.links + counts.triangles);
}

}  // namespace taut
