#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <system_error>

#include "base/failure.h"
#include "base/nearest.h"
#include "export/formats.h"
#include "output/atomic_file.h"
#include "output/export.h"

namespace taut {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view frame_begins_with = "frame-";
constexpr std::size_t frame_digits = 6;

}  // namespace

std::span<const ExportFormat> export_formats() {
  static const std::array formats{csv_format, npz_format, vtp_format,  obj_format,
                                  ply_format, pc2_format, usda_format, glb_format};
  return formats;
}

const ExportFormat& export_format(std::string_view name) {
  std::vector<std::string_view> names;
  names.reserve(export_formats().size());
  for (const ExportFormat& format : export_formats()) {
    if (format.name == name) return format;
    names.push_back(format.name);
  }
  const std::string_view nearest = nearest_name(name, names);
  throw BadRequest(fmt::format("--format is one of {}, not \"{}\"{}", fmt::join(names, ", "), name,
                               nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest)));
}

const ExportFormat* export_format_of_file(const fs::path& file) {
  const std::string ending = file.extension().string();
  for (const ExportFormat& format : export_formats())
    if (!ending.empty() && format.ending == ending) return &format;
  return nullptr;
}

std::string export_frame_name(int frame, std::string_view ending) {
  return fmt::format("{}{:0{}}{}", frame_begins_with, frame, frame_digits, ending);
}

bool is_export_frame_name(std::string_view name, std::string_view ending) {
  if (!name.starts_with(frame_begins_with) || !name.ends_with(ending)) return false;
  if (name.size() < frame_begins_with.size() + ending.size() + frame_digits) return false;
  name.remove_prefix(frame_begins_with.size());
  name.remove_suffix(ending.size());
  return std::ranges::all_of(name, [](char letter) { return letter >= '0' && letter <= '9'; });
}

std::unique_ptr<FolderLock> make_export_folder(const ExportFormat& format, const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error))
    throw BadRequest(fmt::format("{} is a file; {} is a folder of files", folder.string(), format.name));
  std::vector<fs::path> earlier;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with('.')) continue;  // what another run is writing
    if (!format.writes(name))
      throw OutputConflict(
          fmt::format("{} holds {}, which is no part of an export as {}; -o chooses another folder",
                      folder.string(), name, format.name));
    earlier.push_back(entry->path());
  }
  make_folder(folder);
  auto lock = std::make_unique<FolderLock>(folder, ".taut-export.lock");
  for (const fs::path& file : earlier) remove_file(file);
  return lock;
}

}  // namespace taut
