#include "frames/simulation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/failure.h"
#include "measure/stability.h"
#include "motion/advance.h"
#include "methods/registry.h"
#include "frames/holding_rate.h"

namespace taut {
namespace {

constexpr std::int64_t steps_between_looks = 256;

const Method& capable_method(const Scene& scene) {
  const Method* method = find_method(scene.settings.method);
  if (method == nullptr) throw BadRequest(fmt::format("there is no method \"{}\"", scene.settings.method));
  const std::vector<std::string> problems = capability_problems(scene.model, *method);
  if (!problems.empty()) throw BadRequest(fmt::format("{}: {}", scene.name, fmt::join(problems, "\n")));
  return *method;
}

}  // namespace

Simulation::Simulation(const Scene& scene) : Simulation(scene, capable_method(scene)) {}

Simulation::Simulation(const Scene& scene, const Method& method)
    : scene_(scene),
      method_(method),
      steps_per_second_(scene.settings.steps_per_second()),
      stepper_(method.make(scene.model, scene.settings)),
      state_(scene.start),
      ledger_(scene.model, scene.start),
      energy_scale_(energy_scale(scene.model, scene.start)) {
  stepper_->links_changed(state_);
}

std::optional<State> Simulation::at(double time, const StopTest& stop) {
  while (step_time(steps_) < time) {
    if (stop && stop()) return std::nullopt;
    // Copied only where it is needed: a copy of every step would cost as much as a cheap step itself.
    if (step_time(steps_ + 1) > time) before_ = state_;
    step();
  }
  look_at_energy();
  if (state_.time == time) return state_;
  return interpolate(*before_, state_, time, method_.can.between_steps);
}

void Simulation::step() {
  const double h = 1.0 / steps_per_second_;
  const StepReport report = advance(*stepper_, scene_.model, state_, h);
  if (report.status != StepStatus::done)
    throw RunFailure(failure_sentence(scene_.model, state_, report, scene_.settings.method, h) +
                     holding_rate_hint(scene_, state_.time));
  report_.add(report);
  ++steps_;
  state_.time = step_time(steps_);  // the sum of many h would drift away from it
  ledger_.record(state_);
  if (steps_ % steps_between_looks == 0) look_at_energy();
}

// A run that has gone off tells so long before its numbers overflow. Only energy of motion counts: links that
// a few passes leave stretched hold a lot of elastic energy while nothing is amiss.
void Simulation::look_at_energy() const {
  double fastest_pin = 0.0;  // m²/s²
  for (const DrivenPin& pin : scene_.model.driven_pins)
    fastest_pin = std::max(fastest_pin, state_.velocity.at(pin.mass).squaredNorm());
  const double scale = energy_scale_ + free_mass(scene_.model) * fastest_pin + std::max(0.0, ledger_.loads());
  const double times = energy(scene_.model, state_).kinetic / scale;
  if (!(scale > 0.0) || !(times > divergence)) return;
  throw RunFailure(fmt::format(
      "the run with method {} at {} steps/s diverges: at t = {:.6g} s its masses move with {:.3g} times the "
      "scene's energy; try more steps_per_second, or another method{}",
      scene_.settings.method, steps_per_second_, state_.time, times, holding_rate_hint(scene_, state_.time)));
}

State Simulation::reported(const State& state) const {
  return reported_state(scene_.model, method_.can, state);
}

RunMeasures Simulation::measures(const State& state) const {
  return measure_run(scene_.model, scene_.start, reported(state), ledger_, report_);
}

}  // namespace taut
