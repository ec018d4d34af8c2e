#include "film_making.h"

#include <fmt/format.h>

#include "base/failure.h"
#include "base/stopwatch.h"
#include "output/atomic_file.h"
#include "output/content_hash.h"
#include "output/frame_file.h"

namespace taut {

void begin_film(std::optional<Film>& film, const FilmSettings& settings) {
  if (settings.file.has_parent_path() && !is_film_stream(settings.file))
    make_folder(settings.file.parent_path());
  film.emplace(settings);
}

void add_from_files(Film& film, const FrameFolder& folder, std::span<const int> frames, const StopTest& stop,
                    const std::function<void(int)>& added) {
  int count = 0;
  for (const int frame : frames) {
    stop_if_told(stop);
    const std::filesystem::path file = folder.frame_file(frame);
    const std::optional<std::string> bytes = bytes_of_file(file);
    if (!bytes) throw RunFailure(fmt::format("{} has gone", file.string()));
    film.add(decode_frame(*bytes, folder.manifest().bits, file), stop);
    if (added) added(++count);
  }
}

void finish_film(Film& film, RenderJob& job, StageClock& clock, const StopTest& stop) {
  clock.add(Stage::encode, film.finish(stop));
  if (!is_film_stream(job.film.file)) leave(job.film, job.book(), film.file(), [&] { film.commit(); });
}

RenderOutcome film_from_files(const RenderRequest& request, std::size_t panels, RenderJob& job,
                              Progress& progress, const StopTest& stop) {
  const Stopwatch watch;
  RenderOutcome outcome;
  outcome.shown = outcome.kept = job.frames.size();
  StageClock clock;
  job.folder->begin();
  std::optional<Film> film;
  begin_film(film, film_settings(request, panels, job.frames));
  progress.start(static_cast<int>(job.frames.size()));
  try {
    add_from_files(*film, *job.folder, job.frames, stop, [&](int done) { progress.update(done); });
    finish_film(*film, job, clock, stop);
  } catch (const Interrupted&) {
    outcome.stopped = true;
  }
  progress.finish();
  outcome.seconds = watch.seconds();
  return outcome;
}

}  // namespace taut
