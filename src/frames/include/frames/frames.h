#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/frame_rate.h"
#include "frames/painter.h"
#include "frames/simulation.h"
#include "frames/stage_times.h"
#include "host/progress.h"
#include "host/shard.h"
#include "output/motion_file.h"
#include "scene/scene.h"

namespace taut {

/// What is to be rendered of a scene, and where to. The picture's size is that of one panel (panels.h).
struct RenderRequest {
  std::optional<std::filesystem::path> folder;  ///< for frames and their manifest; absent: no frames
  std::optional<std::filesystem::path> film;
  std::optional<std::string> selection;  ///< such as "1-100:2,150"; absent: every frame
  FrameRate rate;
  PictureSettings picture;
  bool overwrite = false;
  Execution execution = {};  ///< of the simulation
  int cores = 1;             ///< that all stages have together
  /// Shown every state of the run as it is simulated (of several, of the first); may be empty.
  std::function<void(const State&)> watch;
  /// Told before the run how many frames are to be drawn and how long that takes (s), about; may be empty.
  std::function<void(std::size_t, double)> foretell;
  std::optional<std::filesystem::path> metrics;  ///< what is measured of every frame, see metrics.h
  std::string plan;  ///< why the scene is run as it is, for the manifest; may be empty
  Shard shard;       ///< which part of the frames
  /// Played instead of simulating; of the scene's physics. Null: the scene is simulated.
  std::shared_ptr<const MotionReader> motion;
};

/// How the run behind one panel ended.
struct PanelOutcome {
  RunMeasures measures;  ///< of the last frame's state
  std::string failure;   ///< why that came early; empty when it didn't
};

/// What came of it.
struct RenderOutcome {
  Size size;              ///< of a picture, all panels together
  std::size_t asked = 0;  ///< frames
  std::size_t shown = 0;  ///< of those, the ones that are there now or went into the film
  std::size_t kept = 0;   ///< of those, the ones that were there before
  std::size_t drawn = 0;  ///< frames
  bool film_kept = false;
  int resumed_at = 0;    ///< the frame that the simulation went on at, from a checkpoint; 0: it began anew
  bool stopped = false;  ///< told to stop before the end; no film then
  bool goes_on = false;  ///< running the same again goes on from what there is
  double seconds = 0.0;
  std::string inputs;                ///< hash of everything that decides what the frames look like
  std::string last_state_hash;       ///< of the last frame's state; empty when nothing was simulated
  std::vector<PanelOutcome> panels;  ///< one a panel; empty when nothing was simulated
  StageSeconds stages;               ///< empty when nothing was simulated
  std::string drawn_by;  ///< what drew (GlContext::description()); empty when nothing was simulated
  /// What is odd about the pictures, see picture_notes.h.
  std::optional<std::string> note;
};

/// Renders a scene to frames and a film, run in one way, or in several ways side by side: `scenes` differ in
/// method and settings alone. What they leave open of their view is settled in them (settled_view.h). Where
/// one of several fails, its picture stays as it was, and says so. Every stage (stage_times.h) runs in a
/// thread of its own, with a few frames between them, so that memory doesn't grow with the film's length.
/// What is there already from the same inputs is kept. Throws BadRequest and OutputConflict before anything
/// is written, RunFailure for everything later (frames made until then stay, a film does not).
RenderOutcome render_frames(std::span<Scene> scenes, const RenderRequest& request, Progress& progress,
                            const StopTest& stop = {});

}  // namespace taut
