#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "frames/simulation.h"
#include "host/shard.h"
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

/// What is to be settled, and where shapes are kept.
struct SagRequest {
  std::vector<int> passes;
  std::filesystem::path folder;  ///< its shapes.jsonl keeps every shape as it is found
  Shard shard;                   ///< which part of the passes
};

/// Throws BadRequest for a scene whose method makes no passes.
void check_sag(const Scene& scene);

/// Settles a scene with its method, which must have passes, for every number of them, and exactly. With euler
/// velocities are derived; one entry more shows the text's kept ones at the scene's end. Shapes are kept in
/// the request's folder and in the cache (reference_folder()): asked for again, they are only read. `done`
/// hears of every entry. Throws BadRequest for a method without passes or a scene that has no rest,
/// RunFailure where a step can't be solved, Interrupted when told to stop on the way.
SagStudy study_sag(const Scene& scene, const SagRequest& request, const std::function<void(int)>& done,
                   const StopTest& stop);

}  // namespace taut
