#include "model/state.h"

#include <algorithm>
#include <cmath>

#include "base/hash.h"
#include "base/vector_operations.h"

namespace taut {
namespace {

bool all_finite(const std::vector<double>& values) {
  // Any NaN or infinity turns the sum of v·0 into NaN; one pass without branches.
  return (0.0 * all_of(values)).sum() == 0.0;
}

}  // namespace

bool all_finite(const Vectors& vectors) {
  return all_finite(vectors.x) && all_finite(vectors.y) && all_finite(vectors.z);
}

std::uint64_t state_hash(const State& state) {
  Hash hash;
  hash.add(std::span(&state.time, 1));
  for (const Vectors* vectors : {&state.position, &state.velocity})
    for (const auto* axis : {&vectors->x, &vectors->y, &vectors->z}) hash.add(std::span<const double>(*axis));
  hash.add(std::span<const double>(state.broken_at));
  for (const std::vector<ContactSlip>* slips : {&state.static_friction.solids, &state.static_friction.bodies})
    for (const ContactSlip& contact : *slips)
      hash.add(std::as_bytes(std::span(&contact.a, 1)))
          .add(std::as_bytes(std::span(&contact.b, 1)))
          .add(std::span(contact.slip.data(), 3));
  for (const Vec3& slip : state.static_friction.joints) hash.add(std::span(slip.data(), 3));
  return hash.value();
}

bool all_finite(const State& state) {
  return std::isfinite(state.time) && all_finite(state.position) && all_finite(state.velocity);
}

double link_distance(const Model& model, const Vectors& position, std::size_t link) {
  return (position.at(model.links.a[link]) - position.at(model.links.b[link])).norm();
}

void place_pins(const Model& model, double time, Vectors& position, Vectors& velocity) {
  for (const DrivenPin& pin : model.driven_pins) {
    position.set(pin.mass, position_at(pin.motion, time));
    velocity.set(pin.mass, velocity_at(pin.motion, time));
  }
}

State interpolate(const State& before, const State& after, double time, Interpolation kind) {
  const double span = after.time - before.time;
  if (!(span > 0.0) || time >= after.time) return after;
  if (time <= before.time) return before;
  const double u = (time - before.time) / span;
  const bool hermite = kind == Interpolation::hermite;
  // Weights of the end position and of both velocities in the position, then in the velocity.
  const double end = hermite ? u * u * (3.0 - 2.0 * u) : u;
  const double start_velocity = hermite ? u * (1.0 - u) * (1.0 - u) * span : 0.0;
  const double end_velocity = hermite ? -u * u * (1.0 - u) * span : 0.0;
  const double slope = (hermite ? 6.0 * u * (1.0 - u) : 1.0) / span;
  const double start_slope = hermite ? (1.0 - u) * (1.0 - 3.0 * u) : 0.0;
  const double end_slope = hermite ? u * (3.0 * u - 2.0) : 0.0;

  State between = after;
  between.time = time;
  for (std::size_t i = 0; i < after.position.size(); ++i) {
    const Vec3 x0 = before.position.at(i), x1 = after.position.at(i);
    const Vec3 v0 = before.velocity.at(i), v1 = after.velocity.at(i);
    between.position.set(i, x0 + end * (x1 - x0) + start_velocity * v0 + end_velocity * v1);
    between.velocity.set(i, slope * (x1 - x0) + start_slope * v0 + end_slope * v1);
  }
  for (double& broken_at : between.broken_at)
    if (broken_at > time) broken_at = infinity;
  for (std::size_t link = 0; link < between.tension.size(); ++link) {
    if (after.broken(link))
      between.tension[link] = between.broken(link) ? 0.0 : before.tension[link];
    else if (before.tension[link] != 0.0)
      between.tension[link] = std::lerp(before.tension[link], after.tension[link], u);
  }
  return between;
}

}  // namespace taut
