#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "frames/frame_folder.h"
#include "frames/frames.h"
#include "frames/hidden_folder.h"
#include "output/film.h"
#include "side_files.h"

namespace taut {

/// A request, checked against the scene and against what is on disk.
struct RenderJob {
  std::vector<int> frames;  ///< rising
  std::string inputs;       ///< hash of everything that decides what the frames look like
  std::optional<FrameFolder> folder;
  /// Frames that lie there only until the film is whole: for one that is asked for alone.
  bool hides_frames = false;
  std::unique_ptr<UselessGoesAway> hidden;  ///< where there are such
  SideFile film, metrics;
  std::optional<Manifest> film_manifest;  ///< stands beside a film that has no folder of frames
  std::optional<Checkpoint> resume;       ///< what the simulation goes on from, where it doesn't begin anew
  bool only_film = false;                 ///< every frame is there: the film can be made from their files

  /// The frames that needn't be simulated: a film takes them from their files.
  std::vector<int> done_before() const;
  /// How many frames are to be drawn: a film alone needs all, a folder those that it lacks.
  std::size_t to_draw() const;
  /// What knows of films and metrics on disk: the manifest of book(); null where there is none.
  const Manifest* known() const;
  /// Where they are entered: the folder's manifest or the film's own.
  Book book();

  /// Whether every frame that is asked for is there, and the film and the metrics too.
  bool complete() const;
};

/// Takes away what this run or one before has hidden beside a job's film, which is whole now.
void remove_hidden_frames(RenderJob& job);

/// The film that a request asks for, of so many panels and those frames; only for one that asks.
FilmSettings film_settings(const RenderRequest& request, std::size_t panels, const std::vector<int>& frames);

/// Checks a request. Writes nothing. Throws BadRequest, OutputConflict, and RunFailure where the program for
/// films is missing.
RenderJob make_render_job(std::span<const Scene> scenes, const RenderRequest& request);

}  // namespace taut
