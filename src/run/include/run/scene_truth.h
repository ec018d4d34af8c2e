#pragma once

#include <filesystem>
#include <optional>

#include "measure/truth.h"
#include "run/reference_cache.h"
#include "scene/scene.h"

namespace taut {

/// What is wanted of a truth.
struct TruthRequest {
  std::optional<double> horizon;  ///< s, at most the scene's duration; absent: that
  bool motion = true;             ///< the whole motion, where it can be certified; else only the end
  double most_seconds = 5.0;      ///< of one run, where two methods have to agree on the end
};

/// What is true of a scene: its certified motion, as far into the horizon as it goes, or, where there is
/// none, the end that two methods agree on. Kept in a folder as references are. All times are whole sixtieths
/// of a second, so that steps of 60 · 2^n per second end on them.
Truth scene_truth(const Scene& scene, const TruthRequest& request,
                  const std::filesystem::path& folder = reference_folder());

}  // namespace taut
