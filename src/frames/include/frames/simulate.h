#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "base/frame_rate.h"
#include "base/stop.h"
#include "frames/simulation.h"
#include "host/progress.h"
#include "output/manifest.h"
#include "output/motion_file.h"
#include "scene/scene.h"

namespace taut {

/// What is to be simulated without drawing it, and where to.
struct MotionRequest {
  std::filesystem::path folder;
  FrameRate rate;
  std::optional<std::filesystem::path> metrics{};  ///< what is measured of every moment, see metrics.h
  bool overwrite = false;
  Execution execution = {};
  std::string plan;  ///< why the scene is run as it is, for the manifest; may be empty
};

/// What came of it.
struct MotionOutcome {
  std::size_t asked = 0;  ///< moments, one a frame
  std::size_t there = 0;  ///< of those, now
  std::size_t kept = 0;   ///< of those, before
  int resumed_at = 0;     ///< the frame that the run went on at, from a checkpoint; 0: it began anew
  bool stopped = false;   ///< told to stop before the end
  double seconds = 0.0;
  std::uintmax_t bytes = 0;  ///< of the file of motion
  std::string inputs;        ///< hash of everything that decides the motion
  std::string last_state_hash;
  std::optional<RunMeasures> measures;  ///< of the last moment, where anything was simulated
};

/// Simulates a scene and keeps what it looks like at the time of every frame, in FOLDER/motion.bin beside a
/// manifest. What is there already from the same inputs is kept; a run that was stopped goes on from its last
/// checkpoint. Throws BadRequest and OutputConflict before anything is written, RunFailure for everything
/// later (moments made until then stay).
MotionOutcome simulate_motion(const Scene& scene, const MotionRequest& request, Progress& progress,
                              const StopTest& stop = {});

/// A motion in a folder, and its manifest.
struct StoredMotion {
  Manifest manifest;
  std::shared_ptr<const MotionReader> reader;
};

/// Opens a folder that simulate_motion() made. Throws BadRequest where it is none.
StoredMotion open_motion(const std::filesystem::path& folder);

/// Throws BadRequest where a scene doesn't move as in a stored motion.
void require_same_motion(const Scene& scene, const StoredMotion& motion);

}  // namespace taut
