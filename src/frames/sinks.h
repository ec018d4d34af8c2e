#pragma once

#include <map>

#include "frame_sink.h"
#include "frames/frame_folder.h"
#include "output/film.h"
#include "stage_clock.h"

namespace taut {

/// Frames as files. Wants those that are not there yet.
class FolderSink final : public FrameSink {
 public:
  FolderSink(FrameFolder& folder, StageClock& clock)
      : folder_(folder), clock_(clock), there_(folder.manifest().frames) {}

  bool wants(int frame, const std::string& state_hash) const override {
    const auto found = there_.find(frame);
    return found == there_.end() || found->second != state_hash;
  }
  bool wants_png() const override { return true; }
  void take(const FinishedFrame& frame, const StopTest& /*stop*/) override {
    clock_.time(Stage::write, [&] { folder_.write(frame.frame, frame.png, frame.state_hash); });
  }

 private:
  FrameFolder& folder_;
  StageClock& clock_;
  // A copy: the folder's own list grows in another thread than the one that asks.
  const std::map<int, std::string> there_;
};

/// Frames as a film. Wants them all.
class FilmSink final : public FrameSink {
 public:
  FilmSink(Film& film, StageClock& clock) : film_(film), clock_(clock) {}

  bool wants(int /*frame*/, const std::string& /*state_hash*/) const override { return true; }
  bool wants_png() const override { return false; }
  void take(const FinishedFrame& frame, const StopTest& stop) override {
    clock_.time(Stage::feed, [&] { film_.add(frame.image, stop); });
  }

 private:
  Film& film_;
  StageClock& clock_;
};

}  // namespace taut
