#include "measure/time_scales.h"

#include <algorithm>
#include <cmath>

#include "methods/frequency.h"
#include "model/measures.h"
#include "model/ways_from_pins.h"

namespace taut {
namespace {

constexpr int looks_at_pins = 256;  // over the run
constexpr double swing_factor = 3.0;

double quotient(double a, double b) {
  return b > 0.0 ? a / b : infinity;
}

double mean_length(const Model& model) {
  const std::size_t count = model.links.size();
  return count > 0 ? total_link_length(model) / static_cast<double>(count) : 0.0;
}

double fastest_pin(const Model& model, double duration) {
  double fastest = 0.0;
  for (const DrivenPin& pin : model.driven_pins)
    for (int i = 0; i <= looks_at_pins; ++i)
      fastest = std::max(fastest, velocity_at(pin.motion, duration * i / looks_at_pins).norm());
  return fastest;
}

// Of two masses that a link joins, against each other.
double fastest_neighbour(const Model& model, const State& start) {
  double fastest = 0.0;
  for (std::size_t i = 0; i < model.links.size(); ++i)
    fastest =
        std::max(fastest, (start.velocity.at(model.links.a[i]) - start.velocity.at(model.links.b[i])).norm());
  return fastest;
}

double tension_at_pins(const Model& model) {
  double force = free_mass(model) * model.gravity.norm();
  for (const Load& load : model.loads) force += static_cast<double>(load.masses.size()) * load.force.norm();
  std::size_t carrying = 0;
  for (std::size_t i = 0; i < model.links.size(); ++i)
    carrying += model.masses.pinned(model.links.a[i]) != model.masses.pinned(model.links.b[i]) ? 1 : 0;
  return carrying > 0 ? swing_factor * force / static_cast<double>(carrying) : 0.0;
}

double slowest_sideways(const Model& model, const State& start) {
  const double held = tension_at_pins(model);
  double least = infinity;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (!model.links.rigid(i)) continue;
    const Index a = model.links.a[i], b = model.links.b[i];
    const double weight = std::max(model.masses.inverse_mass[a], model.masses.inverse_mass[b]);
    const double pair = model.masses.inverse_mass[a] + model.masses.inverse_mass[b];
    if (pair == 0.0) continue;
    const double length = model.links.length[i];
    // What the start's own turning pulls with: (m_a m_b/(m_a + m_b)) v²/l.
    const double turning = (start.velocity.at(a) - start.velocity.at(b)).squaredNorm() / (pair * length);
    least = std::min(least, std::sqrt(quotient(length, weight * std::max(held, turning))));
  }
  return least;
}

double impact_time(const Model& model, const State& start, double link) {
  if (model.contacts.empty()) return infinity;
  double radius = infinity;
  for (const ContactPoint& point : model.contacts)
    if (point.radius > 0.0) radius = std::min(radius, point.radius);
  if (radius == infinity) radius = link > 0.0 ? link : scene_size(model, start);
  const double speed =
      std::sqrt(2.0 * model.gravity.norm() * scene_size(model, start)) + fastest_speed(start);
  return quotient(radius, speed);
}

}  // namespace

TimeScales time_scales(const Model& model, const State& start, double duration) {
  const double link = mean_length(model), size = link > 0.0 ? link : scene_size(model, start);
  TimeScales scales;
  scales.fall = std::sqrt(quotient(size, model.gravity.norm()));
  scales.sideways = slowest_sideways(model, start);
  scales.spring = quotient(2.0, spring_frequency_bound(model, start));
  scales.motion = quotient(size, std::max(fastest_pin(model, duration), fastest_neighbour(model, start)));
  scales.impact = impact_time(model, start, link);
  return scales;
}

double longest_reach(const Model& model) {
  WaysFromPins ways(model, [](Index) { return true; });
  ways.reach_parts_without_pins();
  return ways.longest();
}

}  // namespace taut
