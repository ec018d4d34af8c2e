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
  bool motion = true;    ///< the whole motion, where there is one to be had; else only sag, energy and strain
  double finest = 1e-8;  ///< of the scene's size, to which a motion is certified where that can be done
  double most_seconds = 5.0;  ///< of one run, where two methods have to agree
};

/// What is true of a scene, as far into the horizon as it goes: its certified motion; where that ends early,
/// because something breaks, is touched or reaches a limit, and two methods agree on it for more than twice
/// as long, the motion they agree on; where there is neither, sag, energy and strain as two methods agree on
/// them. Kept in a folder as references are. All times are whole sixtieths of a second, so that steps of 60 ·
/// 2^n per second end on them.
Truth scene_truth(const Scene& scene, const TruthRequest& request,
                  const std::filesystem::path& folder = reference_folder());

}  // namespace taut
