#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/stop.h"
#include "methods/method.h"
#include "model/model.h"
#include "model/state.h"
#include "motion/run_measures.h"
#include "motion/run_policy.h"
#include "motion/run_report.h"
#include "motion/run_state.h"
#include "motion/work_ledger.h"

namespace taut {

class EnergyGuard;

/// A model in motion by one method, and the one loop that steps it: whatever draws, exports, judges, times or
/// explains a run goes through here. It moves in whole steps of 1/steps_per_second; step k ends at exactly
/// start + k/steps_per_second, and so does what breaks in it; or in steps of the method's own choice
/// (Capabilities::chooses_steps). What is asked of it in between never changes the run.
class Run {
 public:
  /// Refers to the model from then on. Settings are completed. Throws BadRequest where the method refuses the
  /// run (refusals()): the last time that it can; later there are only reports.
  Run(const Model& model, const State& start, const Settings& settings, const RunPolicy& policy = {},
      const Execution& execution = {});
  /// The same by a method at hand, which need not be one of all_methods() and must live as long as the run.
  Run(const Model& model, const State& start, const Method& method, const Settings& settings,
      const RunPolicy& policy = {}, const Execution& execution = {});
  /// Goes on from what save() gave, in this process or another, with the same model, start and settings:
  /// every bit is as if it had never been left.
  Run(const Model& model, const State& start, const Settings& settings, const RunState& saved,
      const RunPolicy& policy = {}, const Execution& execution = {});
  Run(const Model& model, const State& start, const Method& method, const Settings& settings,
      const RunState& saved, const RunPolicy& policy = {}, const Execution& execution = {});
  ~Run();
  Run(Run&&) noexcept;

  /// Makes the next step; with methods whose tension is of second order (Capabilities::tension_order) it is
  /// cut where a link breaks within it, with others links break at its end. False when the run has ended: in
  /// this step, or before.
  bool step();
  /// The state at a time (s) that is not before the one asked for last: between two steps interpolated from
  /// both. Nothing when told to stop on the way, or when the run has ended before.
  std::optional<State> at(double time, const StopTest& stop = {});

  /// Steps as far as one step before a time (s), and gives all that it takes to go on from there: to this
  /// time and later ones. Nothing where the run is there already, when told to stop, or when it has ended.
  std::optional<RunState> save_before(double time, const StopTest& stop = {});

  /// Whether the masses move with no more energy than there can be. It is looked at every few steps, and
  /// where a state is asked for; the run ends where they don't.
  bool holds_together();

  /// Where the steps so far have come to: the last good state, where the run has ended.
  const State& state() const { return stepper_->store(); }
  const Settings& settings() const { return settings_; }
  std::int64_t steps() const { return report_.steps; }
  bool ended() const { return report_.end != RunEnd::none; }
  const RunReport& report() const { return report_; }
  const Work& work() const { return ledger_.work(); }
  /// Why the run has ended, as a sentence that names time, step and link; empty while it
  /// goes on.
  std::string failure() const;
  /// The energy (J) that the masses' motion is measured by: that of the scene, and what pins, solids that
  /// move, loads and wind may have given to it.
  double energy_at_hand() const;

  /// A state as reports show it: velocities projected onto what links allow where the method keeps half a
  /// kick in them.
  State reported(const State& state) const;
  /// What was measured of the run up to a state that at() or state() gave.
  RunMeasures measures(const State& state) const;
  /// All that it takes to go on from here.
  RunState save() const;

 private:
  static constexpr double least_part = 1e-4;  // of a step, that is worth one of its own

  double reached() const;
  StepReport step_through_changes(double begin, double end);
  void change(const Change& change);
  void let_go_of(const std::vector<Index>& pins);
  void release(const std::vector<Index>& pins);
  double next_change() const;
  double step_time(std::int64_t step) const;
  bool own_step();
  StepReport guarded_step(double h, double end_time, int halvings);
  StepReport halved_step(double h, double end_time, int halvings, const StepReport& whole);
  void note_parts(double begin, const StepReport& report);
  void choose_parts();
  StepReport cut_step(double h, double end_time, int halvings, StepReport report);
  StepReport stopped_step(double h, double end_time, int halvings, StepReport report,
                          const std::vector<bool>& touched);
  void break_links(const std::vector<Index>& links, StepReport& report);

  const Model* model_;               // as it is now: some pins may have let go
  std::unique_ptr<Model> released_;  // that model, where they have
  Execution execution_;
  std::size_t changes_made_ = 0;  // of the model's
  // By the last release: what knows the step before, and the model that it refers to where that is not the
  // first one.
  std::unique_ptr<Model> left_model_;
  std::unique_ptr<Stepper> left_behind_;
  double left_at_ = 0.0;  // s, when
  Settings settings_;
  const Method& method_;
  RunPolicy policy_;
  double steps_per_second_;  // 0 where the method chooses its steps
  double start_time_;
  double fastest_solid_;  // m/s, at any time
  EnergyBase energy_base_;
  std::unique_ptr<Stepper> stepper_;
  WorkLedger ledger_;
  std::unique_ptr<EnergyGuard> guard_;  // none where nothing is watched
  bool cuts_at_stops_ = false;
  std::vector<bool> touched_;    // stops at the end of the last step, where steps are cut at them
  std::optional<State> before_;  // the step before the last, where a time in between was asked for
  RunReport report_;
  StepParts parts_;
  // Of the present step:
  int made_depth_ = 0;  // how often the shortest of its parts is halved
  int cuts_left_ = 0;   // at breaks and stops
};

}  // namespace taut
