#include "study/explain.h"

#include <algorithm>
#include <chrono>

#include "base/failure.h"
#include "frames/simulation.h"
#include "methods/registry.h"
#include "model/parts.h"
#include "motion/run.h"

namespace taut {
namespace {

constexpr int rounds = 7;
constexpr double round_seconds = 0.02;

// Seconds a step takes over `steps` of a scene's physics, after the first, in which methods make ready.
double time_steps(const Scene& scene, const Model& model, std::int64_t steps, const StopTest& stop) {
  using Clock = std::chrono::steady_clock;
  Run run(model, scene.start, scene.settings);
  const auto step = [&] {
    if (!run.step()) throw RunFailure(run.failure());
    stop_if_told(stop);
  };
  step();
  const auto begin = Clock::now();
  while (run.steps() <= steps) step();
  return std::chrono::duration<double>(Clock::now() - begin).count() / static_cast<double>(steps);
}

// One way to run a scene, and the best time so far.
struct Variant {
  Model model;
  double seconds = infinity;
};

// A part that the method can't be without (stiffness, for a method of springs) has no time without it.
bool can_do(const Scene& scene, const Model& model) {
  return refusals(model, scene.start, scene.settings).empty();
}

}  // namespace

Explanation explain(const Scene& scene, const StopTest& stop) {
  const Simulation able(scene);  // complains where the method can't do what the scene needs
  Explanation explanation;
  const Model& model = scene.model;
  explanation.masses = model.masses.size();
  for (std::size_t i = 0; i < model.masses.size(); ++i) explanation.pins += model.masses.pinned(i) ? 1 : 0;
  explanation.links = model.links.size();
  explanation.links_between_pins = model.links.size() - solvable_links(model).size();
  explanation.in_plane = stays_in_plane(model, scene.start);

  std::vector<Variant> variants{{model}};
  std::vector<std::size_t> variant_of;  // one a part; 0 where there is none without it
  for (const Part& part : model_parts()) {
    explanation.parts.push_back({std::string(part.name), part.extent(model)});
    Model without = model;
    part.remove(without);
    const bool timed = !explanation.parts.back().extent.empty() && can_do(scene, without);
    variant_of.push_back(timed ? variants.size() : 0);
    if (timed) variants.push_back({std::move(without)});
  }
  const double first = time_steps(scene, model, 1, stop);
  const auto steps = static_cast<std::int64_t>(std::clamp(round_seconds / first, 1.0, 20000.0));
  for (int round = 0; round < rounds; ++round)
    for (Variant& variant : variants)
      variant.seconds = std::min(variant.seconds, time_steps(scene, variant.model, steps, stop));
  explanation.step_seconds = variants.front().seconds;
  for (std::size_t i = 0; i < variant_of.size(); ++i)
    if (variant_of[i] > 0)
      explanation.parts[i].seconds =
          std::max(0.0, explanation.step_seconds - variants[variant_of[i]].seconds);
  return explanation;
}

}  // namespace taut
