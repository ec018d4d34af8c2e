#include "host/scene_folder.h"

#include <fmt/format.h>
#include <sys/auxv.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string_view>

#include "base/failure.h"
#include "base/nearest.h"

namespace taut {
namespace {

namespace fs = std::filesystem;

bool looks_like_a_path(const std::string& argument) {
  return argument.find('/') != std::string::npos || argument.ends_with(".toml");
}

// The nearest name, with its folder before it, as a question; empty where none is near.
std::string did_you_mean(const std::string& name, const std::vector<std::string>& known,
                         const fs::path& folder = {}) {
  const std::vector<std::string_view> names(known.begin(), known.end());
  const std::string_view nearest = nearest_name(name, names);
  return nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", (folder / nearest).string());
}

std::vector<std::string> scene_files_in(const fs::path& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder.empty() ? "." : folder, error))
    if (entry.path().extension() == ".toml") files.push_back(entry.path().filename().string());
  std::ranges::sort(files);
  return files;
}

fs::path existing_file(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::is_directory(status))
    throw BadRequest(fmt::format("{} is a folder, not a scene file", file.string()));
  if (error || !fs::exists(status))
    throw BadRequest(fmt::format(
        "there is no scene file {}{}", file.string(),
        did_you_mean(file.filename().string(), scene_files_in(file.parent_path()), file.parent_path())));
  return file;
}

[[noreturn]] void no_such_scene(const std::string& name) {
  std::vector<std::string> stems;
  for (const fs::path& file : all_scene_files()) stems.push_back(file.stem().string());
  throw BadRequest(
      fmt::format("there is no scene \"{}\"{}; \"taut list scenes\" shows all, and a path means a file", name,
                  did_you_mean(name, stems)));
}

// The running program's own file, through links. Where /proc is not there, as in a bare chroot, what it was
// started as.
fs::path program_file() {
  std::error_code error;
  const fs::path file = fs::read_symlink("/proc/self/exe", error);
  if (!error) return file;
  // NOLINTNEXTLINE(performance-no-int-to-ptr): an address as the system gives it
  const auto* started_as = reinterpret_cast<const char*>(::getauxval(AT_EXECFN));
  return started_as == nullptr ? fs::path() : fs::canonical(started_as, error);
}

// Where a program in PREFIX/bin has its scenes, or one in a build folder.
fs::path own_scene_folder() {
  const fs::path folder = program_file().parent_path();
  for (const fs::path& root : {folder.parent_path(), folder}) {
    std::error_code error;
    const fs::path scenes = fs::canonical(root / "share/taut/scenes", error);
    if (!error) return scenes;
  }
  return {};
}

}  // namespace

std::vector<fs::path> scene_folders() {
  std::vector<fs::path> folders;
  const auto add = [&](const fs::path& folder) {
    std::error_code error;
    if (fs::is_directory(folder, error)) folders.push_back(folder);
  };
  if (const char* chosen = std::getenv("TAUT_SCENES"); chosen != nullptr && *chosen != '\0') add(chosen);
  add(own_scene_folder());
  add("scenes");
  return folders;
}

std::vector<fs::path> all_scene_files() {
  std::map<std::string, fs::path> by_name;
  for (const fs::path& folder : scene_folders()) {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
      if (entry.path().extension() == ".toml")
        by_name.try_emplace(entry.path().stem().string(), entry.path());
    }
  }
  std::vector<fs::path> files;
  files.reserve(by_name.size());
  for (const auto& [name, file] : by_name) files.push_back(file);
  return files;
}

fs::path find_scene(const std::string& argument) {
  std::error_code error;
  if (looks_like_a_path(argument) || fs::is_regular_file(argument, error)) return existing_file(argument);
  for (const fs::path& folder : scene_folders()) {
    const fs::path file = folder / (argument + ".toml");
    if (fs::exists(file, error)) return existing_file(file);
  }
  no_such_scene(argument);
}

}  // namespace taut
