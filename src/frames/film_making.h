#pragma once

#include <functional>
#include <optional>
#include <span>

#include "frames/frame_folder.h"
#include "frames/frames.h"
#include "output/film.h"
#include "render_job.h"
#include "stage_clock.h"

namespace taut {

/// Starts a film, and makes the folder that it goes into. Throws as Film does.
void begin_film(std::optional<Film>& film, const FilmSettings& settings);

/// Adds frames from their files; `added`, where there is one, is told how many are in the film. Throws
/// RunFailure and Interrupted.
void add_from_files(Film& film, const FrameFolder& folder, std::span<const int> frames, const StopTest& stop,
                    const std::function<void(int)>& added = {});

/// Finishes a job's film, and gives it its name. Throws RunFailure and Interrupted.
void finish_film(Film& film, RenderJob& job, StageClock& clock, const StopTest& stop);

/// Makes the film of a job whose frames are all there: nothing is simulated or drawn.
RenderOutcome film_from_files(const RenderRequest& request, std::size_t panels, RenderJob& job,
                              Progress& progress, const StopTest& stop);

}  // namespace taut
