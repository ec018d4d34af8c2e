#include "frames/verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <system_error>

#include "base/failure.h"
#include "frames/film_frames.h"
#include "frames/frame_folder.h"
#include "frames/frame_selection.h"
#include "frames/simulate.h"
#include "host/build_info.h"
#include "host/versions.h"
#include "output/content_hash.h"
#include "output/frame_file.h"
#include "panel_runs.h"
#include "side_files.h"

namespace taut {
namespace {

namespace fs = std::filesystem;

FrameRate rate_of(const Manifest& manifest) {
  return frame_rate_from(manifest.frame_rate).value_or(FrameRate{});
}

// The scenes of a manifest's panels.
std::vector<Scene> scenes_of(const Manifest& manifest) {
  std::vector<std::string> tomls{manifest.scene_toml};
  tomls.insert(tomls.end(), manifest.other_tomls.begin(), manifest.other_tomls.end());
  std::vector<Scene> scenes;
  scenes.reserve(tomls.size());
  const std::string file = (fs::path(manifest.folder) / manifest.scene).string();
  for (const std::string& toml : tomls) scenes.push_back(parse_scene(toml, file));
  return scenes;
}

// Holds one manifest against what lies beside it.
class Check {
 public:
  Check(fs::path folder, const std::string& name, const Manifest& manifest, Verification& found)
      : folder_(std::move(folder)), name_(name), manifest_(manifest), found_(found) {}

  void itself() {
    if (manifest_.kind != "motion" && inputs_of(manifest_) != manifest_.inputs)
      fault("{}: its inputs are not the hash of what it says it was made from", name_);
    if (manifest_.physics != physics_version())
      fault("{}: made by a taut whose methods move otherwise ({}, this is {})", name_, manifest_.physics,
            physics_version());
    else if (manifest_.kind == "frames" && manifest_.drawing != drawing_version())
      fault("{}: made by a taut that draws otherwise ({}, this is {})", name_, manifest_.drawing,
            drawing_version());
    else if (manifest_.build != build_info())
      found_.notes.push_back(
          fmt::format("{}: made by another build of the same physics, {}", name_, manifest_.build));
  }

  void frames() {
    for (const auto& [frame, record] : manifest_.frames) {
      ++found_.checked;
      const fs::path file = frame_file(folder_, frame, manifest_.bits);
      const std::string shown = file.filename().string();
      std::error_code error;
      if (!fs::exists(file, error))
        fault("{} is missing", shown);
      else if (!is_whole_frame(file, manifest_.size, manifest_.bits))
        fault("{} is not a whole picture of {}x{}", shown, manifest_.size.width, manifest_.size.height);
      else if (const std::optional<std::string> content = content_hash(file); content != record.content)
        fault("{} is not the picture that was made: another frame, of another scene, or changed", shown);
    }
  }

  void films() {
    for (const FilmRecord& film : manifest_.films) {
      const std::optional<std::string> content = content_hash(folder_ / film.file);
      if (!content)
        fault("the film {} is missing", film.file);
      else if (content != film.content)
        fault("the film {} is not the one that was made", film.file);
    }
  }

  void metrics() {
    for (const FilmRecord& metrics : manifest_.metrics)
      if (const auto content = content_hash(folder_ / metrics.file); !content)
        fault("the metrics {} are missing", metrics.file);
      else if (content != metrics.content)
        fault("the metrics {} are not those that were made", metrics.file);
  }

  void motion() {
    const StoredMotion motion = open_motion(folder_);
    if (motion.reader->inputs() != manifest_.inputs)
      fault("motion.bin is of another scene, method or settings");
    const Scene scene = scenes_of(manifest_).front();
    for (const auto& [frame, record] : manifest_.frames) {
      ++found_.checked;
      const auto there = motion.reader->records().find(frame);
      if (there == motion.reader->records().end()) {
        fault("moment {} is missing", frame);
        continue;
      }
      try {
        const RunState moment = motion.reader->read(there->second, scene.model);
        if (fmt::format("{:016x}", state_hash(moment.state)) != record.state)
          fault("moment {} is not the one that was made", frame);
      } catch (const std::exception& damage) {
        fault("moment {}: {}", frame, damage.what());
      }
    }
  }

  // Simulates again, and compares the state of every frame.
  void states(Progress& progress, const StopTest& stop) {
    const std::vector<Scene> scenes = scenes_of(manifest_);
    PanelRuns runs(scenes);
    progress.start(static_cast<int>(manifest_.frames.size()));
    int done = 0;
    for (const auto& [frame, record] : manifest_.frames) {
      const auto panels = runs.at(shown_time(scenes.front(), frame, rate_of(manifest_)), stop);
      if (!panels) throw Interrupted();
      if (panels_hash(*panels) != record.state)
        fault("frame {}: simulated again it has another state, {} and not {}", frame, panels_hash(*panels),
              record.state);
      progress.update(++done);
    }
    progress.finish();
  }

 private:
  template <class... Parts>
  void fault(fmt::format_string<Parts...> text, Parts&&... parts) {
    found_.faults.push_back(fmt::format(text, std::forward<Parts>(parts)...));
  }

  fs::path folder_;
  const std::string& name_;
  const Manifest& manifest_;
  Verification& found_;
};

// Frames that no manifest knows, and those of the film that none has yet.
void look_beside(const fs::path& folder, const std::map<std::string, Manifest>& manifests,
                 Verification& found) {
  std::vector<int> known;
  std::set<fs::path> files;
  for (const auto& [name, manifest] : manifests)
    for (const auto& [frame, record] : manifest.frames) {
      known.push_back(frame);
      files.insert(frame_file(folder, frame, manifest.bits));
    }
  std::ranges::sort(known);
  for (const fs::path& file : frame_files_in(folder))
    if (!files.contains(file))
      found.faults.push_back(fmt::format("{} is in no manifest", file.filename().string()));
  for (const int frame : all_frames(manifests.begin()->second.frame_count))
    if (!std::ranges::binary_search(known, frame)) found.missing.push_back(frame);
}

}  // namespace

bool holds_manifest(const fs::path& folder) {
  try {
    return !manifests_in(folder).empty();
  } catch (const OutputConflict&) {
    return true;
  }
}

Verification verify(const fs::path& output, bool deep, Progress& progress, const StopTest& stop) {
  std::error_code error;
  const bool is_folder = fs::is_directory(output, error);
  std::map<std::string, Manifest> manifests;
  try {
    if (is_folder) {
      manifests = manifests_in(output);
    } else {
      const fs::path beside = film_manifest_file(output);
      if (const auto manifest = read_manifest(beside)) manifests[beside.filename().string()] = *manifest;
    }
  } catch (const OutputConflict& damage) {
    Verification found;
    found.faults.emplace_back(damage.what());
    return found;
  }
  if (manifests.empty())
    throw BadRequest(fmt::format("{} has no manifest of taut's, which would say what it was made from{}",
                                 output.string(),
                                 is_folder ? "" : "; a film's lies in its folder of frames"));
  Verification found;
  for (const auto& [name, manifest] : manifests) {
    Check check(is_folder ? output : output.parent_path(), name, manifest, found);
    check.itself();
    check.films();
    check.metrics();
    if (manifest.kind == "frames") check.frames();
    if (manifest.kind == "motion") check.motion();
    if (deep) check.states(progress, stop);
    stop_if_told(stop);
  }
  if (is_folder) look_beside(output, manifests, found);
  return found;
}

}  // namespace taut
