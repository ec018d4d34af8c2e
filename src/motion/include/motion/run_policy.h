#pragma once

#include "model/measures.h"

namespace taut {

/// What a run does about steps that fail, and when it counts as gone off. It applies to every run alike: what
/// is drawn, exported, judged and timed differs by nothing but this.
struct RunPolicy {
  /// How often in a row a step may be halved that a method of Capabilities::takes_steps_back can't solve; 0:
  /// never, and the first one ends the run.
  int most_halvings = 12;
  /// Whether a step of such a method fails, too, when it makes energy out of nothing (EnergyGuard). Only
  /// where there are rigid links.
  bool watch_energy = true;
  /// Whether a step of a method whose tension is of second order is cut where a hard stop on an angle is met
  /// within it, as it is where a link breaks: the impulse then comes at its moment, and motion beyond it is
  /// of second order, too.
  bool cut_at_stops = false;
  /// Energy of motion over what there can be (Run::energy_at_hand()) beyond which the run has diverged.
  double diverged_beyond = divergence;
};

/// For charts: halving a step would make several steps of one. What they judge and time is otherwise what is
/// drawn.
inline constexpr RunPolicy chart_policy{.most_halvings = 0};

/// For maps of where methods fail: the method as it is, whatever its steps do to the energy.
inline constexpr RunPolicy unguarded{.most_halvings = 0, .watch_energy = false};

}  // namespace taut
