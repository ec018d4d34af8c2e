#include "measure/cost.h"

#include <algorithm>
#include <cmath>

#include "measure/pace.h"
#include "methods/frequency.h"
#include "methods/registry.h"
#include "model/parts.h"

namespace taut {
namespace {

constexpr double any_step = 80.0;  // ns
// ns · rows³ a round: limits on angles make direct solves dense.
constexpr double dense_round = 0.036;
// ns a limit and round, and a contact point and step, beside what its links cost.
constexpr double limit_round = 70.0, contact_step = 100.0;
constexpr double wind_step = 19.0;  // ns a triangle and step
// Of a method that chooses its steps: evaluations of all links a step, and how far a step can go beside the
// vibration of the stiffest springs, ω·h.
constexpr std::int64_t evaluations = 14;
constexpr double farthest_turn = 4.0;

double rigid_links(const Model& model) {
  return static_cast<double>(std::ranges::count(model.links.stiffness, infinity));
}

// Steps a second that settings make by rule.
double expected_pace(const Model& model, const Settings& settings) {
  double pace = pace_of(model, settings);
  if (!settings.chooses_steps()) return pace;
  State whole;
  whole.broken_at.assign(model.links.size(), infinity);
  return std::max(pace, spring_frequency_bound(model, whole) / farthest_turn);
}

}  // namespace

double predicted_seconds(const Model& model, std::string_view method, const StepReport& counts,
                         double steps) {
  const Method& entry = *find_method(method);
  const Prices& price = entry.prices;
  const auto rows = static_cast<double>(model.links.size()),
             limits = static_cast<double>(model.limits.size()), rounds = static_cast<double>(counts.rounds),
             factorisations = static_cast<double>(counts.factorisations);
  const double net = share_of_net(rows, static_cast<double>(model.masses.size()));
  // What chooses its steps has links with stiffness as forces, of every evaluation.
  const double forces =
      entry.can.chooses_steps ? price.solve * factorisations * (rows - rigid_links(model)) : 0.0;
  // Masses on the ground alone cost next to nothing.
  const double contacts = touches_only_ground(model) ? 0.0 : static_cast<double>(model.contacts.size());
  const bool dense = price.factor > 0.0 && limits > 0.0;
  // Where links with stiffness are forces, a model without rigid links has a system of no rows.
  const bool factors = entry.can.limit != StepLimit::sideways_vibration || has_rigid_links(model);
  return 1e-9 * (any_step * steps + price.round * rounds + price.step * steps * rows +
                 std::lerp(price.solve, price.net_solve, net) * static_cast<double>(counts.link_solves) +
                 forces + (factors ? net * price.factor * factorisations * rows * std::sqrt(rows) : 0.0) +
                 (dense ? dense_round * rounds * std::pow(rows + limits, 3.0) : 0.0) +
                 limit_round * rounds * limits + contact_step * steps * contacts +
                 (model.wind ? wind_step * steps * static_cast<double>(model.triangles.size()) : 0.0));
}

double predicted_seconds(const Model& model, const Run& run) {
  return predicted_seconds(model, run.settings().method, run.report().counts,
                           static_cast<double>(run.steps()));
}

double predicted_seconds(const Model& model, std::string_view method, double steps, std::int64_t passes) {
  StepReport counts;
  counts.link_solves =
      static_cast<std::int64_t>(steps) * passes * static_cast<std::int64_t>(model.links.size());
  counts.rounds = static_cast<std::int64_t>(steps) * passes;
  const Method& entry = *find_method(method);
  if (find_param(entry, "passes") == nullptr) counts.factorisations = static_cast<std::int64_t>(steps);
  if (entry.can.chooses_steps) {
    counts.rounds = counts.factorisations;
    counts.factorisations *= evaluations;
    counts.link_solves = counts.factorisations * static_cast<std::int64_t>(rigid_links(model));
  }
  return predicted_seconds(model, method, counts, steps);
}

double predicted_seconds(const Model& model, const Settings& settings, double seconds) {
  const auto passes =
      settings.values.contains("passes") ? static_cast<std::int64_t>(settings.number("passes")) : 2;
  return predicted_seconds(model, settings.method, expected_pace(model, settings) * seconds, passes);
}

}  // namespace taut
