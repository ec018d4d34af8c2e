#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "frames/frame_folder.h"
#include "frames/frames.h"
#include "output/film.h"

namespace taut {

/// A request, checked against the scene and against what is on disk.
struct RenderJob {
  std::vector<int> frames;  ///< rising
  std::string inputs;       ///< hash of everything that decides what the frames look like
  std::optional<FrameFolder> folder;
  bool make_film = false;  ///< one is asked for and not there yet
  FilmRecord film;         ///< how the film will stand in the manifest

  /// Whether every frame that is asked for is there, and the film too.
  bool complete() const;
};

/// The film that a request asks for, of so many panels; only for one that asks.
FilmSettings film_settings(const RenderRequest& request, std::size_t panels);

/// Checks a request. Writes nothing. Throws BadRequest, OutputConflict, and RunFailure where the program for
/// films is missing.
RenderJob make_render_job(std::span<const Scene> scenes, const RenderRequest& request);

}  // namespace taut
