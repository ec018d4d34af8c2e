#pragma once

#include <optional>
#include <vector>

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// The links that are the first to pass a threshold within a step.
struct FirstBreak {
  double share = 1.0;        ///< of the step, 0 where they were over it at its start, to 1
  std::vector<Index> links;  ///< in file order; several where they pass at once
};

/// The first break between two states a step apart, nothing where no link ends over a threshold. Tension and
/// length go along straight lines between the two, so the moment is of second order where tension and
/// positions are (Capabilities::tension_order).
///
/// For such a method the step is to be made again as far as the break, the links broken with break_at_once(),
/// and the rest of the step made without them: then the motion after it is of second order, too.
std::optional<FirstBreak> first_break(const Model& model, const State& before, const State& after);

/// Breaks links at the state's own time. Before that all rigid links answer the kick that velocities may
/// still hold (State::unanswered_kick), these for the last time.
void break_at_once(const Model& model, State& state, const std::vector<Index>& links);

/// Takes from velocities what whole rigid links, at the state's tensions, take of the kick they have not
/// answered yet: the velocities that belong to the state's positions.
void answer_kick(const Model& model, const State& state, Vectors& velocity);

}  // namespace taut
