#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "base/stop.h"
#include "measure/truth.h"
#include "scene/scene.h"
#include "study/reference_cache.h"

namespace taut {

/// Links beyond which a scene is large: what takes seconds of a small one takes minutes of it.
inline constexpr std::size_t large_scene = 3000;

/// What is wanted of a truth.
struct TruthRequest {
  std::optional<double> horizon;  ///< s, at most the scene's duration; absent: that
  bool motion = true;  ///< the whole motion, where there is one to be had; else only sag, energy and strain
  /// The error that has to be judged, and none smaller; absent: as small as can be. The larger, the further
  /// the motion is known: past impacts, and into chaos.
  std::optional<double> judged;
  double loosest = 1e-5;          ///< of the scene's size: a motion is certified at least to this …
  double finest = 1e-10;          ///< … and where that can be done to this
  double certify_seconds = 10.0;  ///< of one run, predicted, where a motion is certified
  double agree_seconds = 5.0;     ///< of one run, predicted, where two methods have to agree
  StopTest stop = {};
};

/// What is true of a scene, as far into the horizon as it goes: its certified motion; where an event ends
/// that early (something breaks, is touched or reaches a limit) and two methods agree on the motion beyond
/// it, the motion they agree on; where there is neither, sag, energy and strain as two methods agree on them.
/// Kept in a folder as references are. All times are whole sixtieths of a second, so that steps of 60 · 2^n
/// per second end on them. Throws Interrupted.
Truth scene_truth(const Scene& scene, const TruthRequest& request,
                  const std::filesystem::path& folder = reference_folder());

}  // namespace taut
