#include "frames/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
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

// What to_bytes() gave: the run, and the trails.
std::pair<std::string_view, std::string_view> parts_of(std::string_view saved) {
  ByteReader reader(saved);
  const std::string_view run = reader.take_in_place();
  return {run, reader.take_in_place()};
}

std::size_t size_of_parts(const SavedSimulation& saved) {
  return sizeof(std::uint64_t) + size_in_bytes(saved.run) + size_in_bytes(saved.trails);
}

void append_parts(const SavedSimulation& saved, std::string& bytes) {
  append_run_state(saved.run, bytes);
  append_bytes(saved.trails, bytes);
}

}  // namespace

std::string to_bytes(const SavedSimulation& saved) {
  std::string bytes;
  bytes.reserve(size_of_parts(saved));
  append_parts(saved, bytes);
  return bytes;
}

void append_saved(const SavedSimulation& saved, std::string& bytes) {
  constexpr std::size_t what_may_follow = 256;
  const std::size_t size = size_of_parts(saved);
  bytes.reserve(bytes.size() + sizeof(std::uint64_t) + size + what_may_follow);
  append_bytes(static_cast<std::uint64_t>(size), bytes);
  append_parts(saved, bytes);
}

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
std::optional<SavedSimulation> Simulation::save_before(double time, const StopTest& stop) {
  std::optional<RunState> run = run_.save_before(std::min(time, trails_.next()), stop);
  if (!run) return std::nullopt;
  return SavedSimulation{*std::move(run), trails_.save()};
}

SavedSimulation Simulation::save_end() const {
  return {run_.save(), trails_.save()};
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
