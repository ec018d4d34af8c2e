#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/stop.h"
#include "measure/method_variants.h"
#include "measure/truth.h"
#include "methods/method.h"
#include "model/model.h"
#include "model/state.h"
#include "motion/run_policy.h"

namespace taut {

// Work–precision: how much work each method needs for how much accuracy. (Hairer, Nørsett and Wanner, Solving
// Ordinary Differential Equations I, section II.10.)

/// One point of the grid over a variant's axes.
struct GridPoint {
  std::size_t curve = 0;  ///< its place in the list of variants
  int fineness = 0;       ///< its place along MethodVariant::finer
  int row = 0;            ///< and along MethodVariant::passes
};

/// What one run of a point gave.
struct JudgedRun {
  bool diverged = false;
  std::string trouble;  ///< why there are no errors: how it diverged, or why the method refused; empty else
  Errors errors;
  StepReport counts;
  std::int64_t steps = 0;
};

/// Runs a scene once, without halving steps, and judges it. Throws Interrupted.
JudgedRun judge_run(const Model& model, const State& start, const Truth& truth, const Settings& settings,
                    const StopTest& stop = {});

/// Walks the grid of every curve, always on to the point predicted to be cheapest, and leaves out what can't
/// matter:
/// - rows of passes that stay off their own curve's front (two points in a row where a cheaper point of the
///   same curve has half the error, of every kind), and rows of more passes that had not begun by then,
/// - finer steps once errors no longer fall (by a tenth in three halvings) or are smaller than can be judged,
/// - runs that are predicted to take longer than a limit.
/// What it does depends on the judged runs alone, never on a clock: started again with the same results it
/// goes the same way.
class GridWalk {
 public:
  /// Refers to the model from then on. `most_seconds`: of a single run, as predicted_seconds() has it.
  GridWalk(const Model& model, std::vector<MethodVariant> curves, Truth truth, double most_seconds);

  /// The next point to run; nothing at the end.
  std::optional<GridPoint> next();
  /// What came of the point that next() gave last.
  void record(const JudgedRun& run);
  /// From now on leaves out what is predicted to take longer.
  void forbid_above(double seconds) { most_seconds_ = std::min(most_seconds_, seconds); }

  /// How many points were left out, and why, and how many are neither run nor left out so far.
  struct Counts {
    std::size_t run = 0, off_front = 0, no_gain = 0, too_dear = 0, open = 0;

    std::size_t left_out() const { return off_front + no_gain + too_dear; }
    /// Points that nothing is left to be done about, and all there are: what progress and summaries count.
    std::size_t done() const { return run + left_out(); }
    std::size_t all() const { return done() + open; }
  };
  Counts counts() const;

 private:
  enum class RowEnd { open, off_front, no_gain, too_dear };
  struct Judged {
    Errors errors;
    double work;  // s, predicted
  };
  struct Row {
    RowEnd end = RowEnd::open;
    int next = 0;                 // fineness of its next point
    int dominated = 0;            // how many of its last points a cheaper point of the curve beats
    int stale = 0;                // how many of its last points were hardly better than the best before
    double last_work = infinity;  // s, of its last point that did not diverge
    Errors best;
  };
  struct CurveWalk {
    std::vector<Row> rows;
    std::vector<Judged> judged;
  };

  double predicted_work(const GridPoint& point) const;
  bool is_dominated(const CurveWalk& walk, const Judged& judged) const;
  bool improve(Errors& best, const Errors& errors) const;
  bool cannot_be_told_from_truth(const Errors& errors) const;
  void end_rows(CurveWalk& walk, std::size_t row) const;

  const Model& model_;
  std::vector<MethodVariant> curves_;
  Truth truth_;
  double most_seconds_;
  std::vector<CurveWalk> walks_;
  GridPoint current_;
};

/// The places of those points that no other beats in both cost and error, from cheap to dear.
std::vector<std::size_t> pareto_front(const std::vector<double>& costs, const std::vector<double>& errors);

}  // namespace taut
