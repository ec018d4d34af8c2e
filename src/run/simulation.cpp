#include "run/simulation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/failure.h"
#include "methods/advance.h"
#include "methods/registry.h"

namespace taut {
namespace {

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
      ledger_(scene.model, scene.start) {
  stepper_->links_changed(state_);
}

std::optional<State> Simulation::at(double time, const StopTest& stop) {
  while (step_time(steps_) < time) {
    if (stop && stop()) return std::nullopt;
    // Copied only where it is needed: a copy of every step would cost as much as a cheap step itself.
    if (step_time(steps_ + 1) > time) before_ = state_;
    step();
  }
  if (state_.time == time) return state_;
  return interpolate(*before_, state_, time, method_.can.between_steps);
}

void Simulation::step() {
  const double h = 1.0 / steps_per_second_;
  const StepReport report = advance(*stepper_, scene_.model, state_, h);
  if (report.status != StepStatus::done)
    throw RunFailure(failure_sentence(scene_.model, state_, report, scene_.settings.method, h));
  report_.add(report);
  ++steps_;
  state_.time = step_time(steps_);  // the sum of many h would drift away from it
  ledger_.record(state_);
}

State Simulation::reported(const State& state) const {
  return reported_state(scene_.model, method_.can, state);
}

RunMeasures Simulation::measures(const State& state) const {
  return measure_run(scene_.model, scene_.start, reported(state), ledger_, report_);
}

}  // namespace taut
