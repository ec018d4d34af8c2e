#pragma once

#include <array>
#include <atomic>

#include "base/processor_time.h"
#include "frames/stage_times.h"

namespace taut {

enum class Stage { simulate, shape, draw, rasterise, flatten, compress, write, feed, encode };

/// Adds up what stages take, from any thread.
class StageClock {
 public:
  /// Does a piece of work of a stage.
  template <typename Work>
  decltype(auto) time(Stage stage, const Work& work) {
    const Running running(*this, stage);
    return work();
  }
  void add(Stage stage, double seconds) { seconds_.at(static_cast<std::size_t>(stage)) += seconds; }

  StageSeconds seconds() const {
    StageSeconds all;
    for (std::size_t i = 0; i < names.size(); ++i) all.push_back({names[i], seconds_[i]});
    return all;
  }

 private:
  // Counts from its making to its end, whichever way that comes.
  class Running {
   public:
    Running(StageClock& clock, Stage stage) : clock_(clock), stage_(stage) {}
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    ~Running() { clock_.add(stage_, processor_seconds() - start_); }

   private:
    StageClock& clock_;
    Stage stage_;
    double start_ = processor_seconds();
  };

  static constexpr std::array<std::string_view, 9> names{"simulate", "shape", "draw", "rasterise", "flatten",
                                                         "compress", "write", "feed", "encode"};
  std::array<std::atomic<double>, names.size()> seconds_{};
};

}  // namespace taut
