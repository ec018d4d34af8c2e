#pragma once

#include <string>
#include <vector>

#include "measure/planner.h"
#include "study/chart.h"

namespace taut {

/// A plan, judged afterwards against the truth that errors of its size need, and against everything that was
/// charted.
struct PlanVerdict {
  std::string scene;
  double wanted = 0.0;
  Plan plan;
  ErrorKind kind = ErrorKind::trajectory;  ///< judged by: the motion where there is a true one, else the sag
  double until = 0.0;                      ///< s, how far it was judged
  double share = 0.0;                      ///< of the run, 0 to 1: as far as that
  double smallest = 0.0;                   ///< error that can be judged
  double error = infinity;                 ///< infinity when the run diverged
  double work = 0.0;                       ///< s, predicted_seconds() of the run up to the chart's horizon
  /// s, of the cheapest charted point that meets the target; absent where none does, or where the chart looks
  /// at less of the run than the plan, which says nothing of what the rest needs.
  std::optional<double> cheapest_work;

  bool judged() const { return wanted >= smallest; }
  bool judged_to_the_end() const { return judged() && reaches_the_end(until, until / share); }
  bool within() const { return error <= wanted; }
};

/// Plans a charted scene for errors of 10 %, 1 % and 0.1 %, runs each plan, and judges it.
std::vector<PlanVerdict> judge_plans(const Scene& scene, const Chart& chart, const StopTest& stop = {});

/// The verdicts as a Markdown table, with a sentence that counts those that can be judged.
std::string plan_table(const std::vector<PlanVerdict>& verdicts);

}  // namespace taut
