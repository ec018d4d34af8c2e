#include "render_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include "base/failure.h"
#include "frames/colouring.h"
#include "frames/exact_shape.h"
#include "frames/film_frames.h"
#include "frames/frame_selection.h"
#include "frames/hidden_folder.h"
#include "frames/metrics.h"
#include "frames/panels.h"
#include "output/film.h"
#include "thread_budget.h"
#include "wanted_manifest.h"

namespace taut {
namespace {

namespace fs = std::filesystem;

// What the manifest beside a film without a folder knows, where that was made from the same inputs.
void take_over_films(const fs::path& film, Manifest& manifest) {
  const std::optional<Manifest> there = read_manifest(film_manifest_file(film));
  if (!there || there->inputs != manifest.inputs) return;
  manifest.films = there->films;
  manifest.metrics = there->metrics;
}

// The folder that films and metrics stand beside.
fs::path folder_beside(const RenderRequest& request) {
  return request.folder ? *request.folder : request.film->parent_path();
}

void settle_film(RenderJob& job, const RenderRequest& request, const Manifest& wanted) {
  job.film = side_file(&Manifest::films, *request.film, folder_beside(request), job.frames);
  if (is_film_stream(*request.film)) return;
  if (!request.folder) {
    job.film_manifest = wanted;
    job.film_manifest->kind = "film";
    if (!request.overwrite) take_over_films(*request.film, *job.film_manifest);
  }
  std::error_code error;
  if (fs::is_directory(*request.film, error))
    throw BadRequest(fmt::format("{} is a folder, not a name for a film", request.film->string()));
  job.film.make = request.overwrite || !is_made(job.film, job.known());
}

// After the film, which may have the only manifest.
void settle_metrics(RenderJob& job, const RenderRequest& request) {
  if (!request.metrics) return;
  check_metrics_file(*request.metrics);
  job.metrics = side_file(&Manifest::metrics, *request.metrics, folder_beside(request), job.frames);
  job.metrics.make = request.overwrite || !is_made(job.metrics, job.known());
}

// A film alone has its frames in a hidden folder until it is whole, so that a run that is killed goes on.
// Where nothing is simulated, or all of it has to be seen, there is nothing to go on from; into a pipe a film
// goes as it grows.
void hide_frames(RenderJob& job, const RenderRequest& request, const Manifest& wanted) {
  if (request.folder || !job.film.make || is_film_stream(*request.film) || request.motion || request.watch)
    return;
  const fs::path folder = hidden_folder(*request.film, "frames");
  job.hides_frames = true;
  job.hidden = std::make_unique<UselessGoesAway>(folder);
  try {
    job.folder.emplace(folder, wanted, request.shard, request.overwrite);
  } catch (const OutputConflict&) {
    job.folder.emplace(folder, wanted, request.shard, true);  // nobody but an earlier run has made it
  }
}

// Where to go on. Whoever watches the run wants to see all of it.
void settle_resume(RenderJob& job, const RenderRequest& request) {
  if (!job.folder || request.watch) return;
  job.only_film = job.film.make && !job.metrics.make &&
                  std::ranges::all_of(job.frames, [&](int frame) { return job.folder->has(frame); });
  if (!job.only_film && !request.motion) job.resume = job.folder->checkpoint(job.frames);
  if (job.resume && job.metrics.make && job.resume->metrics.empty()) job.resume.reset();
}

void require_moments(const Scene& scene, const RenderRequest& request, const std::vector<int>& frames) {
  for (const int frame : frames) {
    const double time = shown_time(scene, frame, request.rate);
    if (request.motion->find(time) == nullptr)
      throw BadRequest(
          fmt::format("the motion has no moment for frame {}, t = {:.6g} s: it is not done yet, or was "
                      "simulated for another number of frames a second",
                      frame, time));
  }
}

std::vector<int> frames_of(const RenderRequest& request, int count) {
  const std::vector<int> all =
      request.selection ? select_frames(*request.selection, count) : all_frames(count);
  const auto [first, end] = request.shard.piece(all.size());
  return {all.begin() + static_cast<std::ptrdiff_t>(first), all.begin() + static_cast<std::ptrdiff_t>(end)};
}

}  // namespace

void remove_hidden_frames(RenderJob& job) {
  if (job.hides_frames)
    job.folder->remove();
  else
    FrameFolder(hidden_folder(job.film.file, "frames"), {}, {}, true).remove();
}

FilmSettings film_settings(const RenderRequest& request, std::size_t panels, const std::vector<int>& frames) {
  return {*request.film,
          sheet_size(request.picture.render.size, panels),
          rate_of_selection(frames, request.rate),
          request.picture.render.transparent,
          thread_budget(request.cores).film,
          request.picture.render.bits};
}

bool RenderJob::complete() const {
  return !film.make && !metrics.make &&
         (!folder || hides_frames ||
          std::ranges::all_of(frames, [&](int frame) { return folder->has(frame); }));
}

std::vector<int> RenderJob::done_before() const {
  std::vector<int> done;
  for (const int frame : frames)
    if (only_film || (resume && frame < resume->frame)) done.push_back(frame);
  return done;
}

std::size_t RenderJob::to_draw() const {
  if (film.make) return frames.size() - done_before().size();
  return static_cast<std::size_t>(
      std::ranges::count_if(frames, [&](int frame) { return folder && !folder->has(frame); }));
}

const Manifest* RenderJob::known() const {
  if (folder && !hides_frames) return &folder->manifest();
  return film_manifest ? &*film_manifest : nullptr;
}

Book RenderJob::book() {
  if (folder && !hides_frames) return folder->book();
  if (!film_manifest) return {};
  return {&*film_manifest, [this] { write_manifest(film_manifest_file(film.file), *film_manifest); }};
}

RenderJob make_render_job(std::span<const Scene> scenes, const RenderRequest& request) {
  if (!request.folder && !request.film)
    throw BadRequest("without frames and without a film there is nothing to make; --film FILE asks for one");
  // Of several methods those that don't know what their panels are to be coloured by stay plain.
  if (std::ranges::none_of(scenes, [](const Scene& scene) { return colour_problem(scene).empty(); }))
    require_colours(scenes.front());
  require_exact(scenes.front());
  check_size(request.picture.render.size);
  check_size(sheet_size(request.picture.render.size, scenes.size()));
  RenderJob job;
  const int count = film_frame_count(scenes.front(), request.rate);
  job.frames = frames_of(request, count);
  if (request.film && !request.shard.all())
    throw BadRequest(
        "a film needs the frames of all shards: taut merge FOLDER --film FILE makes it when they are there");
  if (request.film) check_film_settings(film_settings(request, scenes.size(), job.frames));

  if (request.motion) require_moments(scenes.front(), request, job.frames);
  const Manifest wanted = frames_manifest(scenes, request);
  job.inputs = wanted.inputs;
  if (request.folder) job.folder.emplace(*request.folder, wanted, request.shard, request.overwrite);
  if (request.film) settle_film(job, request, wanted);
  settle_metrics(job, request);
  hide_frames(job, request, wanted);
  settle_resume(job, request);
  if (job.film.make) require_film_encoder();
  return job;
}

}  // namespace taut
