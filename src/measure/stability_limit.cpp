#include "measure/stability_limit.h"

#include <algorithm>
#include <cmath>

#include "base/failure.h"
#include "methods/frequency.h"
#include "methods/registry.h"
#include "model/measures.h"
#include "motion/run.h"

namespace taut {
namespace {

constexpr double first_rate = 1000.0;  // steps/s
constexpr std::int64_t most_steps = 400'000;

// The largest tensions of one run; nothing where a step of it can't be solved.
std::optional<std::vector<double>> tensions_of_run(const Model& model, const State& start, double duration,
                                                   double rate) {
  const Settings settings = complete_settings({"rattle", {{"steps_per_second", rate}}});
  if (!refusals(model, start, settings).empty()) return std::nullopt;  // springs too stiff for this step
  Run run(model, start, settings);
  std::vector<double> largest(model.links.size(), 0.0);
  const auto steps = static_cast<std::int64_t>(std::ceil(duration * rate));
  while (run.steps() < steps) {
    if (!run.step()) return std::nullopt;
    const std::vector<double>& tension = run.state().tension;
    for (std::size_t i = 0; i < largest.size(); ++i) largest[i] = std::max(largest[i], tension[i]);
  }
  return largest;
}

// min √(m l/T) over rigid links; infinity where none is under tension.
double sideways_limit(const Model& model, const std::vector<double>& tensions) {
  double limit = infinity;
  for (const Index link : solvable_links(model)) {
    if (!model.links.rigid(link) || !(tensions[link] > 0.0)) continue;
    const double heaviness = std::max(model.masses.inverse_mass[model.links.a[link]],
                                      model.masses.inverse_mass[model.links.b[link]]);
    limit = std::min(limit, std::sqrt(model.links.length[link] / (heaviness * tensions[link])));
  }
  return limit;
}

}  // namespace

std::optional<std::vector<double>> largest_tensions(const Model& model, const State& start, double duration) {
  std::optional<std::vector<double>> last;
  const auto peak = [](const std::vector<double>& tensions) {
    return tensions.empty() ? 0.0 : *std::max_element(tensions.begin(), tensions.end());
  };
  for (double rate = first_rate; rate * duration <= most_steps; rate *= 2.0) {
    auto tensions = tensions_of_run(model, start, duration, rate);
    if (last && tensions && std::abs(peak(*tensions) - peak(*last)) <= 0.01 * peak(*tensions))
      return tensions;
    last = std::move(tensions);
  }
  return std::nullopt;
}

std::optional<Prediction> predicted_step(const Model& model, const State& start, const Method& method,
                                         const std::optional<std::vector<double>>& tensions) {
  const StepLimit limit = method.can.limit;
  std::optional<Prediction> prediction;
  const auto take = [&](double seconds, const char* formula) {
    if (seconds < infinity && (!prediction || seconds < prediction->value)) prediction = {seconds, formula};
  };
  if (limit == StepLimit::spring_frequency || limit == StepLimit::sideways_vibration) {
    const double frequency = highest_spring_frequency(model, start);
    if (frequency > 0.0) take(2.0 / frequency, "2/ωₘₐₓ");
  }
  if (limit == StepLimit::sideways_vibration && tensions) take(sideways_limit(model, *tensions), "√(m l/T)");
  return prediction;
}

double chain_frequency(double stiffness, double mass) {
  return 2.0 * std::sqrt(stiffness / mass);
}

double net_frequency(double side_stiffness, double diagonal_stiffness, double mass) {
  return std::sqrt(4.0 * (side_stiffness + diagonal_stiffness) / mass);
}

double predicted_passes(double links, double ratio) {
  return std::max(2.9 * links * links, links * ratio);
}

double kept_velocity_gain(const Model& model, const State& start, double duration) {
  const double speed = model.gravity.norm() * duration;
  const double scale = energy_scale(model, start);
  return scale > 0.0 ? 0.5 * free_mass(model) * speed * speed / scale : 0.0;
}

}  // namespace taut
