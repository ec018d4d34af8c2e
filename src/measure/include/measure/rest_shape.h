#pragma once

#include <functional>
#include <string>

#include "methods/method.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// How long and how calm a scene must be to count as at rest.
struct Settling {
  double least_drag = 2.0;      ///< 1/s, what a scene with less is given
  double most_time = 60.0;      ///< s
  double window = 0.5;          ///< s over which motion is looked at
  double most_movement = 1e-6;  ///< of the scene's size (scene_size()), what no mass may move by in a window
};

/// Where a scene has come to rest.
struct RestShape {
  State state;
  double largest_movement = 0.0;  ///< m, of any mass within the last window
  bool at_rest = false;           ///< whether that was little enough
  std::string how;                ///< what it was found with, for people
};

/// The time (s) from which on nothing prescribed changes in a scene: the end of its pins' paths and loads'
/// ramps. Infinity for pins that swing for ever.
double last_change(const Model& model);

/// Simulates from a start, with at least the settling's drag, until no mass moves any more after the last
/// change, or until told to stop: then it is not at rest. Throws BadRequest where something never stops
/// changing, RunFailure, in words, where a step can't be solved.
RestShape settle(const Model& model, const State& start, const Settings& settings, const Settling& settling,
                 const std::function<bool()>& stop = {});

/// The rest shape without a method's error: by the balance of forces where the scene is one chain of equal
/// masses and links in a vertical plane, pinned at one end or both (exact.h); elsewhere by settling with
/// newton, whose rest shape is the balance of forces at any step.
RestShape exact_rest_shape(const Model& model, const State& start, const Settling& settling,
                           const std::function<bool()>& stop = {});

}  // namespace taut
