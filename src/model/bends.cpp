#include "model/bends.h"

#include <algorithm>
#include <numbers>

#include "model/model.h"
#include "model/state.h"

namespace taut {

bool is_whole(const Bend& bend, const State& state) {
  return std::ranges::none_of(bend.links, [&](Index link) { return link != no_link && state.broken(link); });
}

Limit as_limit(const Bend& bend) {
  Limit limit{LimitKind::angle, 3, {bend.masses[0], bend.masses[1], bend.masses[2]}, Vec3::UnitX()};
  limit.min = limit.max = std::numbers::pi - bend.rest;
  limit.compliance = 1.0 / bend.stiffness;
  return limit;
}

// The turn away from straight is π less the angle between the two links.
BendAngle bend_gradients(const Bend& bend, const Vectors& position) {
  const LimitAngle between = limit_gradients(as_limit(bend), position);
  return {std::numbers::pi - between.angle,
          {-between.gradient[0], -between.gradient[1], -between.gradient[2]}};
}

std::vector<Bend> whole_bends(const Model& model, const State& state) {
  std::vector<Bend> bends;
  std::ranges::copy_if(model.bends, std::back_inserter(bends),
                       [&](const Bend& bend) { return is_whole(bend, state); });
  return bends;
}

double bending_energy(const Model& model, const State& state) {
  double sum = 0.0;
  for (const Bend& bend : model.bends) {
    if (!is_whole(bend, state)) continue;
    const double turn = std::numbers::pi - limit_angle(as_limit(bend), state.position) - bend.rest;
    sum += 0.5 * bend.stiffness * turn * turn;
  }
  return sum;
}

}  // namespace taut
