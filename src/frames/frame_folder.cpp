#include "frames/frame_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <system_error>
#include <utility>
#include <vector>

#include "base/failure.h"
#include "base/hash.h"
#include "base/stopwatch.h"
#include "frames/hidden_folder.h"
#include "output/atomic_file.h"
#include "output/content_hash.h"
#include "output/frame_file.h"

namespace taut {
namespace {

namespace fs = std::filesystem;

bool is_frame_name(const std::string& name) {
  constexpr std::string_view before = "frame-";
  constexpr std::size_t ending = 4;  // letters, the dot among them
  if (name.size() != before.size() + 6 + ending || !name.starts_with(before)) return false;
  if (!name.ends_with(frame_ending(8)) && !name.ends_with(frame_ending(16))) return false;
  const std::string digits = name.substr(before.size(), 6);
  return std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
}

// The first thing in which two manifests differ, for people.
std::string difference(const Manifest& there, const Manifest& wanted) {
  if (there.kind != wanted.kind) return fmt::format("another kind, {}", there.kind);
  if (there.scene != wanted.scene) return fmt::format("the scene {}", there.scene);
  if (there.method != wanted.method) return fmt::format("the method {}", there.method);
  if (there.settings != wanted.settings) return "other settings of the method";
  if (there.scene_toml != wanted.scene_toml) return "another version of the scene";
  if (there.size.width != wanted.size.width || there.size.height != wanted.size.height)
    return fmt::format("the size {}x{}", there.size.width, there.size.height);
  if (there.frames_per_second != wanted.frames_per_second)
    return fmt::format("{} frames/s", there.frames_per_second);
  if (there.picture != wanted.picture) return "other picture settings";
  if (there.physics != wanted.physics) return "a taut whose methods move otherwise";
  return there.drawing != wanted.drawing ? "a taut that draws otherwise" : "other inputs";
}

}  // namespace

std::map<std::string, Manifest> manifests_in(const fs::path& folder) {
  std::map<std::string, Manifest> manifests;
  std::error_code error;  // a folder that is not there has none
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("manifest") || !name.ends_with(".json")) continue;
    if (const std::optional<Manifest> manifest = read_manifest(entry.path())) manifests[name] = *manifest;
  }
  return manifests;
}

std::string manifest_name(const Shard& shard) {
  return fmt::format("manifest{}.json", shard.suffix());
}

fs::path frame_file(const fs::path& folder, int frame, int bits) {
  return folder / fmt::format("frame-{:06}{}", frame, frame_ending(bits));
}

std::vector<fs::path> frame_files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (is_frame_name(entry.path().filename().string())) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

FrameFolder::FrameFolder(fs::path folder, Manifest wanted, const Shard& shard, bool overwrite)
    : folder_(std::move(folder)),
      manifest_(std::move(wanted)),
      shard_(shard),
      overwrite_(overwrite),
      seen_(bytes_of_file(manifest_file())),
      clock_(std::make_unique<CheckpointClock>()) {
  if (overwrite_) return;
  const std::map<std::string, Manifest> there = manifests_in(folder_);
  for (const auto& [name, manifest] : there)
    if (manifest.inputs != manifest_.inputs)
      throw OutputConflict(
          fmt::format("{} holds frames made from {}; --overwrite replaces them, -o chooses another folder",
                      folder_.string(), difference(manifest, manifest_)));
  if (there.empty() && !frame_files_in(folder_).empty())
    throw OutputConflict(
        fmt::format("{} holds frames but no manifest.json that says what they were made from; --overwrite "
                    "replaces them, -o chooses another folder",
                    folder_.string()));
  for (const auto& [name, manifest] : there)
    if (shard_.all() || name == manifest_name(shard_)) take_over(manifest);
}

void FrameFolder::take_over(const Manifest& there) {
  for (const FilmList list : {&Manifest::films, &Manifest::metrics})
    (manifest_.*list).insert((manifest_.*list).end(), (there.*list).begin(), (there.*list).end());
  manifest_.colour_range = std::max(manifest_.colour_range, there.colour_range);
  manifest_.drawn_by = there.drawn_by;
  if (manifest_.kind != "frames") return;
  for (const auto& [frame, record] : there.frames)
    if (content_hash(frame_file(frame)) == record.content) manifest_.frames[frame] = record;
}

void FrameFolder::begin() {
  make_folder(folder_);
  lock_ = std::make_unique<FolderLock>(folder_, lock_name());
  if (bytes_of_file(manifest_file()) != seen_)
    throw RunFailure(
        fmt::format("another taut has worked in {} in the meantime; run the same again", folder_.string()));
  if (overwrite_) remove_frames();
  save();
}

// A shard that begins anew leaves what others have made.
void FrameFolder::remove_frames() const {
  std::vector<fs::path> files{checkpoint_file()};
  if (shard_.all()) {
    for (const fs::path& frame : frame_files_in(folder_)) files.push_back(frame);
    for (const auto& entry : fs::directory_iterator(folder_))
      if (entry.path().filename().string().starts_with("manifest-")) files.push_back(entry.path());
  }
  for (const fs::path& file : files) remove_file(file);
}

std::string FrameFolder::lock_name() const {
  return fmt::format(".{}.lock", manifest_name(shard_));
}

fs::path FrameFolder::checkpoint_file() const {
  return folder_ / (fmt::format("checkpoint{}.bin", shard_.suffix()));
}

void FrameFolder::write(int frame, std::span<const std::uint8_t> file, const std::string& state_hash) {
  write_file(frame_file(frame), std::as_bytes(file));
  unsynced_.push_back(frame_file(frame));
  add(frame, {state_hash, Hash().add(std::as_bytes(file)).hex()});
}

void FrameFolder::add(int frame, const FrameRecord& record) {
  manifest_.frames[frame] = record;
  if (clock_->due()) save();
}

std::optional<Checkpoint> FrameFolder::checkpoint(std::span<const int> frames) const {
  if (overwrite_) return std::nullopt;
  std::optional<Checkpoint> there = read_checkpoint(checkpoint_file(), manifest_.inputs);
  if (!there) return std::nullopt;
  const bool all_before =
      std::ranges::all_of(frames, [&](int frame) { return frame >= there->frame || has(frame); });
  return all_before ? std::move(there) : std::nullopt;
}

void FrameFolder::write(const Checkpoint& checkpoint, std::string_view metrics) {
  sync_files(unsynced_);
  unsynced_.clear();
  save();
  sync_files(std::array{manifest_file()});
  write_checkpoint(checkpoint_file(), manifest_.inputs, checkpoint, metrics);
}

bool FrameFolder::has_checkpoint() const {
  std::error_code error;
  return fs::exists(checkpoint_file(), error);
}

void FrameFolder::remove_checkpoint() const {
  std::error_code error;  // one that stays is of no harm
  fs::remove(checkpoint_file(), error);
}

void FrameFolder::remove() {
  if (!lock_) lock_ = lock_unless_held(folder_, lock_name());
  if (!lock_) return;
  remove_hidden_folder(folder_, std::move(lock_));
  gone_ = true;
}

void FrameFolder::save() {
  if (gone_) return;
  const Stopwatch watch;
  write_manifest(manifest_file(), manifest_);
  clock_->begun(watch.seconds());
}

}  // namespace taut
