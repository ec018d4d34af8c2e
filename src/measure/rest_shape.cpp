#include "measure/rest_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/failure.h"
#include "measure/exact.h"
#include "methods/registry.h"
#include "model/measures.h"
#include "motion/run.h"

namespace taut {
namespace {

// A chain that the formulas know: alone in its scene, along the arrays, every link alike and every inner mass
// alike, and all of it in a vertical plane through its pins.
bool is_plain_chain(const Model& model) {
  if (model.chains.size() != 1 || !model.loads.empty() || !model.contacts.empty() || !model.limits.empty())
    return false;
  const Chain& chain = model.chains.front();
  const Links& links = model.links;
  if (chain.link_count != links.size() || chain.link_count + 1 != model.masses.size()) return false;
  if (model.gravity.isZero(0.0)) return false;
  if (!model.masses.pinned(0)) return false;
  for (std::size_t i = 1; i + 1 < model.masses.size(); ++i)
    if (model.masses.pinned(i) || model.masses.mass[i] != model.masses.mass[1]) return false;
  for (std::size_t i = 0; i < links.size(); ++i)
    if (links.length[i] != links.length[0] || links.stiffness[i] != links.stiffness[0]) return false;
  return true;
}

RestShape shape_of(const Model& model, const State& start, const std::vector<Vec3>& positions,
                   const std::vector<double>& tensions) {
  RestShape shape;
  shape.state = start;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    shape.state.position.set(i, positions[i]);
    shape.state.velocity.set(i, Vec3::Zero());
  }
  shape.state.tension = tensions;
  shape.state.time = last_change(model);
  shape.at_rest = true;
  shape.how = "balance of forces";
  return shape;
}

// Straight down from its pin: every link carries what hangs below it.
RestShape hang_down(const Model& model, const State& start) {
  const Vec3 up = up_direction(model);
  std::vector<Vec3> positions{start.position.at(0)};
  std::vector<double> tensions;
  double below = 0.0;
  for (std::size_t i = 1; i < model.masses.size(); ++i) below += model.masses.mass[i];
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const double tension = below * model.gravity.norm();
    tensions.push_back(tension);
    positions.push_back(positions.back() -
                        (model.links.length[i] + model.links.compliance(i) * tension) * up);
    below -= model.masses.mass[i + 1];
  }
  return shape_of(model, start, positions, tensions);
}

// Between two pins: exact.h knows the curve in the x-y plane; here it lies in the vertical plane of the pins.
std::optional<RestShape> hang_between(const Model& model, const State& start) {
  const std::size_t last = model.masses.size() - 1;
  const Vec3 from = start.position.at(0), to = start.position.at(last);
  const Vec3 up = up_direction(model);
  const double rise = up.dot(to - from);
  const Vec3 across = to - from - rise * up;
  const double span = across.norm();
  const double length = model.links.length[0], compliance = model.links.compliance(0);
  const auto count = static_cast<int>(model.links.size());
  // Pins above each other have no plane, and a rigid chain that is too short no curve.
  if (span <= 1e-12 * length * count || (compliance == 0.0 && (to - from).norm() >= length * count) ||
      last < 2)
    return std::nullopt;
  const double weight = model.masses.mass[1] * model.gravity.norm();
  const HangingChain chain =
      hanging_chain_at_rest(Vec3::Zero(), Vec3(span, rise, 0.0), count, length, compliance, weight);
  std::vector<Vec3> positions;
  for (const Vec3& place : chain.positions)
    positions.push_back(from + across * (place.x() / span) + place.y() * up);
  return shape_of(model, start, positions, chain.tensions);
}

}  // namespace

double last_change(const Model& model) {
  double last = 0.0;
  for (const DrivenPin& pin : model.driven_pins) last = std::max(last, last_change(pin.motion));
  for (const Load& load : model.loads) last = std::max(last, load.gone < infinity ? load.gone : load.to);
  return last;
}

RestShape settle(const Model& model, const State& start, const Settings& settings, const Settling& settling,
                 const std::function<bool()>& stop) {
  const double from = last_change(model);
  if (from == infinity) throw BadRequest("a scene with a pin that swings for ever never comes to rest");
  Model calmed = model;
  calmed.drag = std::max(model.drag, settling.least_drag);
  Run run(calmed, start, settings);
  const double rate = run.settings().steps_per_second();
  RestShape shape;
  const double allowed = settling.most_movement * scene_size(model, start);
  const auto window = static_cast<std::int64_t>(std::max(1.0, std::round(settling.window * rate)));
  const auto told = [&] { return stop && stop(); };
  while (!shape.at_rest && run.state().time < from + settling.most_time && !told()) {
    const State before = run.state();
    // A window of steps with thousands of passes takes long.
    for (const std::int64_t end = run.steps() + window; run.steps() < end && !told();)
      if (!run.step()) throw RunFailure(run.failure());
    shape.largest_movement = position_error(run.state(), before);
    shape.at_rest = before.time >= from && shape.largest_movement <= allowed;
  }
  shape.state = run.state();
  shape.how = fmt::format("{} at {:.6g} steps/s, drag {:.4g}/s", run.settings().method, rate, calmed.drag);
  return shape;
}

RestShape exact_rest_shape(const Model& model, const State& start, const Settling& settling,
                           const std::function<bool()>& stop) {
  const double late = last_change(model);
  if (is_plain_chain(model) && late < infinity) {
    State placed = start;
    place_pins(model, late, placed.position, placed.velocity);
    if (!model.masses.pinned(model.masses.size() - 1)) return hang_down(model, placed);
    if (auto between = hang_between(model, placed)) return *between;
  }
  return settle(model, start, {"newton", {}}, settling, stop);
}

}  // namespace taut
