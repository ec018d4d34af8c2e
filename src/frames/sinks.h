#pragma once

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
  /// `metrics` go into checkpoints; null where nothing is measured.
  FolderSink(FrameFolder& folder, CheckpointClock& checkpoints, StageClock& clock,
             const MetricsRecorder* metrics)
      : folder_(folder),
        checkpoints_(checkpoints),
        clock_(clock),
        metrics_(metrics),
        there_(folder.manifest().frames) {}

  void begin(const StopTest& /*stop*/) override {}
  bool wants(int frame, const std::string& state_hash) const override {
    const auto found = there_.find(frame);
    return found == there_.end() || found->second.state != state_hash;
  }
  bool wants_file() const override { return true; }
  void take(const FinishedFrame& frame, const StopTest& stop) override;

 private:
  void keep(Checkpoint checkpoint);

  FrameFolder& folder_;
  CheckpointClock& checkpoints_;
  StageClock& clock_;
  const MetricsRecorder* metrics_;
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
