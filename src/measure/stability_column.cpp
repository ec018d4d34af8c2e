#include "measure/stability_column.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "measure/reference.h"
#include "methods/registry.h"
#include "model/measures.h"
#include "motion/simulate.h"

namespace taut {
namespace {

constexpr double frame_rate = 60.0;         // steps/s of maps over passes
constexpr std::int64_t fewest_steps = 100;  // an instability needs some to show
constexpr double stretch = 0.01;            // what passes are to shrink …
constexpr double shrinkage = 1e-3;          // … to this share

// The method's settings in a row of the map.
Settings row_settings(const MapGrid& grid, double row, const Settings& given) {
  Settings settings = given;
  const bool passes = grid.axes->rows == MapRows::passes;
  settings.values["steps_per_second"] = passes ? frame_rate : 1.0 / row;
  if (passes) settings.values["passes"] = row;
  return settings;
}

// Runs one cell. Steps are made a little shorter where that makes the duration a whole number of them.
RunOutcome run_cell(const MapGrid& grid, double row, const Built& variant, const ColumnTruth& truth,
                    const Settings& given) {
  const Settings settings = row_settings(grid, row, given);
  const double wanted = grid.duration * settings.steps_per_second();
  const auto steps = static_cast<std::int64_t>(std::ceil(wanted * (1.0 - 1e-9)));
  Settings fitted = settings;
  fitted.values["steps_per_second"] = static_cast<double>(steps) / grid.duration;
  RunOutcome outcome = run_unguarded(variant.model, variant.start, fitted, std::max(steps, fewest_steps),
                                     truth.reference ? &*truth.reference : nullptr, steps);
  outcome.error /= total_link_length(variant.model);
  return outcome;
}

bool step_holds(const MapGrid& grid, double h, const Built& variant, const Settings& given) {
  const auto steps = static_cast<std::int64_t>(std::ceil(grid.duration / h));
  return !run_unguarded(variant.model, variant.start, row_settings(grid, h, given),
                        std::max(steps, fewest_steps))
              .failed();
}

// Whether so many passes leave more than a thousandth of a stretch of 1 % about the first mass, in one step
// without gravity.
bool stretch_remains(double passes, const Built& variant, const Settings& given) {
  Model model = variant.model;
  model.gravity = Vec3::Zero();
  model.loads.clear();
  model.driven_pins.clear();
  State state = variant.start;
  const Vec3 first = state.position.at(0);
  for (std::size_t i = 0; i < state.position.size(); ++i) {
    state.velocity.set(i, Vec3::Zero());
    if (!model.masses.pinned(i))
      state.position.set(i, first + (1.0 + stretch) * (state.position.at(i) - first));
  }
  Settings settings = given;
  settings.values["steps_per_second"] = frame_rate;
  settings.values["passes"] = std::round(passes);
  simulate(model, state, settings, 1, unguarded);
  return link_strain(model, state).largest > shrinkage * stretch;
}

double last_mass_ratio(const Model& model) {
  double lightest = infinity;
  for (std::size_t i = 0; i < model.masses.size(); ++i)
    if (!model.masses.pinned(i)) lightest = std::min(lightest, model.masses.mass[i]);
  return model.masses.mass.back() / lightest;
}

// Kept velocities gain energy as t² whatever the step: a run that is long enough for 10³ energy scales
// diverges, and runs of longer steps are longer (fewest_steps).
Prediction kept_velocity_step(const MapGrid& grid, const Built& variant) {
  const double gain = kept_velocity_gain(variant.model, variant.start, grid.duration);
  const double time = grid.duration * std::sqrt(divergence / gain);
  return {time > grid.duration ? time / static_cast<double>(fewest_steps) : 0.0, "energy m (g t)²/2"};
}

// The edge between the rows that hold from the shortest step on and the first that fails.
std::optional<Edge> edge_of_rows(const MapGrid& grid, const MapColumn& column, const Built& variant,
                                 const Settings& given) {
  std::size_t first_failed = 0;
  while (first_failed < column.cells.size() && !column.cells[first_failed].failed()) ++first_failed;
  if (first_failed == 0 || first_failed == column.cells.size()) return std::nullopt;
  return narrow_edge([&](double h) { return step_holds(grid, h, variant, given); },
                     {grid.rows[first_failed - 1], grid.rows[first_failed]});
}

}  // namespace

ColumnTruth column_truth(const Built& variant, double duration) {
  ColumnTruth truth;
  const double size = total_link_length(variant.model);
  for (const double accuracy : {1e-5, 1e-3}) {
    Reference reference = make_reference(variant.model, variant.start, {duration}, accuracy * size);
    truth.no_reference = reference.refusal;
    if (!reference.certified() || reference.states.empty()) continue;
    truth.reference = std::move(reference.states.back());
    break;
  }
  truth.tensions = largest_tensions(variant.model, variant.start, duration);
  return truth;
}

std::optional<MapColumn> map_column(const MapGrid& grid, double value, const Built& variant,
                                    const ColumnTruth& truth, const Settings& given,
                                    const std::function<bool()>& stop) {
  MapColumn column;
  column.value = value;
  const Method& method = *find_method(given.method);
  const bool passes = grid.axes->rows == MapRows::passes;
  if (passes && find_param(method, "passes") == nullptr) {
    column.refusal = fmt::format("method \"{}\" makes no passes", method.name);
  } else if (const auto problems = capability_problems(variant.model, method); !problems.empty()) {
    column.refusal = problems.front();
  }
  if (!column.refusal.empty()) return column;
  for (const double row : grid.rows) {
    if (stop && stop()) return std::nullopt;
    column.cells.push_back(run_cell(grid, row, variant, truth, given));
  }
  if (passes) {
    column.predicted = {
        predicted_passes(static_cast<double>(variant.model.links.size()), last_mass_ratio(variant.model)),
        "max(2.9 n², n M)"};
    column.edge = find_edge([&](double n) { return stretch_remains(n, variant, given); }, 1.0,
                            10.0 * column.predicted->value);
  } else {
    column.predicted = method.can.limit == StepLimit::kept_velocities
                           ? kept_velocity_step(grid, variant)
                           : predicted_step(variant.model, variant.start, method, truth.tensions);
    column.edge = edge_of_rows(grid, column, variant, given);
  }
  return column;
}

}  // namespace taut
