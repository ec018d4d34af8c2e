#include "render_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include "base/failure.h"
#include "base/hash.h"
#include "frames/colouring.h"
#include "frames/exact_shape.h"
#include "frames/film_time.h"
#include "frames/frame_selection.h"
#include "frames/panels.h"
#include "host/build_info.h"
#include "output/film.h"
#include "thread_budget.h"

namespace taut {
namespace {

namespace fs = std::filesystem;

// The method's name and settings; of several, all names, and before each setting the number of its panel.
void describe_methods(std::span<const Scene> scenes, Manifest& manifest) {
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const Settings& settings = scenes[i].settings;
    manifest.method += (i > 0 ? ", " : "") + settings.method;
    for (const auto& [name, value] : settings.values)
      manifest.settings[scenes.size() == 1 ? name : fmt::format("{}.{}", i + 1, name)] = value;
  }
}

Manifest wanted_manifest(std::span<const Scene> scenes, const RenderRequest& request) {
  Manifest manifest;
  manifest.scene = scenes.front().name;
  manifest.scene_toml = resolved_toml(scenes.front());
  describe_methods(scenes, manifest);
  manifest.size = sheet_size(request.picture.render.size, scenes.size());
  manifest.frames_per_second = request.rate.value();
  manifest.picture = settings_text(request.picture);
  manifest.plan = request.plan;
  manifest.build = build_info();
  // Everything else in the manifest is a part of one of these, or follows from them.
  Hash hash;
  for (const std::string& part : {manifest.scene_toml, manifest.picture, manifest.build,
                                  fmt::format("{} frames/s", manifest.frames_per_second)})
    hash.add(part).add("\n");
  for (const Scene& other : scenes.subspan(1)) hash.add(resolved_toml(other)).add("\n");
  manifest.inputs = hash.hex();
  return manifest;
}

// How a film is named in the manifest: from its folder, so that both can be moved together.
std::string name_in_manifest(const RenderRequest& request) {
  if (!request.folder) return request.film->string();
  std::error_code error;
  const fs::path relative = fs::proximate(*request.film, *request.folder, error);
  return error ? request.film->string() : relative.string();
}

// What the manifest says of the film, where that film is still the one on disk.
const FilmRecord* film_on_disk(const RenderJob& job, const fs::path& file) {
  if (!job.folder) return nullptr;
  const auto& films = job.folder->manifest().films;
  const auto found = std::ranges::find(films, job.film.file, &FilmRecord::file);
  std::error_code error;
  return found != films.end() && fs::file_size(file, error) == found->bytes && !error ? &*found : nullptr;
}

void settle_film(RenderJob& job, const RenderRequest& request) {
  job.film = {name_in_manifest(request), selection_text(job.frames), 0};
  job.make_film = true;
  if (is_film_stream(*request.film)) return;
  std::error_code error;
  if (fs::is_directory(*request.film, error))
    throw BadRequest(fmt::format("{} is a folder, not a name for a film", request.film->string()));
  if (request.overwrite || !fs::exists(*request.film, error)) return;
  const FilmRecord* there = film_on_disk(job, *request.film);
  if (there == nullptr)
    throw OutputConflict(
        fmt::format("{} exists, and nothing here says that it was made from the same inputs; "
                    "--overwrite replaces it",
                    request.film->string()));
  job.make_film = there->frames != job.film.frames;
}

}  // namespace

FilmSettings film_settings(const RenderRequest& request, std::size_t panels) {
  return {*request.film, sheet_size(request.picture.render.size, panels), request.rate,
          request.picture.render.transparent, thread_budget(request.cores).film};
}

bool RenderJob::complete() const {
  return !make_film && folder && std::ranges::all_of(frames, [&](int frame) { return folder->has(frame); });
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
  const int count = frame_count(film_duration(scenes.front().look, scenes.front().duration), request.rate);
  job.frames = request.selection ? select_frames(*request.selection, count) : all_frames(count);
  if (request.film) check_film_settings(film_settings(request, scenes.size()));

  const Manifest wanted = wanted_manifest(scenes, request);
  job.inputs = wanted.inputs;
  if (request.folder) job.folder.emplace(*request.folder, wanted, request.overwrite);
  if (request.film) settle_film(job, request);
  if (job.make_film) require_film_encoder();
  return job;
}

}  // namespace taut
