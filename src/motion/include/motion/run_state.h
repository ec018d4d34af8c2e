#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "model/state.h"
#include "motion/run_report.h"
#include "motion/work_ledger.h"

namespace taut {

/// In which parts the next step is made at once, without trying longer ones first.
struct StepParts {
  int depth = 0;       ///< how often the step is halved
  int calm_steps = 0;  ///< how many steps in a row held in these parts
};

/// All that a run is beside its model, its start and its settings: enough to go on from, bit for bit.
struct RunState {
  State state;
  RunReport report;
  Work work;
  StepParts parts = {};
};

/// The same as bytes, for a file or another process on a machine of the same byte order.
std::string to_bytes(const RunState& saved);

/// How many bytes that are.
std::size_t size_in_bytes(const RunState& saved);
/// Appends them to others, with their number before them, as append_bytes() does with a list: what is as
/// large as a large scene need not stand in memory twice.
void append_run_state(const RunState& saved, std::string& bytes);

/// The other way round. Throws BadRequest for bytes that are none of to_bytes(), or not of so many masses,
/// links and joints as the model has.
RunState run_state_from(std::string_view bytes, const Model& model);

}  // namespace taut
