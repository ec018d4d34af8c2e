// Steps that are not made whole: halved where they can't be solved, cut at breaks and at stops.

#include <algorithm>
#include <utility>

#include "breaking.h"
#include "energy_guard.h"
#include "methods/breaking.h"
#include "motion/run.h"
#include "stops.h"

namespace taut {
namespace {

// How near to a stop a cut comes, as a share of the step, and how much of the way there it makes at once.
constexpr double nearest_to_stop = 1e-11, cautious = 0.999;
// s, in which an impact happens: so long that positions tell velocities by it, and so short that nothing else
// does much.
constexpr double impact_time = 1e-8;
// So many steps without a failure, and the next one is made in parts twice as long.
constexpr int calm_steps_before_longer_parts = 3;

}  // namespace

// One step of h, or two of h/2 where it can't be solved, or where the steps before could not, as deep as
// `halvings` allows. What moves is only changed when all of it succeeded.
StepReport Run::guarded_step(double h, double end_time, int halvings) {
  const int depth = policy_.most_halvings - halvings;
  if (depth < parts_.depth) return halved_step(h, end_time, halvings, {});
  made_depth_ = std::max(made_depth_, depth);
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
  return halved_step(h, end_time, halvings, report);
}

// Two steps of h/2 instead of one, which has failed as reported, or has not been tried.
StepReport Run::halved_step(double h, double end_time, int halvings, const StepReport& whole) {
  StepReport report = whole;
  report.halvings += 1;
  const State start = state();
  const WorkLedger ledger = ledger_;
  report.add(guarded_step(0.5 * h, end_time - 0.5 * h, halvings - 1));
  if (report.status == StepStatus::done) report.add(guarded_step(0.5 * h, end_time, halvings - 1));
  const bool tried = whole.status != StepStatus::done;
  if (report.status != StepStatus::done) {
    stepper_->load(start);
    ledger_ = ledger;
    if (tried) report.status = whole.status;
  }
  if (tried) report.worst_link = whole.worst_link;
  return report;
}

void Run::note_parts(double begin, const StepReport& report) {
  if (report_.halved_steps == 0) report_.first_halved_at = begin;
  ++report_.halved_steps;
  report_.deepest_halving = std::max(report_.deepest_halving, made_depth_);
  report_.last_halved_at = begin;
  if (report.worst_link != no_link) report_.halved_at_link = report.worst_link;
}

// For the next step. One that can't be made whole seldom comes alone, and what fails takes longer than what
// holds: on 1000 light links with a heavy tip at 60 steps/s, to try each step whole first took half as many
// rounds again.
void Run::choose_parts() {
  if (made_depth_ > parts_.depth)
    parts_ = {made_depth_, 0};
  else if (parts_.depth > 0 && ++parts_.calm_steps == calm_steps_before_longer_parts)
    parts_ = {parts_.depth - 1, 0};
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

}  // namespace taut
