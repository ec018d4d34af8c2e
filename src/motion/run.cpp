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
constexpr int parts_for_work = 4;    // of a step that the method chose, between which work is looked at
constexpr double least_part = 1e-4;  // of a step, that is worth one of its own
constexpr int most_cuts = 32;        // of a step; what breaks beyond that does so at its end
// How near to a stop a cut comes, as a share of the step, and how much of the way there it makes at once.
constexpr double nearest_to_stop = 1e-11, cautious = 0.999;
// s, in which an impact happens: so long that positions tell velocities by it, and so short that nothing else
// does much.
constexpr double impact_time = 1e-8;

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
      report_(saved.report) {
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
  const StepReport step = step_through_changes(begin, step_time(report_.steps + 1));
  report_.counts.add(step);
  if (step.halvings > 0) note_halving(begin, step);
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

// One step of h, or two of h/2 where it can't be solved, as deep as `halvings` allows. What moves is only
// changed when all of it succeeded.
StepReport Run::guarded_step(double h, double end_time, int halvings) {
  StepReport report = stepper_->step(h, end_time);
  if (report.status == StepStatus::done && guard_ &&
      guard_->exceeded(*stepper_, h,
                       ledger_.keeps_anything() ? ledger_.until(stepper_->glimpse()) : ledger_.work())) {
    stepper_->undo();
    report.status = StepStatus::energy_jump;
  }
  if (report.status == StepStatus::done) {
    // Where tension and positions are of second order, the moment of a break is, too.
    if (method_.can.tension_order >= 2 && cuts_left_ > 0 && !model_->breakable_links.empty() &&
        !links_over_threshold(*model_, method_.can, state()).empty())
      return cut_step(h, end_time, halvings, report);
    if (cuts_at_stops_) {
      const std::vector<bool> touched = touched_stops(*model_, state());
      if (cuts_left_ > 0 && meets_more(touched, touched_))
        return stopped_step(h, end_time, halvings, report, touched);
      touched_ = touched;
    }
    if (ledger_.keeps_anything()) ledger_.record(stepper_->glimpse());
    ledger_.add_contacts(report.contact_work);
    return report;
  }
  if (halvings == 0 || !method_.can.takes_steps_back) return report;
  const StepReport first_failure = report;
  const State start = state();
  const WorkLedger ledger = ledger_;
  report.halvings += 1;
  report_.deepest_halving = std::max(report_.deepest_halving, policy_.most_halvings - halvings + 1);
  report.add(guarded_step(0.5 * h, end_time - 0.5 * h, halvings - 1));
  if (report.status == StepStatus::done) report.add(guarded_step(0.5 * h, end_time, halvings - 1));
  if (report.status != StepStatus::done) {
    stepper_->load(start);
    ledger_ = ledger;
    report.status = first_failure.status;
  }
  report.worst_link = first_failure.worst_link;
  return report;
}

void Run::note_halving(double begin, const StepReport& report) {
  if (report_.halved_steps == 0) report_.first_halved_at = begin;
  ++report_.halved_steps;
  report_.last_halved_at = begin;
  report_.halved_at_link = report.worst_link;
}

// The step just made, made again as far as the first break in it, and the rest without what broke.
StepReport Run::cut_step(double h, double end_time, int halvings, StepReport report) {
  --cuts_left_;
  const State after = state();
  stepper_->undo();
  const State start = stepper_->store();
  const WorkLedger ledger = ledger_;
  const FirstBreak first = *first_break(*model_, start, after);
  const double share = first.share < least_part ? 0.0 : first.share > 1.0 - least_part ? 1.0 : first.share;
  const double part = share * h, rest = h - part;
  if (part > 0.0) report.add(stepper_->step(part, rest > 0.0 ? end_time - rest : end_time));
  if (report.status == StepStatus::done) {
    break_links(first.links, report);
    if (rest > 0.0) report.add(guarded_step(rest, end_time, halvings));
  }
  if (report.status != StepStatus::done) {
    stepper_->load(start);
    ledger_ = ledger;
  }
  return report;
}

// The step just made, which touches more stops than before, made again as far as just before the first of
// them, and then the rest of it, with the stop there from its start: so the impulse comes at its moment. That
// moment is found from before, by what the angle's rate says, and by halving what goes too far.
StepReport Run::stopped_step(double h, double end_time, int halvings, StepReport report,
                             const std::vector<bool>& touched) {
  --cuts_left_;
  stepper_->undo();
  const State start = stepper_->store();
  const WorkLedger ledger = ledger_;
  const auto make = [&](double part) {
    stepper_->load(start);
    if (part > 0.0) report.add(stepper_->step(part, end_time - (h - part)));
    return report.status == StepStatus::done;
  };
  State last = start;
  double before = 0.0, behind = h;
  while (behind - before > nearest_to_stop * h) {
    const double way = time_to_stop(*model_, last, touched_);
    double part = before + cautious * way;
    if (!(part > before && part < behind)) part = 0.5 * (before + behind);
    if (way < nearest_to_stop * h || !make(part)) break;
    if (meets_more(touched_stops(*model_, state()), touched_)) {
      behind = part;
    } else {
      before = part;
      last = state();
    }
  }
  if (report.status == StepStatus::done && make(before)) {
    touched_ = touched;
    // A stop that has pushed in a step holds to its end: so the impulse has a short one of its own.
    const double impact = std::min(impact_time, h - before), rest = h - before - impact;
    report.add(stepper_->step(impact, rest > 0.0 ? end_time - rest : end_time));
    if (report.status == StepStatus::done && rest > 0.0) report.add(guarded_step(rest, end_time, halvings));
  }
  if (report.status != StepStatus::done) {
    stepper_->load(start);
    ledger_ = ledger;
  }
  return report;
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
  if (at_hand > 0.0 && energy(*model_, state()).kinetic > policy_.diverged_beyond * at_hand)
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
        energy(*model_, state()).kinetic / energy_at_hand());
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
  return {state(), report_, work()};
}

}  // namespace taut
