#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/stop.h"
#include "base/stopwatch.h"
#include "frames/hidden_folder.h"
#include "frames/simulation.h"
#include "output/checkpoint.h"
#include "output/folder_lock.h"
#include "output/motion_file.h"
#include "scene/scene.h"

namespace taut {

/// A scene's run at given times, for something that is only there when it is whole. Of a run that takes
/// longer than a second, moments and checkpoints lie in a hidden folder from then on; who is killed and asks
/// for the same again simulates on from the last checkpoint, and gets the moments before as they were.
class KeptRun {
 public:
  /// Refers to the scene from then on. What the folder holds of other times or another scene is thrown away
  /// as soon as there is anything to keep. Where there is no room, or another program works in the folder,
  /// nothing is kept. Throws BadRequest when the scene's method refuses it.
  KeptRun(const Scene& scene, std::vector<double> times, std::filesystem::path folder,
          const Execution& execution);
  KeptRun(const KeptRun&) = delete;
  KeptRun& operator=(const KeptRun&) = delete;
  /// What is of no use to whoever goes on goes with it.
  ~KeptRun();

  /// The state at the next of the times, as reports show it. Nothing when told to stop on the way. Throws as
  /// Simulation does, and RunFailure where what was kept can't be read.
  std::optional<State> next(const StopTest& stop);
  /// What was measured of the run up to the state that next() gave last.
  RunMeasures measures() const;
  /// When (s) the simulation goes on, from a checkpoint; none where it begins anew.
  std::optional<double> resumed_at() const {
    return resume_ ? std::optional(times_[static_cast<std::size_t>(resume_->frame) - 1]) : std::nullopt;
  }
  /// Whether running the same again would go on from something.
  bool keeps() const { return has_checkpoint(folder_); }
  /// Takes the folder away, when what is made of the run is there.
  void remove();

 private:
  void look_at_what_was_kept();
  const MotionRecord* kept(int number) const;
  std::optional<State> simulated(int number, const StopTest& stop);
  void keep_checkpoint(int number, const StopTest& stop);
  void begin_to_keep();
  void if_there_is_room(const std::function<void()>& keep);
  std::filesystem::path motion_file() const { return folder_ / "motion.bin"; }
  std::filesystem::path checkpoint_file() const { return folder_ / hidden_checkpoint; }

  const Scene& scene_;
  std::vector<double> times_;
  std::filesystem::path folder_;
  Execution execution_;
  std::string inputs_;
  std::optional<Simulation> simulation_;
  std::optional<UselessGoesAway> hidden_;
  std::unique_ptr<FolderLock> lock_;
  std::unique_ptr<MotionWriter> writer_;  // null as long as nothing is kept
  std::unique_ptr<MotionReader> reader_;  // of what was kept by a run before; null where that is nothing
  std::optional<Checkpoint> resume_;
  CheckpointClock clock_;
  Stopwatch watch_;
  std::size_t done_ = 0;
  bool gave_up_ = false;            // there was no room, or another program works in the folder
  std::optional<State> last_;       // what next() gave last, as the run has it, …
  std::optional<RunState> stored_;  // … or as it was read
};

}  // namespace taut
