#pragma once

#include <string>
#include <vector>

#include "base/stop.h"
#include "scene/scene.h"

namespace taut {

/// A part of the model, and what it costs.
struct PartCost {
  std::string name, extent;  ///< extent is empty for what the scene leaves out
  double seconds = 0.0;      ///< a step, measured: with it, less without it; 0 for what is left out
};

/// What a scene models and what it leaves out.
struct Explanation {
  std::size_t masses = 0, pins = 0, links = 0, links_between_pins = 0;
  bool in_plane = false;        ///< all motion lies in a plane z = constant
  double step_seconds = 0.0;    ///< a step of the scene's method here, measured over the scene's first steps
  std::vector<PartCost> parts;  ///< every part there is
};

/// Times the scene's first steps, and the same steps without each of its parts: the least of several runs,
/// taken in turns. Throws BadRequest where the method can't do the scene, RunFailure where a step can't be
/// solved.
Explanation explain(const Scene& scene, const StopTest& stop = {});

}  // namespace taut
