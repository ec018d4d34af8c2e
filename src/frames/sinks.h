#pragma once

#include <atomic>
#include <map>
#include <vector>

#include "film_making.h"
#include "frame_sink.h"
#include "frames/frame_folder.h"
#include "metrics_recorder.h"
#include "output/film.h"
#include "stage_clock.h"

namespace taut {

/// Frames as files. Wants those that are not there yet.
class FolderSink final : public FrameSink {
 public:
  /// `metrics` go into checkpoints; null where nothing is measured. `only_help`: nobody needs the frames but
  /// a run that goes on; where there is no room for them they go.
  FolderSink(FrameFolder& folder, CheckpointClock& checkpoints, StageClock& clock,
             const MetricsRecorder* metrics, bool only_help)
      : folder_(folder),
        checkpoints_(checkpoints),
        clock_(clock),
        metrics_(metrics),
        only_help_(only_help),
        there_(folder.manifest().frames) {}

  void begin(const StopTest& /*stop*/) override {}
  bool wants(int frame, const std::string& state_hash) const override {
    if (gone_) return false;
    const auto found = there_.find(frame);
    return found == there_.end() || found->second.state != state_hash;
  }
  bool wants_file() const override { return true; }
  void take(const FinishedFrame& frame, const StopTest& stop) override;

 private:
  void keep(const Checkpoint& checkpoint);
  void write(const FinishedFrame& frame);

  FrameFolder& folder_;
  CheckpointClock& checkpoints_;
  StageClock& clock_;
  const MetricsRecorder* metrics_;
  const bool only_help_;
  std::atomic<bool> gone_ = false;
  // A copy: the folder's own list grows in another thread than the one that asks.
  const std::map<int, FrameRecord> there_;
};

/// Frames as a film. Wants them all, but for those that it takes from their files before the first.
class FilmSink final : public FrameSink {
 public:
  /// `done`: the frames whose files are in the folder; the folder may be null where there are none.
  FilmSink(Film& film, const FrameFolder* folder, std::vector<int> done, StageClock& clock)
      : film_(film), folder_(folder), done_(std::move(done)), clock_(clock) {}

  void begin(const StopTest& stop) override {
    if (folder_ != nullptr) clock_.time(Stage::feed, [&] { add_from_files(film_, *folder_, done_, stop); });
  }
  bool wants(int /*frame*/, const std::string& /*state_hash*/) const override { return true; }
  bool wants_file() const override { return false; }
  void take(const FinishedFrame& frame, const StopTest& stop) override {
    clock_.time(
        Stage::feed, [&] { film_.add(frame.image, stop); }, frame.frame);
  }

 private:
  Film& film_;
  const FrameFolder* folder_;
  const std::vector<int> done_;
  StageClock& clock_;
};

}  // namespace taut
