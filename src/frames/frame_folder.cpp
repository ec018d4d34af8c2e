#include "frames/frame_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

#include "base/failure.h"
#include "output/atomic_file.h"
#include "output/png_check.h"

namespace taut {
namespace {

namespace fs = std::filesystem;

// The manifest is written whole, so the longer it gets the more rarely it is.
bool time_to_save(std::size_t unsaved, std::size_t frames) {
  return unsaved >= std::max<std::size_t>(30, frames / 10);
}

bool is_frame_name(const std::string& name) {
  constexpr std::string_view before = "frame-", after = ".png";
  if (name.size() != before.size() + 6 + after.size() || !name.starts_with(before) || !name.ends_with(after))
    return false;
  const std::string digits = name.substr(before.size(), 6);
  return std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
}

std::vector<fs::path> frames_in(const fs::path& folder) {
  std::vector<fs::path> frames;
  std::error_code error;  // a folder that is not there has no frames
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (is_frame_name(entry.path().filename().string())) frames.push_back(entry.path());
  return frames;
}

// The first thing in which two manifests differ, for people.
std::string difference(const Manifest& there, const Manifest& wanted) {
  if (there.scene != wanted.scene) return fmt::format("the scene {}", there.scene);
  if (there.method != wanted.method) return fmt::format("the method {}", there.method);
  if (there.settings != wanted.settings) return "other settings of the method";
  if (there.scene_toml != wanted.scene_toml) return "another version of the scene";
  if (there.size.width != wanted.size.width || there.size.height != wanted.size.height)
    return fmt::format("the size {}x{}", there.size.width, there.size.height);
  if (there.frames_per_second != wanted.frames_per_second)
    return fmt::format("{} frames/s", there.frames_per_second);
  if (there.picture != wanted.picture) return "other picture settings";
  return "another build of taut";
}

}  // namespace

FrameFolder::FrameFolder(fs::path folder, Manifest wanted, bool overwrite)
    : folder_(std::move(folder)), manifest_(std::move(wanted)), overwrite_(overwrite) {
  if (overwrite_) return;
  const std::optional<Manifest> there = read_manifest(manifest_file());
  if (there && there->inputs != manifest_.inputs)
    throw OutputConflict(
        fmt::format("{} holds frames made from {}; --overwrite replaces them, -o chooses another folder",
                    folder_.string(), difference(*there, manifest_)));
  if (!there && !frames_in(folder_).empty())
    throw OutputConflict(
        fmt::format("{} holds frames but no manifest.json that says what they were made from; --overwrite "
                    "replaces them, -o chooses another folder",
                    folder_.string()));
  if (!there) return;
  manifest_.films = there->films;
  keep_whole_frames(there->frames);
}

void FrameFolder::keep_whole_frames(const std::map<int, std::string>& frames) {
  for (const auto& [frame, hash] : frames)
    if (is_whole_png(frame_file(frame), manifest_.size)) manifest_.frames[frame] = hash;
}

void FrameFolder::begin() {
  make_folder(folder_);
  if (overwrite_) remove_frames();
  save();
}

void FrameFolder::remove_frames() const {
  for (const fs::path& frame : frames_in(folder_)) {
    std::error_code error;
    fs::remove(frame, error);
    if (error) throw RunFailure(fmt::format("can't remove {}: {}", frame.string(), error.message()));
  }
}

fs::path FrameFolder::frame_file(int frame) const {
  return folder_ / fmt::format("frame-{:06}.png", frame);
}

void FrameFolder::write(int frame, std::span<const std::uint8_t> png, const std::string& state_hash) {
  write_file(frame_file(frame), std::as_bytes(png));
  manifest_.frames[frame] = state_hash;
  if (time_to_save(++unsaved_, manifest_.frames.size())) save();
}

void FrameFolder::add_film(const FilmRecord& film) {
  std::erase_if(manifest_.films, [&](const FilmRecord& other) { return other.file == film.file; });
  manifest_.films.push_back(film);
}

void FrameFolder::save() {
  write_manifest(manifest_file(), manifest_);
  unsaved_ = 0;
}

}  // namespace taut
