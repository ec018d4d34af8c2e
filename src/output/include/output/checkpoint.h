#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace taut {

/// What a run that makes frames goes on from: every frame before `frame` is done, and `state` is all that it
/// takes to simulate on to that one.
struct Checkpoint {
  int frame = 1;
  std::string state;      ///< bytes
  std::string metrics{};  ///< bytes, of the frames before, as read; empty where they aren't measured
};

/// Writes a checkpoint, with these metrics, atomically, and so that it outlives a loss of power; `inputs` is
/// a hash of what the frames are made from. Throws RunFailure.
void write_checkpoint(const std::filesystem::path& file, std::string_view inputs,
                      const Checkpoint& checkpoint, std::string_view metrics = {});

/// Reads one; nothing where there is none, where its own hash says that it is damaged, or where it is of
/// another version. Throws OutputConflict where it was made from other inputs.
std::optional<Checkpoint> read_checkpoint(const std::filesystem::path& file, std::string_view inputs);

/// Has the system bring files to the disk. Throws RunFailure with its reason.
void sync_files(std::span<const std::filesystem::path> files);

/// Tells when it is time for a checkpoint: never before half a second, and so seldom that all of them cost
/// less than a hundredth of the run. Asked and told from several threads.
class CheckpointClock {
 public:
  bool due() const;
  /// A checkpoint has been taken, and its parts took so long (s) so far.
  void begun(double seconds);
  /// Writing it took so long (s) more.
  void written(double seconds);

 private:
  using Clock = std::chrono::steady_clock;
  std::atomic<Clock::time_point> last_{Clock::now()};
  std::atomic<double> cost_{0.0};
};

}  // namespace taut
