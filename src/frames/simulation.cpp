#include "frames/simulation.h"

#include <fmt/format.h>

#include "base/failure.h"
#include "frames/failure_advice.h"

namespace taut {
namespace {

Run run_of(const Scene& scene, const Execution& execution) {
  try {
    return {scene.model, scene.start, scene.settings, {}, execution};
  } catch (const BadRequest& refusal) {
    throw BadRequest(fmt::format("{}: {}", scene.name, refusal.what()));
  }
}

}  // namespace

Simulation::Simulation(const Scene& scene, const Execution& execution)
    : scene_(scene), run_(run_of(scene, execution)), trails_(scene) {}

std::optional<State> Simulation::at(double time, const StopTest& stop) {
  while (trails_.next() <= time) {
    const std::optional<State> point = state_at(trails_.next(), stop);
    if (!point) return std::nullopt;
    trails_.add(*point);
  }
  return state_at(time, stop);
}

std::optional<State> Simulation::state_at(double time, const StopTest& stop) {
  std::optional<State> state = run_.at(time, stop);
  if (!run_.ended()) return state;
  std::string advice;
  try {
    advice = failure_advice(scene_, run_.state(), stop);
  } catch (const Interrupted&) {
    // The failure is told in any case.
  }
  throw RunFailure(run_.failure() + advice);
}

}  // namespace taut
