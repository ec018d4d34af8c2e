#include "motion/run.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "base/failure.h"
#include "breaking.h"
#include "energy_guard.h"
#include "fastest_solid.h"
#include "methods/breaking.h"
#include "methods/registry.h"
#include "model/parts.h"
#include "stops.h"

namespace taut {
namespace {

constexpr std::int64_t steps_between_looks = 16;
constexpr int parts_for_work = 4;  // of a step that the method chose, between which work is looked at
constexpr int most_cuts = 32;      // of a step; what breaks beyond that does so at its end

const Method& willing(const Method& method, const Model& model, const State& start,
                      const Settings& settings) {
  const std::vector<std::string> problems = refusals(method, model, start, settings);
  if (!problems.empty()) throw BadRequest(fmt::format("{}", fmt::join(problems, "\n")));
  return method;
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
    case StepStatus::pressed_through:
      return "pins or solids press its faces through each other";
    case StepStatus::crowded:
      return "more than 20 million pairs of its balls touch or nearly do: so many are not solved";
    case StepStatus::chattering:
      return "its stops are met and left again without end";
  }
  return "";
}

}  // namespace

Run::Run(const Model& model, const State& start, const Settings& settings, const RunPolicy& policy,
         const Execution& execution)
    : Run(model, start, method_called(settings.method), settings, policy, execution) {}

Run::Run(const Model& model, const State& start, const Method& method, const Settings& settings,
         const RunPolicy& policy, const Execution& execution)
    : Run(model, start, method, settings, RunState{start, {}, {}}, policy, execution) {}

Run::Run(const Model& model, const State& start, const Settings& settings, const RunState& saved,
         const RunPolicy& policy, const Execution& execution)
    : Run(model, start, method_called(settings.method), settings, saved, policy, execution) {}

Run::Run(const Model& model, const State& start, const Method& method, const Settings& settings,
         const RunState& saved, const RunPolicy& policy, const Execution& execution)
    : model_(&model),
      execution_(execution),
      settings_(complete_settings(method, settings)),
      method_(willing(method, model, start, settings_)),
      policy_(policy),
      steps_per_second_(method_.can.chooses_steps ? 0.0 : settings_.steps_per_second()),
      start_time_(start.time),
      fastest_solid_(fastest_solid(model, start)),
      energy_base_{energy(model, start), energy_scale(model, start)},
      stepper_(method_.make(model, settings_, execution)),
      ledger_(model, saved.state, saved.work),
      report_(saved.report),
      parts_{std::min(saved.parts.depth, policy.most_halvings), saved.parts.calm_steps} {
  // Without rigid links there is nothing that a shorter step would solve better.
  if (policy.watch_energy && method_.can.takes_steps_back && has_rigid_links(model))
    guard_ = std::make_unique<EnergyGuard>(model, start);
  cuts_at_stops_ = policy.cut_at_stops && method_.can.tension_order >= 2 && method_.can.takes_steps_back;
  if (cuts_at_stops_) touched_ = touched_stops(model, saved.state);
  // What has been changed already is in the state, but for the pins that have let go.
  while (next_change() <= saved.state.time) {
    const std::vector<Index> pins = model_->changes[changes_made_++].pins;
    if (!pins.empty()) let_go_of(pins);
  }
  if (released_) {
    stepper_ = method_.make(*model_, settings_, execution_);
    ledger_ = WorkLedger(*model_, saved.state, saved.work);
    if (guard_) guard_->go_on_with(*model_);
  }
  stepper_->load(saved.state);
  stepper_->watch(ledger_.watched());
}

Run::~Run() = default;
Run::Run(Run&&) noexcept = default;

double Run::reached() const {
  return method_.can.chooses_steps ? stepper_->glimpse().time : step_time(report_.steps);
}

double Run::step_time(std::int64_t step) const {
  // The sum of many steps would drift away from it.
  return start_time_ + static_cast<double>(step) / steps_per_second_;
}

bool Run::step() {
  if (ended()) return false;
  if (method_.can.chooses_steps) return own_step();
  const double begin = step_time(report_.steps);
  cuts_left_ = most_cuts;
  made_depth_ = 0;
  const StepReport step = step_through_changes(begin, step_time(report_.steps + 1));
  report_.counts.add(step);
  if (made_depth_ > 0) note_parts(begin, step);
  choose_parts();
  if (step.status != StepStatus::done) {
    report_.end = RunEnd::step_failed;
    return false;
  }
  if (!model_->breakable_links.empty())
    break_links(links_over_threshold(*model_, method_.can, state()), report_.counts);
  ++report_.steps;
  return report_.steps % steps_between_looks != 0 || holds_together();
}

double Run::next_change() const {
  return changes_made_ < model_->changes.size() ? model_->changes[changes_made_].time : infinity;
}

// A whole step, or its parts between the changes in it.
StepReport Run::step_through_changes(double begin, double end) {
  const double h = 1.0 / steps_per_second_;
  if (next_change() > end) return guarded_step(h, end, policy_.most_halvings);
  StepReport report;
  double from = begin;
  const auto make = [&](double to) {
    if (to - from > least_part * h) report.add(guarded_step(to - from, to, policy_.most_halvings));
    from = to;
    return report.status == StepStatus::done;
  };
  while (next_change() <= end) {
    const double at = end - next_change() > least_part * h ? next_change() : end;
    if (!make(at)) return report;
    change(model_->changes[changes_made_++]);
  }
  make(end);
  return report;
}

