#include "study/verify_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/failure.h"
#include "host/build_info.h"
#include "host/versions.h"
#include "output/atomic_file.h"
#include "output/content_hash.h"
#include "shard_files.h"
#include "study/case_store.h"
#include "study/merge_cases.h"
#include "study/study_folder.h"

namespace taut {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> contents_below(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry :
       fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, error))
    if (entry.path().filename() == study_contents_name) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

// What is wrong with a file; nothing where it is as it was made. A store of cases only ever grows.
std::optional<std::string> fault_of(const fs::path& file, const StudyFile& made) {
  std::optional<std::string> bytes = bytes_of_file(file);
  if (!bytes) return "is missing";
  if (bytes->size() < made.bytes) return "is cut short";
  if (file.extension() == ".jsonl") bytes->resize(made.bytes);
  if (content_hash_of(*bytes) != made.content) return "is not as it was made";
  return std::nullopt;
}

// A store is read, too: what has come since it was listed is only known from itself.
std::optional<std::string> damage_of_store(const fs::path& file) {
  if (file.extension() != ".jsonl") return std::nullopt;
  try {
    read_cases(file, "");
  } catch (const OutputConflict& damage) {
    return damage.what();
  }
  return std::nullopt;
}

class StudyCheck {
 public:
  StudyCheck(const fs::path& folder, Verification& found) : top_(folder), found_(found) {}

  void contents(const fs::path& file) {
    StudyContents contents;
    try {
      contents = read_study_contents(file);
    } catch (const OutputConflict& damage) {
      found_.faults.emplace_back(damage.what());
      return;
    }
    made_by(shown(file), contents);
    for (const auto& [name, made] : contents.files) listed(file.parent_path() / name, made);
    for (const auto& [which, open] : contents.open)
      found_.holes.push_back(fmt::format("{}: {}", shown(file.parent_path() / which), open));
    for (const auto& entry : fs::directory_iterator(file.parent_path()))
      if (is_unknown(entry, contents))
        found_.notes.push_back(fmt::format("{} is in no list of a study's files", shown(entry.path())));
  }

 private:
  std::string shown(const fs::path& file) const { return file.lexically_relative(top_).string(); }

  void made_by(const std::string& name, const StudyContents& contents) {
    if (contents.physics != physics_version() || contents.judging != judging_version())
      found_.faults.push_back(fmt::format("{}: made by a taut that moves or judges otherwise", name));
    else if (contents.build != build_info())
      found_.notes.push_back(
          fmt::format("{}: made by another build of the same physics, {}", name, contents.build));
  }

  void listed(const fs::path& file, const StudyFile& made) {
    ++found_.checked;
    if (const auto fault = fault_of(file, made)) {
      found_.faults.push_back(fmt::format("{} {}", shown(file), *fault));
      return;
    }
    if (const auto damage = damage_of_store(file))
      found_.faults.push_back(*damage);
    else if (size_of_file(file) > made.bytes)
      found_.notes.push_back(
          fmt::format("{} has grown since it was drawn; running the same again draws it", shown(file)));
  }

  // Stores of shards are held against one another, not against a list.
  static bool is_unknown(const fs::directory_entry& entry, const StudyContents& contents) {
    constexpr std::array<std::string_view, 8> endings{".png", ".svg", ".csv",  ".json",
                                                      ".txt", ".md",  ".html", ".jsonl"};
    const fs::path& file = entry.path();
    const std::string name = file.filename().string();
    return entry.is_regular_file() && std::ranges::count(endings, file.extension().string()) > 0 &&
           name != study_contents_name && !contents.files.contains(name) && !shard_file_name(name);
  }

  const fs::path& top_;
  Verification& found_;
};

}  // namespace

bool holds_study(const fs::path& folder) {
  return !contents_below(folder).empty() || holds_cases(std::array{folder});
}

void verify_study(const fs::path& folder, Verification& found, const StopTest& stop) {
  StudyCheck check(folder, found);
  for (const fs::path& file : contents_below(folder)) {
    stop_if_told(stop);
    check.contents(file);
  }
  for (const ShardsLeft& left : shards_left(folder)) {
    found.checked += left.shards;
    found.faults.insert(found.faults.end(), left.faults.begin(), left.faults.end());
    // What was drawn since is held against its list.
    std::error_code error;
    if (fs::exists((folder / left.file).parent_path() / study_contents_name, error)) continue;
    for (const std::string& hole : left.holes)
      found.holes.push_back(fmt::format("{}: {}", left.file.string(), hole));
  }
}

}  // namespace taut
