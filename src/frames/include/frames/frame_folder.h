#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/shard.h"
#include "output/checkpoint.h"
#include "output/folder_lock.h"
#include "output/manifest.h"

namespace taut {

/// A manifest that films and metrics are entered in.
struct Book {
  Manifest* manifest = nullptr;  ///< null: nobody keeps one
  std::function<void()> save;    ///< brings it to the disk; throws RunFailure
};

/// The manifests in a folder by their files' names: manifest.json, and those of shards. Throws OutputConflict
/// where one is none of ours.
std::map<std::string, Manifest> manifests_in(const std::filesystem::path& folder);

/// The name that a shard's manifest has: manifest.json where there is only one.
std::string manifest_name(const Shard& shard);

/// The file of a frame of so many bits a channel in a folder.
std::filesystem::path frame_file(const std::filesystem::path& folder, int frame, int bits);

/// The files of frames in a folder, of whatever kind, by their names.
std::vector<std::filesystem::path> frame_files_in(const std::filesystem::path& folder);

/// A folder of frames and the manifest that says what they were made from. Shards may fill one folder
/// together, each with a manifest of its own.
class FrameFolder {
 public:
  /// Looks at what is there; writes nothing. `wanted` is the manifest of what is about to be made. Unless
  /// told to overwrite, takes over what was made from the same inputs and is whole, of shards, too, and
  /// throws OutputConflict when there is anything else.
  FrameFolder(std::filesystem::path folder, Manifest wanted, const Shard& shard, bool overwrite);

  /// Makes the folder, holds it for this program, takes away what is to be overwritten, and writes the
  /// manifest. Throws RunFailure, where another program works there, too.
  void begin();

  /// What there is, and what it was made from.
  const Manifest& manifest() const { return manifest_; }
  bool has(int frame) const { return manifest_.frames.contains(frame); }
  std::filesystem::path frame_file(int frame) const {
    return taut::frame_file(folder_, frame, manifest_.bits);
  }

  /// Remembers a frame that something else has written.
  void add(int frame, const FrameRecord& record);
  /// Writes a frame's file and remembers what it shows. The manifest on disk follows now and then. Throws
  /// RunFailure.
  void write(int frame, std::span<const std::uint8_t> file, const std::string& state_hash);

  /// What a run that was stopped goes on from; nothing where there is none that fits what is there.
  std::optional<Checkpoint> checkpoint(std::span<const int> frames) const;
  /// Brings all frames before it to the disk, the manifest, and then the checkpoint. Throws RunFailure.
  void write(const Checkpoint& checkpoint, std::string_view metrics = {});
  /// Takes the checkpoint away, where there is one.
  void remove_checkpoint() const;

  /// The manifest, for films and metrics to be entered in.
  Book book() {
    return {&manifest_, [this] { save(); }};
  }
  /// Remembers which steps could only be made in parts (Manifest::halvings).
  void set_halvings(const std::string& halvings) { manifest_.halvings = halvings; }
  /// Remembers what draws (GlContext::description()).
  void set_drawn_by(const std::string& drawn_by) { manifest_.drawn_by = drawn_by; }
  /// Remembers the top of the range of colours (Manifest::colour_range).
  void set_colour_range(double top) { manifest_.colour_range = top; }
  /// Brings the manifest on disk up to date. Throws RunFailure.
  void save();
  /// Takes all of it away, for good; only of a hidden one.
  void remove();
  /// Whether there is a checkpoint, as begin() or write() left it.
  bool has_checkpoint() const;

 private:
  std::filesystem::path manifest_file() const { return folder_ / manifest_name(shard_); }
  std::filesystem::path checkpoint_file() const;
  std::string lock_name() const;
  void take_over(const Manifest& there);
  void remove_frames() const;

  std::filesystem::path folder_;
  Manifest manifest_;
  Shard shard_;
  bool overwrite_;
  std::optional<std::string> seen_;  // the bytes of the manifest that was looked at
  bool gone_ = false;
  std::unique_ptr<FolderLock> lock_;
  std::unique_ptr<CheckpointClock> clock_;       // of the manifest
  std::vector<std::filesystem::path> unsynced_;  // frames since the last checkpoint
};

}  // namespace taut
