#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/image.h"
#include "base/stop.h"
#include "frames/stage_times.h"
#include "scene/scene.h"

namespace taut {

/// How fast frames and film of a scene are made on this machine, start and end included.
struct FrameSpeed {
  std::string scene;
  Size size;
  std::size_t frames = 0;
  double seconds = 0.0;     ///< all of them
  double first_file = 0.0;  ///< s, from the start until there is one frame, made on its own
  StageSeconds stages;      ///< of all of them
};

/// Renders the first `frames` frames of each scene as `taut render` does, files and film, into a folder for
/// temporary files, which is gone afterwards. Without the program that encodes films only files. `done` hears
/// of every scene. Throws as render_frames() does, and Interrupted.
std::vector<FrameSpeed> measure_frames(std::span<const Scene> scenes, int frames, int cores,
                                       const std::function<void()>& done, const StopTest& stop);

}  // namespace taut