// As long as the method has it, as far as the next break or change.
bool Run::own_step() {
  const double begin = stepper_->glimpse().time, longest = next_change() - begin;
  const StepReport step = stepper_->step(longest, next_change());
  report_.counts.add(step);
  if (step.status != StepStatus::done) {
    report_.end = RunEnd::step_failed;
    return false;
  }
  if (ledger_.keeps_anything() && stepper_->glimpse().time > begin) {
    std::vector<State> states;
    for (int i = 1; i < parts_for_work; ++i)
      states.push_back(stepper_->between(begin + (stepper_->glimpse().time - begin) * i / parts_for_work));
    states.push_back(stepper_->glimpse());
    ledger_.record(states);
  }
  const std::span<const Index> breaking = stepper_->breaking();
  break_links({breaking.begin(), breaking.end()}, report_.counts);
  if (stepper_->glimpse().time >= next_change()) change(model_->changes[changes_made_++]);
  ++report_.steps;
  return report_.steps % steps_between_looks != 0 || holds_together();
}

// All of them at once, effective from the next step on.
void Run::break_links(const std::vector<Index>& links, StepReport& report) {
  if (links.empty()) return;
  if (ledger_.keeps_anything()) ledger_.record(state());
  State broken = state();
  break_at_once(*model_, broken, links);
  report.breaks += static_cast<std::int64_t>(links.size());
  stepper_->load(broken);
  if (ledger_.keeps_anything()) ledger_.record(state());
}

double Run::energy_at_hand() const {
  const double mass = free_mass(*model_), pin = std::max(work().fastest_pin, fastest_solid_);
  double energy = energy_base_.scale + mass * pin * pin + std::max(0.0, work().loads);
  if (model_->wind) energy += mass * wind_at(*model_->wind, state().time).squaredNorm();
  return energy;
}

// A run that has gone off tells so long before its numbers overflow. Only energy of motion counts: links that
// a few passes leave stretched hold a lot of elastic energy while nothing is amiss.
bool Run::holds_together() {
  const double at_hand = energy_at_hand();
  if (at_hand > 0.0 &&
      energy_of_masses(*model_, stepper_->motion()).kinetic > policy_.diverged_beyond * at_hand)
    report_.end = RunEnd::diverged;
  return !ended();
}

std::optional<State> Run::at(double time, const StopTest& stop) {
  while (reached() < time) {
    if (stop && stop()) return std::nullopt;
    // Copied only where it is needed: a copy of every step would cost as much as a cheap step itself.
    if (!method_.can.chooses_steps && step_time(report_.steps + 1) > time) before_ = state();
    if (!step()) return std::nullopt;
  }
  if (!holds_together()) return std::nullopt;
  if (state().time == time) return state();
  if (method_.can.chooses_steps)
    return (left_behind_ && time < left_at_ ? left_behind_ : stepper_)->between(time);
  // Between steps faces are known not to go through each other on the straight line.
  return interpolate(*before_, state(), time,
                     model_->faces.empty() ? method_.can.between_steps : Interpolation::linear);
}

// A method that chooses its steps doesn't say how far the next one will go: every step but the last is kept.
std::optional<RunState> Run::save_before(double time, const StopTest& stop) {
  if (reached() >= time) return std::nullopt;
  std::optional<RunState> saved;
  while (method_.can.chooses_steps ? reached() < time : step_time(report_.steps + 1) < time) {
    if (stop && stop()) return std::nullopt;
    if (method_.can.chooses_steps) saved = save();
    if (!step()) return std::nullopt;
  }
  return method_.can.chooses_steps ? saved : save();
}

std::string Run::failure() const {
  if (report_.end == RunEnd::none) return {};
  if (report_.end == RunEnd::diverged)
    return fmt::format(
        "the run with method {} {} diverges: at t = {:.6g} s its masses move with {:.3g} times the scene's "
        "energy",
        settings_.method, pace_text(settings_), state().time,
        energy_of_masses(*model_, state()).kinetic / energy_at_hand());
  std::string where;
  if (const Index link = report_.counts.worst_link; link != no_link)
    where = " at the link " + link_name(*model_, link);
  const bool halved = policy_.most_halvings > 0 && method_.can.takes_steps_back;
  const std::string length =
      method_.can.chooses_steps ? "" : fmt::format(" by {:.3g} s", 1.0 / steps_per_second_);
  return fmt::format("the step from t = {:.6g} s{} can't be solved with method {}: {}{}{}", state().time,
                     length, settings_.method, reason(report_.counts.status), where,
                     halved ? ", even after halving it" : "");
}

State Run::reported(const State& state) const {
  return reported_state(*model_, method_.can, state);
}

RunMeasures Run::measures(const State& state) const {
  return measure_run(*model_, energy_base_, reported(state), work(), report_);
}

RunState Run::save() const {
  return {state(), report_, work(), parts_};
}

}  // namespace taut
