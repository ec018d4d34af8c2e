#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "builder.h"
#include "chain_ways.h"

namespace taut {
namespace {

// Angle between neighbouring chords of a circular arc of n chords of length l whose ends are `distance`
// apart: sin(nθ/2)/sin(θ/2) = distance/l, which falls from n at θ = 0 to 0 at θ = 2π/n. By bisection, to the
// last bit.
double arc_angle(int n, double distance_over_chord) {
  double low = 0.0, high = 2.0 * std::numbers::pi / n;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    const double ratio = middle == 0.0 ? n : std::sin(0.5 * n * middle) / std::sin(0.5 * middle);
    (ratio > distance_over_chord ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// The unit vector across `along` that points most along gravity; any across when gravity has no such part.
Vec3 sag_direction(const Vec3& along, const Vec3& gravity) {
  for (const Vec3& wish : {gravity, Vec3(0.0, -1.0, 0.0), Vec3(1.0, 0.0, 0.0)}) {
    const Vec3 across = wish - along * along.dot(wish);
    if (across.norm() > 1e-9 * (1.0 + wish.norm())) return across.normalized();
  }
  return Vec3::UnitZ();
}

// The straight row from `from` to `to`, or the arc of equal chords between them when the chain is longer than
// that.
std::vector<Vec3> straight_chain(const ChainSpec& spec, const Vec3& gravity) {
  const Vec3 span = spec.to - spec.from;
  const double distance = span.norm();
  std::vector<Vec3> points(static_cast<std::size_t>(spec.links) + 1, spec.from);
  if (spec.length <= distance * (1.0 + 1e-12)) {
    for (std::size_t i = 0; i < points.size(); ++i) points[i] += span * (static_cast<double>(i) / spec.links);
    return points;
  }
  const double chord = spec.length / spec.links;
  const Vec3 along = distance > 0.0 ? Vec3(span / distance) : Vec3::UnitX();
  const Vec3 down = sag_direction(along, gravity);
  const double turn = arc_angle(spec.links, distance / chord);
  for (int i = 0; i < spec.links; ++i) {
    const double heading = (0.5 * (spec.links - 1) - i) * turn;
    const auto at = static_cast<std::size_t>(i);
    points[at + 1] = points[at] + chord * (std::cos(heading) * along + std::sin(heading) * down);
  }
  points.back() = spec.to;
  return points;
}

// Where masses are, and how long each link is (m).
struct ChainLayout {
  std::vector<Vec3> points;
  double link = 0.0;
};

ChainLayout layout_of(const ChainSpec& spec, const Description& description) {
  if (spec.straight()) {
    const double length = spec.length > 0.0 ? spec.length : (spec.to - spec.from).norm();
    return {straight_chain(spec, description.gravity), length / spec.links};
  }
  ChainLayout layout{*laid_out_chain(spec, description), 0.0};
  layout.link = (layout.points[1] - layout.points[0]).norm();
  return layout;
}

}  // namespace

Counts count(const ChainSpec& spec) {
  return {spec.links + 1.0, static_cast<double>(spec.links), 0.0, 0.0};
}

void add_chain(Builder& builder, const ChainSpec& spec, const Description& description) {
  const auto pinned = [&](std::string_view end) {
    return std::find(spec.pinned.begin(), spec.pinned.end(), end) != spec.pinned.end();
  };
  builder.begin_body(spec.collides);
  const auto [points, link_length] = layout_of(spec, description);
  const double share = spec.mass / static_cast<double>(points.size());
  Chain chain{spec.name, static_cast<Index>(builder.model.masses.size()),
              static_cast<Index>(builder.model.links.size()), static_cast<Index>(spec.links)};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool first = i == 0, last = i + 1 == points.size();
    const double mass = last && spec.last_mass > 0.0 ? spec.last_mass : share;
    const bool pin = (first && pinned("first")) || (last && pinned("last"));
    const Index index = builder.add_mass(spec.name + "." + std::to_string(i), points[i], Vec3::Zero(), mass,
                                         pin, spec.radius);
    if (pin) builder.drive(index, first ? spec.first_motion : spec.last_motion);
    builder.release_at(index, first ? spec.first_release : last ? spec.last_release : std::nullopt);
    if (!first) builder.add_link(index - 1, index, link_length, spec.properties);
  }
  if (spec.bending)
    for (Index i = 1; i < chain.link_count; ++i) {
      const Index mass = chain.first_mass + i, link = chain.first_link + i;
      builder.add_bend(
          {{mass - 1, mass, mass + 1}, spec.bending->stiffness, 0.0, {link - 1, link, no_link, no_link}},
          spec.bending->from_start);
    }
  builder.model.chains.push_back(std::move(chain));
}

}  // namespace taut
