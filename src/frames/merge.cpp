#include "frames/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <system_error>

#include "base/failure.h"
#include "film_making.h"
#include "frames/frame_folder.h"
#include "frames/frame_selection.h"
#include "frames/metrics.h"
#include "host/machine.h"
#include "merge_metrics.h"
#include "output/atomic_file.h"
#include "output/content_hash.h"
#include "output/film.h"
#include "output/frame_file.h"
#include "side_files.h"
#include "thread_budget.h"

namespace taut {
namespace {

namespace fs = std::filesystem;

std::vector<ShardFolder> parts_in(std::span<const fs::path> folders) {
  std::vector<ShardFolder> parts;
  for (const fs::path& folder : folders)
    for (const auto& [name, manifest] : manifests_in(folder))
      if (manifest.kind == "frames") parts.push_back({folder, manifest});
  return parts;
}

void require_same_inputs(const std::vector<ShardFolder>& parts) {
  for (const ShardFolder& part : parts)
    if (part.manifest.inputs != parts.front().manifest.inputs)
      throw OutputConflict(fmt::format("{} and {} hold frames made from different inputs",
                                       parts.front().folder.string(), part.folder.string()));
}

bool same_folder(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return fs::weakly_canonical(fs::absolute(a), error) == fs::weakly_canonical(fs::absolute(b), error);
}

// Takes a part's whole frames over into the folder.
void take(const ShardFolder& part, FrameFolder& folder, const fs::path& into, const StopTest& stop) {
  const bool copy = !same_folder(part.folder, into);
  for (const auto& [frame, record] : part.manifest.frames) {
    stop_if_told(stop);
    if (folder.has(frame)) continue;
    const std::optional<std::string> bytes =
        bytes_of_file(frame_file(part.folder, frame, part.manifest.bits));
    if (!bytes || content_hash_of(*bytes) != record.content) continue;
    if (copy) write_file(folder.frame_file(frame), *bytes);
    folder.add(frame, record);
  }
}

// The shards' own manifests say no more than the one that they became.
void remove_shards(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("manifest-") || name.starts_with("checkpoint-")) files.push_back(entry.path());
  }
  std::error_code error;  // what stays is of no harm
  for (const fs::path& file : files) fs::remove(file, error);
}

void make_film(FrameFolder& folder, const fs::path& into, const fs::path& file, const StopTest& stop) {
  const Manifest& manifest = folder.manifest();
  SideFile wanted = side_file(&Manifest::films, file, into, all_frames(manifest.frame_count));
  if (is_made(wanted, &manifest)) return;
  std::vector<int> numbers;
  numbers.reserve(manifest.frames.size());
  for (const auto& [frame, record] : manifest.frames) numbers.push_back(frame);
  const fs::path first = folder.frame_file(numbers.front());
  const bool transparent =
      decode_frame(bytes_of_file(first).value_or(""), manifest.bits, first).channels == 4;
  std::optional<Film> film;
  begin_film(film,
             {file, manifest.size, frame_rate_from(manifest.frame_rate).value_or(FrameRate{}), transparent,
              thread_budget(static_cast<int>(this_machine().threads)).film, manifest.bits});
  add_from_files(*film, folder, numbers, stop);
  film->finish(stop);
  if (!is_film_stream(file)) leave(wanted, folder.book(), film->file(), [&] { film->commit(); });
}

}  // namespace

bool holds_frames(const fs::path& folder) {
  const std::array folders{folder};
  return !parts_in(folders).empty();
}

MergedFrames merge_frames(std::span<const fs::path> folders, const fs::path& into, const MergeWishes& wishes,
                          const StopTest& stop) {
  const std::vector<ShardFolder> parts = parts_in(folders);
  require_same_inputs(parts);
  if (wishes.metrics) check_metrics_file(*wishes.metrics);
  Manifest wanted = parts.front().manifest;
  wanted.frames.clear();
  wanted.films.clear();
  wanted.metrics.clear();
  wanted.halvings.clear();
  FrameFolder folder(into, wanted, {}, false);
  folder.begin();
  for (const ShardFolder& part : parts) take(part, folder, into, stop);
  folder.save();
  MergedFrames merged;
  merged.count = folder.manifest().frames.size();
  for (const int frame : all_frames(wanted.frame_count))
    if (!folder.has(frame)) merged.missing.push_back(frame);
  if (wishes.metrics) {
    merged.unmeasured = merge_metrics(parts, folder, into, *wishes.metrics);
    merged.metrics_made = merged.unmeasured.empty();
  }
  // A shard that isn't done goes on from its own.
  if (merged.missing.empty() && merged.unmeasured.empty()) remove_shards(into);
  if (wishes.film && merged.missing.empty()) {
    make_film(folder, into, *wishes.film, stop);
    merged.film_made = true;
  }
  return merged;
}

}  // namespace taut
