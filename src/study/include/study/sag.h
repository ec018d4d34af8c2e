#pragma once

#include <functional>
#include <vector>

#include "frames/simulation.h"
#include "measure/rest_shape.h"
#include "scene/scene.h"

namespace taut {

/// One rest shape of a row, and how far it is from the exact one.
struct SagEntry {
  int passes = 0;
  bool growing = false;  ///< euler with kept velocities, which never comes to rest: a moment of it
  RestShape shape;
  double sag = 0.0;             ///< m
  double sag_error = 0.0;       ///< m, sag less the exact sag
  double position_error = 0.0;  ///< m, of the mass that is farthest from where it should be
  double largest_strain = 0.0;
};

/// The seed's simulated weight: where a scene comes to rest for a row of passes, beside the exact shape.
struct SagStudy {
  Settings settings;  ///< of the row, but for the passes
  RestShape exact;
  double exact_sag = 0.0;  ///< m
  std::vector<SagEntry> entries;
};

/// Settles a scene with its method, which must have passes, for every number of them, and exactly. With euler
/// velocities are derived; one entry more shows the text's kept ones at the scene's end. Shapes are kept in
/// the cache (reference_folder()): asked for again, they are only read. `done` hears of every entry. Throws
/// BadRequest for a method without passes or a scene that has no rest, RunFailure where a step can't be
/// solved, Interrupted when told to stop on the way.
SagStudy study_sag(const Scene& scene, const std::vector<int>& passes, const std::function<void(int)>& done,
                   const StopTest& stop);

}  // namespace taut
