#pragma once

#include <functional>
#include <string_view>

#include "base/stop.h"
#include "measure/plan.h"
#include "measure/truth.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// The kind of error by which a truth judges a target: the target's, or the sag where that alone can be told
/// finely enough.
ErrorKind judging_kind(const Truth& truth, ErrorKind kind, double wanted);

/// What a search for a plan is to keep to.
struct SearchRules {
  std::string_view only;             ///< a method that the plan has to use; empty: any
  std::function<bool()> time_is_up;  ///< asked all the time; once true the best so far is taken
  StopTest stop;                     ///< once true, Interrupted is thrown
};

/// Improves on a first plan by search: walks the charts' grid of methods, steps and passes from cheap to dear
/// (GridWalk), judges every run by the truth up to its horizon, and takes the cheapest of those within nine
/// tenths of the target; dearer ones are not run. What a method costs is measured on the way, in processor
/// time of this machine. Where the truth ends before the scene does, the plan is never coarser than its
/// method's default. Where none is good enough before the time is up, or before the work that may be spent on
/// it is, the best is taken; where the truth can't judge, or judges less of the run than the first plan's own
/// runs did, the first plan is.
Plan make_plan(const Model& model, const State& start, const Truth& truth, const AccuracyTarget& target,
               const Plan& first, const SearchRules& rules = {});

}  // namespace taut
