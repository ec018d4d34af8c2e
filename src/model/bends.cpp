#include "model/bends.h"

#include <algorithm>
#include <numbers>

#include "model/model.h"
#include "model/state.h"

namespace taut {

bool is_whole(const Bend& bend, const State& state) {
  return std::ranges::none_of(bend.links, [&](Index link) { return link != no_link && state.broken(link); });
}

// The turn away from straight is π less the angle between the two links.
BendAngle bend_gradients(const Bend& bend, const Vectors& position) {
  const LimitAngle between = corner_gradients(bend.masses, position);
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
    const double turn = std::numbers::pi - corner_angle(bend.masses, state.position) - bend.rest;
    sum += 0.5 * bend.stiffness * turn * turn;
  }
  return sum;
}

}  // namespace taut
