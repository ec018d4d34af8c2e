#include "study/frame_speed.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "base/abrupt_end.h"
#include "frames/film_time.h"
#include "frames/frame_selection.h"
#include "frames/frames.h"
#include "host/progress.h"
#include "output/child_process.h"

namespace taut {
namespace {

namespace fs = std::filesystem;

// A folder that goes away with the object, or with the process.
class Scratch {
 public:
  Scratch() : folder_(fs::temp_directory_path() / fmt::format("taut-bench-{}", ::getpid())) {}
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::error_code error;
    fs::remove_all(folder_, error);
  }
  const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
  AtAbruptEnd goes_away_{[folder = folder_] {
    std::error_code error;
    fs::remove_all(folder, error);
  }};
};

RenderOutcome render_some(Scene scene, int frames, bool film, int cores, const StopTest& stop) {
  const Scratch scratch;
  RenderRequest request;
  request.picture.render = render_settings_for(Quality::standard);
  request.cores = cores;
  request.folder = scratch.folder();
  if (film) request.film = scratch.folder() / "film.mp4";
  request.selection = fmt::format(
      "1-{}", std::min(frames, frame_count(film_duration(scene.look, scene.duration), request.rate)));
  Progress quiet(stderr, ProgressStyle::none, "frames");
  const RenderOutcome outcome = render_frames({&scene, 1}, request, quiet, stop);
  if (outcome.stopped) stop_if_told(stop);
  return outcome;
}

}  // namespace

std::vector<FrameSpeed> measure_frames(std::span<const Scene> scenes, int frames, int cores,
                                       const std::function<void()>& done, const StopTest& stop) {
  const bool film = find_program("ffmpeg").has_value();
  std::vector<FrameSpeed> speeds;
  for (const Scene& scene : scenes) {
    FrameSpeed& speed = speeds.emplace_back();
    speed.scene = scene.name;
    speed.first_file = render_some(scene, 1, false, cores, stop).seconds;
    const RenderOutcome outcome = render_some(scene, frames, film, cores, stop);
    speed.size = outcome.size;
    speed.frames = outcome.shown;
    speed.seconds = outcome.seconds;
    speed.stages = outcome.stages;
    done();
  }
  return speeds;
}

}  // namespace taut
