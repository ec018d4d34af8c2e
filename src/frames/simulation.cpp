#include "frames/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/bytes.h"
#include "base/failure.h"
#include "frames/failure_advice.h"
#include "methods/method.h"

namespace taut {
namespace {

Run run_of(const Scene& scene, const Execution& execution) {
  try {
    return {scene.model, scene.start, scene.settings, {}, execution};
  } catch (const BadRequest& refusal) {
    throw BadRequest(fmt::format("{}: {}", scene.name, refusal.what()));
  }
}

// What save_before() gave: the run, and the trails.
std::pair<std::string, std::string> parts_of(std::string_view saved) {
  std::pair<std::string, std::string> parts;
  ByteReader reader(saved);
  reader.take(parts.first);
  reader.take(parts.second);
  return parts;
}

std::string as_bytes(const RunState& run, const TrailRecorder& trails) {
  const std::string moved = to_bytes(run), kept = trails.save();
  std::string bytes;
  bytes.reserve(size_in_bytes(moved) + size_in_bytes(kept));
  append_bytes(moved, bytes);
  append_bytes(kept, bytes);
  return bytes;
}

}  // namespace

Simulation::Simulation(const Scene& scene, const Execution& execution)
    : scene_(scene), run_(run_of(scene, execution)), trails_(scene) {}

Simulation::Simulation(const Scene& scene, std::string_view saved, const Execution& execution)
    : scene_(scene),
      run_(scene.model, scene.start, scene.settings, run_state_from(parts_of(saved).first, scene.model), {},
           execution),
      trails_(scene) {
  trails_.restore(parts_of(saved).second);
}

// The run must not be beyond the next point of a trail either.
std::optional<std::string> Simulation::save_before(double time, const StopTest& stop) {
  const std::optional<RunState> run = run_.save_before(std::min(time, trails_.next()), stop);
  if (!run) return std::nullopt;
  return as_bytes(*run, trails_);
}

std::string Simulation::save_end() const {
  return as_bytes(run_.save(), trails_);
}

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
  // Other steps are no way out of a crowd.
  if (run_.report().counts.status == StepStatus::crowded) throw RunFailure(run_.failure());
  std::string advice;
  try {
    advice = failure_advice(scene_, run_.state(), stop);
  } catch (const Interrupted&) {
    // The failure is told in any case.
  }
  throw RunFailure(run_.failure() + advice);
}

}  // namespace taut
