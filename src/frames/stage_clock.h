#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <mutex>
#include <string_view>
#include <vector>

#include "base/processor_time.h"
#include "frames/stage_times.h"

namespace taut {

enum class Stage { simulate, shape, draw, rasterise, flatten, compress, write, feed, encode };

/// Adds up what stages take, from any thread.
class StageClock {
 public:
  /// Also remembers what each frame takes.
  void keep_frames() { keeps_frames_ = true; }

  /// Does a piece of work of a stage, for one frame or (0) for none in particular.
  template <typename Work>
  decltype(auto) time(Stage stage, const Work& work, int frame = 0) {
    const Running running(*this, stage, frame);
    return work();
  }
  void add(Stage stage, double seconds, int frame = 0) {
    seconds_.at(static_cast<std::size_t>(stage)) += seconds;
    if (!keeps_frames_ || frame == 0) return;
    const auto place = std::ranges::find(frame_stages, stage);
    if (place == frame_stages.end()) return;
    const std::lock_guard lock(mutex_);
    frames_[frame].at(static_cast<std::size_t>(place - frame_stages.begin())) += seconds;
  }

  StageSeconds seconds() const {
    StageSeconds all;
    for (std::size_t i = 0; i < names.size(); ++i) all.push_back({names[i], seconds_[i]});
    return all;
  }

  /// What a frame took in each of frame_stages, where that was to be remembered; empty where it took nothing.
  std::vector<double> seconds_of(int frame) const {
    const std::lock_guard lock(mutex_);
    const auto found = frames_.find(frame);
    return found == frames_.end() ? std::vector<double>()
                                  : std::vector<double>(found->second.begin(), found->second.end());
  }

  /// The stages that work on one frame at a time.
  static constexpr std::array<Stage, 7> frame_stages{
      Stage::simulate, Stage::shape, Stage::draw, Stage::flatten, Stage::compress, Stage::write, Stage::feed};
  static std::vector<std::string_view> frame_stage_names() {
    std::vector<std::string_view> all;
    all.reserve(frame_stages.size());
    for (const Stage stage : frame_stages) all.push_back(names.at(static_cast<std::size_t>(stage)));
    return all;
  }

 private:
  // Counts from its making to its end, whichever way that comes.
  class Running {
   public:
    Running(StageClock& clock, Stage stage, int frame) : clock_(clock), stage_(stage), frame_(frame) {}
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    ~Running() { clock_.add(stage_, processor_seconds() - start_, frame_); }

   private:
    StageClock& clock_;
    Stage stage_;
    int frame_;
    double start_ = processor_seconds();
  };

  static constexpr std::array<std::string_view, 9> names{"simulate", "shape", "draw", "rasterise", "flatten",
                                                         "compress", "write", "feed", "encode"};
  std::array<std::atomic<double>, names.size()> seconds_{};
  bool keeps_frames_ = false;
  mutable std::mutex mutex_;
  std::map<int, std::array<double, frame_stages.size()>> frames_;
};

}  // namespace taut
