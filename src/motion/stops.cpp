#include "stops.h"

#include <algorithm>

#include "model/limit_motion.h"

namespace taut {
namespace {

constexpr double touching = 1e-9;  // rad

// Calls visit(place, how far from touching it is) for both ends of every hard limit.
template <class Visit>
void visit_stops(const Model& model, const State& state, const Visit& visit) {
  for (std::size_t i = 0; i < model.limits.size(); ++i) {
    if (model.limits[i].compliance > 0.0 || let_go(model.limits[i], state)) continue;
    const double angle = limit_angle(model.limits[i], state.position);
    for (const double sign : {1.0, -1.0})
      if (has_stop(model.limits[i], sign))
        visit(2 * i + (sign > 0.0 ? 0 : 1), -touching - excess_at(model.limits[i], angle, sign));
  }
}

}  // namespace

std::vector<bool> touched_stops(const Model& model, const State& state) {
  std::vector<bool> touched(2 * model.limits.size(), false);
  visit_stops(model, state, [&](std::size_t place, double way) { touched[place] = way < 0.0; });
  return touched;
}

bool meets_more(const std::vector<bool>& touched, const std::vector<bool>& before) {
  for (std::size_t i = 0; i < touched.size(); ++i)
    if (touched[i] && !before[i]) return true;
  return false;
}

double time_to_stop(const Model& model, const State& state, const std::vector<bool>& touched) {
  double first = infinity;
  visit_stops(model, state, [&](std::size_t place, double way) {
    if (touched[place]) return;
    const double sign = place % 2 == 0 ? 1.0 : -1.0;
    const double rate = sign * limit_motion(model.limits[place / 2], state.position, state.velocity).rate;
    if (rate > 0.0) first = std::min(first, std::max(way, 0.0) / rate);
  });
  return first;
}

}  // namespace taut
