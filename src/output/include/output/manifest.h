#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/image.h"

namespace taut {

/// A film in a manifest.
struct FilmRecord {
  std::string file;    ///< as given
  std::string frames;  ///< the selection it shows, such as "1-180"
  std::uintmax_t bytes = 0;
};

/// What stands beside frames: what they were made from, and which of them are done.
struct Manifest {
  std::string inputs;      ///< hash of everything that decides what the frames look like
  std::string scene;       ///< name
  std::string scene_toml;  ///< resolved: every default filled in
  std::string method;
  std::map<std::string, std::variant<double, std::string>> settings;  ///< of the method
  std::string halvings;  ///< which steps could only be made in parts, a sentence a run; empty where none
  std::string plan;      ///< why it was run with this method and these settings; empty where that was given
  Size size;
  double frames_per_second = 30.0;
  std::string picture;   ///< how it is drawn beyond the scene: samples, shadows, transparency, back end
  std::string drawn_by;  ///< which OpenGL drew; empty before anything was drawn
  std::string build;     ///< which build of taut made it
  std::map<int, std::string> frames;  ///< frame number → hash of the state it shows
  std::vector<FilmRecord> films;
};

/// The manifest as JSON text.
std::string manifest_text(const Manifest& manifest);

/// Writes a manifest, atomically. Throws RunFailure.
void write_manifest(const std::filesystem::path& file, const Manifest& manifest);

/// Reads a manifest; nothing where there is no file. Throws OutputConflict when the file is not a manifest of
/// ours.
std::optional<Manifest> read_manifest(const std::filesystem::path& file);

}  // namespace taut
