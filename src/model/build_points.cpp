#include <fmt/format.h>

#include <algorithm>

#include "builder.h"

namespace taut {
namespace {

bool is_pinned(const PointsSpec& spec, const PointsData::Mass& mass) {
  return mass.pinned || std::ranges::find(spec.pinned, mass.name) != spec.pinned.end();
}

LinkProperties properties_of(const PointsSpec& spec, const PointsData::Link& link) {
  LinkProperties properties = spec.properties;
  if (link.stiffness) properties.stiffness = link.stiffness;
  if (link.damping) properties.damping = *link.damping;
  if (link.break_stretch) properties.break_stretch = link.break_stretch;
  if (link.break_tension) properties.break_tension = link.break_tension;
  return properties;
}

}  // namespace

Counts count(const PointsSpec& spec) {
  if (!spec.data) return {};
  return {static_cast<double>(spec.data->masses.size()), static_cast<double>(spec.data->links.size()), 0.0,
          0.0};
}

void add_points(Builder& builder, const PointsSpec& spec) {
  Model& model = builder.model;
  PointSet set{spec.name, static_cast<Index>(model.masses.size()), 0, 0, 0};
  builder.begin_body(spec.collides);
  for (const PointsData::Mass& mass : spec.data->masses)
    builder.add_mass(fmt::format("{}.{}", spec.name, mass.name), mass.position, mass.velocity,
                     mass.mass.value_or(spec.mass), is_pinned(spec, mass), mass.radius.value_or(spec.radius));
  set.mass_count = static_cast<Index>(model.masses.size()) - set.first_mass;
  set.first_link = static_cast<Index>(model.links.size());
  for (const PointsData::Link& link : spec.data->links) {
    const Vec3 apart = spec.data->masses[link.a].position - spec.data->masses[link.b].position;
    builder.add_link(set.first_mass + link.a, set.first_mass + link.b, link.length.value_or(apart.norm()),
                     properties_of(spec, link));
  }
  set.link_count = static_cast<Index>(model.links.size()) - set.first_link;
  model.point_sets.push_back(std::move(set));
}

}  // namespace taut
