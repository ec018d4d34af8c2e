#include "geometry/chain_rings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/run_frame.h"
#include "geometry/view_matrices.h"

namespace taut {
namespace {

constexpr double pitch_to_wire = 6.4;  // a ring's inner length over its wire's radius, where a look has none
constexpr double least_pitch = 4.0;    // the same, at least: less leaves no room for the next ring
constexpr double bend_to_wire = 2.35;  // so that the next ring's wire has room inside
// Turned like this about the chain, a hanging chain seen from the front shows that its rings are rings.
constexpr double first_turn = 0.38;  // rad

// Where rings bear on each other, and the link that lies in the middle between.
struct Bearings {
  std::vector<Vec3> places;
  std::vector<Index> links;
  double pitch = 0.0;  // m, at rest
};

Bearings ring_each_link(const Model& model, const State& state, const LinkRun& run) {
  Bearings bearings;
  for (const Index mass : run.masses) bearings.places.push_back(state.position.at(mass));
  bearings.links = run.links;
  for (const Index link : run.links) bearings.pitch += model.links.length[link];
  bearings.pitch /= static_cast<double>(run.links.size());
  return bearings;
}

Bearings ring_each_pitch(const Model& model, const State& state, const LinkRun& run, double pitch) {
  std::vector<double> ends{0.0};  // m at rest, of the links
  for (const Index link : run.links) ends.push_back(ends.back() + model.links.length[link]);
  const double whole = ends.back();
  const auto count = static_cast<std::size_t>(std::max(1.0, std::round(whole / pitch)));
  const auto link_at = [&](double along) {
    const auto above = std::upper_bound(ends.begin() + 1, ends.end() - 1, along);
    return static_cast<std::size_t>(above - ends.begin()) - 1;
  };
  Bearings bearings;
  bearings.pitch = whole / static_cast<double>(count);
  for (std::size_t i = 0; i <= count; ++i) {
    const double along = static_cast<double>(i) * bearings.pitch;
    const std::size_t link = link_at(along);
    const double share = (along - ends[link]) / (ends[link + 1] - ends[link]);
    const Vec3 from = state.position.at(run.masses[link]), to = state.position.at(run.masses[link + 1]);
    bearings.places.push_back(from + std::min(share, 1.0) * (to - from));
    if (i < count) bearings.links.push_back(run.links[link_at(along + 0.5 * bearings.pitch)]);
  }
  return bearings;
}

}  // namespace

std::vector<RingRecord> chain_rings(const Drawn& drawn, const std::vector<LinkRun>& runs) {
  const auto& [model, state, look, appearance, radii, quantity, scale] = drawn;
  std::vector<RingRecord> rings;
  for (const LinkRun& run : runs) {
    const Bearings bearings = look.chain_pitch > 0.0 ? ring_each_pitch(model, state, run, look.chain_pitch)
                                                     : ring_each_link(model, state, run);
    const double wanted = look.link_radius > 0.0 ? look.link_radius : bearings.pitch / pitch_to_wire;
    const double wire = std::min(wanted, bearings.pitch / least_pitch);
    std::vector<Vec3> directions;
    for (std::size_t i = 0; i + 1 < bearings.places.size(); ++i) {
      const Vec3 along = bearings.places[i + 1] - bearings.places[i];
      directions.push_back(along.norm() > 0.0 ? Vec3(along.normalized()) : Vec3(-Vec3::UnitY()));
    }
    const std::vector<Vec3> normals = carried_normals(directions);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const double turn = first_turn + (i % 2 == 0 ? 0.0 : 0.5 * std::numbers::pi);
      const Vec3 side = std::cos(turn) * normals[i] + std::sin(turn) * directions[i].cross(normals[i]);
      const Index link = bearings.links[i];
      const Colour colour = link_colour(drawn, link);
      rings.push_back({to_glm(bearings.places[i]), static_cast<float>(wire), to_glm(bearings.places[i + 1]),
                       static_cast<float>(bend_to_wire * wire), to_glm(side), opaque(colour)});
    }
  }
  return rings;
}

}  // namespace taut
