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
  std::filesystem::path film_file;
  bool make_metrics = false;  ///< they are asked for and not there yet
  FilmRecord metrics;         ///< how they will stand in the manifest
  std::filesystem::path metrics_file;
  std::optional<Manifest> film_manifest;  ///< stands beside a film that has no folder of frames
  std::optional<Checkpoint> resume;       ///< what the simulation goes on from, where it doesn't begin anew
  bool only_film = false;                 ///< every frame is there: the film can be made from their files

  /// The frames that needn't be simulated: a film takes them from their files.
  std::vector<int> done_before() const;
  /// What knows of films and metrics on disk: the folder's manifest or the film's own; null where there is
  /// none.
  const Manifest* known() const;
  /// Remembers a film's (or the metrics') bytes and hash, from the file under its temporary name, in the
  /// manifest on disk beside what stood there. Throws RunFailure.
  void record(FilmRecord& made, FilmList list, const std::filesystem::path& temporary);
  /// The same when the file has got its name: forgets others of that name.
  void keep(const FilmRecord& made, FilmList list);

  /// Whether every frame that is asked for is there, and the film and the metrics too.
  bool complete() const;
};

/// The film that a request asks for, of so many panels and those frames; only for one that asks.
FilmSettings film_settings(const RenderRequest& request, std::size_t panels, const std::vector<int>& frames);

/// Checks a request. Writes nothing. Throws BadRequest, OutputConflict, and RunFailure where the program for
/// films is missing.
RenderJob make_render_job(std::span<const Scene> scenes, const RenderRequest& request);

}  // namespace taut
