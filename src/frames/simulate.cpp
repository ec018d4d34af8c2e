#include "frames/simulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "base/failure.h"
#include "base/stopwatch.h"
#include "frames/film_frames.h"
#include "frames/frame_folder.h"
#include "frames/frame_selection.h"
#include "frames/metrics.h"
#include "frames/motion_player.h"
#include "host/versions.h"
#include "output/atomic_file.h"
#include "side_files.h"
#include "wanted_manifest.h"

namespace taut {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view motion_file_name = "motion.bin";

FrameRecord record_of(const MotionRecord& record) {
  return {fmt::format("{:016x}", record.state_hash), fmt::format("{:016x}", record.content)};
}

// One run from a scene to a file of motion.
class MotionRun {
 public:
  MotionRun(const Scene& scene, const MotionRequest& request, FrameFolder& folder, MotionWriter& writer)
      : scene_(scene), request_(request), folder_(folder), writer_(writer) {}

  // False when told to stop.
  bool run(const std::vector<int>& frames, const std::optional<Checkpoint>& resume, Progress& progress,
           const StopTest& stop, MotionOutcome& outcome) {
    Simulation simulation = resume ? Simulation(scene_, resume->state, request_.execution)
                                   : Simulation(scene_, request_.execution);
    for (const int frame : frames) {
      if (resume && frame < resume->frame) continue;
      const double time = shown_time(scene_, frame, request_.rate);
      keep_checkpoint(simulation, frame, time, stop);
      const std::optional<State> state = simulation.at(time, stop);
      if (!state) return false;
      if (!writer_.records().contains(frame)) {
        writer_.add(frame, {*state, simulation.run().report(), simulation.run().work()});
        folder_.add(frame, record_of(writer_.records().at(frame)));
      }
      progress.update(static_cast<int>(writer_.records().size()));
      if (frame == frames.back()) outcome.measures = simulation.measures(*state);
    }
    return true;
  }

 private:
  void keep_checkpoint(Simulation& simulation, int frame, double time, const StopTest& stop) {
    if (!clock_.due()) return;
    const Stopwatch watch;
    const std::optional<SavedSimulation> saved = simulation.save_before(time, stop);
    if (!saved) return;
    writer_.sync();
    folder_.write(Checkpoint{frame, to_bytes(*saved)});
    clock_.begun(watch.seconds());
  }

  const Scene& scene_;
  const MotionRequest& request_;
  FrameFolder& folder_;
  MotionWriter& writer_;
  CheckpointClock clock_;
};

// The metrics that are asked for, if any. Throws OutputConflict where something else has their name.
SideFile wanted_metrics(const MotionRequest& request, const FrameFolder& folder,
                        const std::vector<int>& frames) {
  if (!request.metrics) return {};
  check_metrics_file(*request.metrics);
  SideFile metrics = side_file(&Manifest::metrics, *request.metrics, request.folder, frames);
  metrics.make = request.overwrite || !is_made(metrics, &folder.manifest());
  return metrics;
}

// What was measured of every moment, from the motion itself: nothing is simulated for it.
void write_metrics(const Scene& scene, const fs::path& motion, SideFile& metrics, FrameFolder& folder) {
  const MotionReader reader(motion);
  MotionPlayer player(scene, reader);
  std::vector<FrameMetrics> rows;
  std::vector<int> frames;
  rows.reserve(reader.records().size());
  frames.reserve(reader.records().size());
  for (const auto& [frame, record] : reader.records()) {
    player.at(record.time);
    frames.push_back(frame);
    rows.push_back(frame_metrics(scene, frame, player.measures()));
  }
  metrics.record.frames = selection_text(frames);
  leave_text(metrics, folder.book(), metrics_text(rows, {}, are_lines(metrics.file)));
}

}  // namespace

MotionOutcome simulate_motion(const Scene& scene, const MotionRequest& request, Progress& progress,
                              const StopTest& stop) {
  const Stopwatch watch;
  MotionOutcome outcome;
  const Manifest wanted = motion_manifest(scene, request.rate, request.plan);
  const std::vector<int> frames = all_frames(wanted.frame_count);
  outcome.asked = frames.size();
  outcome.inputs = wanted.inputs;
  FrameFolder folder(request.folder, wanted, {}, request.overwrite);
  SideFile metrics = wanted_metrics(request, folder, frames);
  Simulation(scene, request.execution);  // what a method refuses is said before anything is written
  folder.begin();
  const fs::path file = request.folder / motion_file_name;
  MotionWriter writer(file, wanted.inputs, request.overwrite);
  for (const auto& [frame, record] : writer.records()) folder.add(frame, record_of(record));
  outcome.kept = writer.records().size();
  if (outcome.kept < outcome.asked) {
    const std::optional<Checkpoint> resume = folder.checkpoint(frames);
    if (resume) outcome.resumed_at = resume->frame;
    progress.start(static_cast<int>(frames.size()));
    try {
      outcome.stopped =
          !MotionRun(scene, request, folder, writer).run(frames, resume, progress, stop, outcome);
    } catch (...) {
      folder.save();
      throw;
    }
    progress.finish();
  }
  if (metrics.make) write_metrics(scene, file, metrics, folder);
  folder.save();
  outcome.there = writer.records().size();
  if (outcome.there == outcome.asked) folder.remove_checkpoint();
  if (const auto last = writer.records().rbegin(); last != writer.records().rend())
    outcome.last_state_hash = record_of(last->second).state;
  std::error_code error;
  outcome.bytes = fs::file_size(file, error);
  outcome.seconds = watch.seconds();
  return outcome;
}

StoredMotion open_motion(const fs::path& folder) {
  const std::optional<Manifest> manifest = read_manifest(folder / "manifest.json");
  if (!manifest || manifest->kind != "motion")
    throw BadRequest(
        fmt::format("{} holds no motion; taut simulate SCENE -o FOLDER makes one", folder.string()));
  return {*manifest, std::make_shared<const MotionReader>(folder / motion_file_name)};
}

Scene scene_of_motion(const StoredMotion& motion, const std::string& folder,
                      const SceneOverrides& overrides) {
  const Manifest& manifest = motion.manifest;
  const std::string file =
      manifest.folder.empty() ? folder : (fs::path(manifest.folder) / manifest.scene).string();
  Scene scene = parse_scene(manifest.scene_toml, file, overrides);
  scene.name = manifest.scene;
  return scene;
}

void require_same_motion(const Scene& scene, const StoredMotion& motion) {
  const FrameRate rate = frame_rate_from(motion.manifest.frame_rate).value_or(FrameRate{});
  if (motion_inputs(scene, rate) == motion.reader->inputs()) return;
  throw BadRequest(
      fmt::format("the motion is of {} by {} with other physics, settings, duration or look.speed{}; only "
                  "camera and look can be changed when it is drawn",
                  motion.manifest.scene, motion.manifest.method,
                  motion.manifest.physics == physics_version() ? "" : ", or of a taut that moves otherwise"));
}

}  // namespace taut
