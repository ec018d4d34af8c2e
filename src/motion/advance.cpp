#include "motion/advance.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace taut {
namespace {

// One step of h, or two of h/2 where it can't be solved, as deep as `halvings` allows. The state is only
// changed when all of it succeeded.
StepReport guarded_step(Stepper& stepper, State& state, double h, int halvings) {
  StepReport report = stepper.step(state, h);
  if (report.status == StepStatus::done || halvings == 0) return report;
  const StepReport first_failure = report;
  const State start = state;
  report.halvings += 1;
  report.add(guarded_step(stepper, state, 0.5 * h, halvings - 1));
  if (report.status == StepStatus::done) report.add(guarded_step(stepper, state, 0.5 * h, halvings - 1));
  if (report.status == StepStatus::done) return report;
  state = start;
  report.status = first_failure.status;
  report.worst_link = first_failure.worst_link;
  return report;
}

bool between_pins(const Model& model, Index link) {
  return model.masses.pinned(model.links.a[link]) && model.masses.pinned(model.links.b[link]);
}

// Whether a link is longer than its break_stretch allows. Nearly every link is far from that, and its square
// tells so without a root.
bool overstretched(const Model& model, const Vectors& position, Index link) {
  const double most = model.links.break_stretch[link] * model.links.length[link];
  const Vec3 difference = position.at(model.links.a[link]) - position.at(model.links.b[link]);
  const double square = difference.squaredNorm();
  return square > 0.999999 * (most * most) && std::sqrt(square) > most;
}

// Every whole link over a threshold. break_stretch is left to the stepper where that tests it within the
// step.
std::int64_t break_links(const Stepper& stepper, const Model& model, State& state) {
  const bool stretch_tested = stepper.breaks_within_step();
  std::int64_t breaks = 0;
  for (const Index link : model.breakable_links) {
    if (state.broken(link)) continue;
    const bool test_stretch = !stretch_tested || between_pins(model, link);
    if (!(state.tension[link] > model.links.break_tension[link]) &&
        !(test_stretch && overstretched(model, state.position, link)))
      continue;
    state.broken_at[link] = state.time;
    state.tension[link] = 0.0;
    ++breaks;
  }
  return breaks;
}

std::string_view reason(StepStatus status) {
  switch (status) {
    case StepStatus::done:
      return "it was solved";
    case StepStatus::not_converged:
      return "its links could not be brought to their lengths";
    case StepStatus::direction_lost:
      return "a link turned by 90° or more within it";
    case StepStatus::factorisation_failed:
      return "its linear system is singular";
    case StepStatus::not_finite:
      return "a position or velocity is no longer a finite number";
    case StepStatus::energy_jump:
      return "it made energy out of nothing";
  }
  return "";
}

}  // namespace

StepReport advance(Stepper& stepper, const Model& model, State& state, double h, const Guard& guard) {
  StepReport report = guarded_step(stepper, state, h, guard.on ? guard.most_halvings : 0);
  if (report.status != StepStatus::done || model.breakable_links.empty()) return report;
  if (const std::int64_t breaks = break_links(stepper, model, state); breaks > 0) {
    report.breaks += breaks;
    stepper.links_changed(state);
  }
  return report;
}

std::string failure_sentence(const Model& model, const State& state, const StepReport& report,
                             std::string_view method, double h) {
  std::string where;
  if (report.worst_link != no_link)
    where = fmt::format(" at the link {} – {}", model.masses.name[model.links.a[report.worst_link]],
                        model.masses.name[model.links.b[report.worst_link]]);
  return fmt::format(
      "the step from t = {:.6g} s by {:.3g} s can't be solved with method {}: {}{}, even after halving it; "
      "try more "
      "steps_per_second, or another method",
      state.time, h, method, reason(report.status), where);
}

}  // namespace taut
