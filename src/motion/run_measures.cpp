#include "motion/run_measures.h"

#include <fmt/format.h>

#include <algorithm>

#include "methods/breaking.h"
#include "methods/projected_velocities.h"
#include "model/tangles.h"

namespace taut {
namespace {

// What it takes to solve a net at once grows faster than its links: for a million masses it is gigabytes.
constexpr std::size_t most_links_projected = 250'000;

}  // namespace

State reported_state(const Model& model, const Capabilities& can, const State& state) {
  State reported = state;
  if (!can.half_kicked) return reported;
  const std::size_t links = model.links.size();
  if (links > most_links_projected && links > model.masses.size())
    answer_kick(model, state, reported.velocity);
  else
    reported.velocity = projected_velocities(model, state);
  return reported;
}

RunMeasures measure_run(const Model& model, const EnergyBase& base, const State& end, const Work& work,
                        const RunReport& report) {
  RunMeasures measures;
  measures.time = end.time;
  measures.strain = link_strain(model, end);
  for (std::size_t link = 0; link < model.links.size(); ++link)
    if (!end.broken(link)) measures.largest_tension = std::max(measures.largest_tension, end.tension[link]);
  measures.energy_at_start = base.at_start;
  measures.energy = energy(model, end);
  measures.pin_work = work.pins;
  measures.load_work = work.loads;
  measures.contact_work = work.contacts;
  measures.broken_energy = work.broken;
  const double gain = measures.energy.total() - measures.energy_at_start.total();
  measures.energy_error = base.scale > 0.0 ? (gain - work.expected_gain()) / base.scale : 0.0;
  measures.linear_momentum = linear_momentum(model, end);
  measures.angular_momentum = angular_momentum(model, end);
  measures.sag = sag(model, end);
  measures.fastest_speed = fastest_speed(end);
  measures.limit_excess = largest_limit_excess(model, end);
  measures.penetration = deepest_penetration(model, end);
  measures.tangled = tangled_places(model, end);
  measures.broken_links = broken_links(end);
  measures.report = report;
  return measures;
}

std::string ruin_sentence(const Model& model, const RunMeasures& measures) {
  constexpr double most = 0.1;
  if (measures.report.halved_steps == 0 || model.wind || !(measures.energy_error > most)) return {};
  return fmt::format(
      "the run is ruined: its energy is {:.3g} of the scale above what it can have come by, and {}",
      measures.energy_error, halving_sentence(model, measures.report));
}

}  // namespace taut
