#include "builder.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

namespace taut {

namespace {

// A number from −1 to 1 for each seed and link, the same everywhere (Steele, Lea and Flood, Fast Splittable
// Pseudorandom Number Generators, 2014).
double spread(int seed, Index link) {
  std::uint64_t bits = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(seed)) << 32U) + link;
  bits += 0x9e3779b97f4a7c15U;
  bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
  bits ^= bits >> 31U;
  return static_cast<double>(bits >> 11U) * 0x1.0p-52 - 1.0;
}

}  // namespace

Change& Builder::change_at(double time) {
  auto place = std::ranges::lower_bound(model.changes, time, {}, &Change::time);
  if (place == model.changes.end() || place->time != time)
    place = model.changes.insert(place, {time, {}, {}});
  return *place;
}

void Builder::weaken(Index link, double share) {
  double& stretch = model.links.break_stretch[link];
  stretch = 1.0 + (stretch - 1.0) * share;
  model.links.break_tension[link] *= share;
}

void Builder::break_links_at(double time, const std::vector<Index>& links) {
  Change& change = change_at(time);
  change.links.insert(change.links.end(), links.begin(), links.end());
}

void Builder::release_at(Index mass, const std::optional<double>& time) {
  if (!time || !model.masses.pinned(mass)) return;
  model.masses.release_at.resize(model.masses.size(), infinity);
  model.masses.release_at[mass] = *time;
  change_at(*time).pins.push_back(mass);
}

Index Builder::add_mass(std::string name, const Vec3& position, const Vec3& velocity, double mass,
                        bool pinned, double radius) {
  const auto index = static_cast<Index>(model.masses.size());
  model.masses.name.push_back(std::move(name));
  model.masses.mass.push_back(mass);
  model.masses.inverse_mass.push_back(pinned ? 0.0 : 1.0 / mass);
  model.masses.radius.push_back(radius);
  if (!model.masses.release_at.empty()) model.masses.release_at.push_back(infinity);
  body_of_mass.push_back(body_);
  start.position.push_back(position);
  start.velocity.push_back(pinned ? Vec3::Zero() : velocity);
  return index;
}

Index Builder::add_link(Index a, Index b, double length, const LinkProperties& properties,
                        LinkFamily family) {
  const auto index = static_cast<Index>(model.links.size());
  model.links.a.push_back(a);
  model.links.b.push_back(b);
  model.links.family.push_back(family);
  model.links.length.push_back(length);
  model.links.stiffness.push_back(properties.stiffness.value_or(infinity));
  model.links.damping.push_back(properties.damping);
  model.links.break_stretch.push_back(properties.break_stretch.value_or(infinity));
  model.links.break_tension.push_back(properties.break_tension.value_or(infinity));
  if (properties.scatter > 0.0)
    weaken(index, 1.0 + properties.scatter * spread(properties.scatter_seed, index));
  if (properties.break_at) break_links_at(*properties.break_at, {index});
  if (properties.break_stretch || properties.break_tension || properties.break_at)
    model.breakable_links.push_back(index);
  add_free_range(index, properties);
  start.tension.push_back(0.0);
  start.broken_at.push_back(infinity);
  return index;
}

// A link that isn't there for both pulling and pushing is a limit on its reach: to be met and left, as others
// are. In lengths of the link, k (d − l)²/2 is that of a compliance of 1/(k l²).
void Builder::add_free_range(Index link, const LinkProperties& properties) {
  Links& links = model.links;
  const double length = links.length[link];
  const bool one_sided = properties.acts != LinkAction::both;
  if (one_sided) links.free_range.resize(link, FreeRange{});  // those before it: none
  if (links.free_range.empty() && !one_sided) return;
  links.free_range.push_back({});
  if (!one_sided) return;
  Limit limit{LimitKind::reach, 2, {links.a[link], links.b[link]}, Vec3::UnitX(), 0.0, infinity};
  if (properties.acts != LinkAction::pull) limit.min = 1.0;
  if (properties.acts == LinkAction::pull) limit.max = 1.0;
  if (properties.acts == LinkAction::between) limit.max = properties.longest.value_or(1.0);
  if (properties.stiffness) limit.compliance = 1.0 / (*properties.stiffness * length * length);
  limit.length = length;
  limit.link = link;
  links.free_range.back() = {limit.min * length, limit.max * length};
  if (!model.masses.pinned(links.a[link]) || !model.masses.pinned(links.b[link]))
    model.limits.push_back(limit);
}

void Builder::add_bend(Bend bend, bool from_start) {
  if (bend.stiffness == 0.0) return;
  if (from_start) bend.rest = bend_gradients(bend, start.position).angle;
  model.bends.push_back(bend);
}

const Builder::Entry& Builder::entry_of(Index link) const {
  const auto after = std::ranges::upper_bound(entries, link, {}, &Entry::first_link);
  return *std::prev(after);
}

void Builder::add_bone(const Bone& bone) {
  model.bones.push_back(bone);
  body_of_bone.push_back(body_);
}

void Builder::drive(Index mass, const MotionSpec& motion) {
  if (motion.sinusoid) {
    const SinusoidSpec& spec = *motion.sinusoid;
    drive(mass, Sinusoid{start.position.at(mass), spec.amplitude, spec.angular_frequency, spec.phase});
  } else if (!motion.path.empty()) {
    drive(mass, make_path(motion.path));
  } else if (!motion.with.empty()) {
    drive(mass, Carried{start.position.at(mass), solid_motions.at(motion.with)});
  }
}

void Builder::drive(Index mass, Motion motion) {
  start.position.set(mass, position_at(motion, 0.0));
  start.velocity.set(mass, velocity_at(motion, 0.0));
  model.driven_pins.push_back({mass, std::move(motion)});
}

}  // namespace taut
