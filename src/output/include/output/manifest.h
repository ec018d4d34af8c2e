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

/// A film, or a file of metrics, in a manifest.
struct FilmRecord {
  std::string file;    ///< as given
  std::string frames;  ///< the selection it is of, such as "1-180"
  std::uintmax_t bytes = 0;
  std::string content;  ///< hash of the file's bytes
};

/// A frame in a manifest, by two hashes.
struct FrameRecord {
  std::string state;    ///< of the state it shows
  std::string content;  ///< of the bytes of its file, or of its record in a file of motion

  bool operator==(const FrameRecord&) const = default;
};

/// What stands beside frames: what they were made from, and which of them are done.
struct Manifest {
  std::string kind = "frames";  ///< "frames", "motion", or "film" for one that has no frames beside it
  std::string inputs;           ///< hash of everything that decides what the frames look like
  std::string scene;            ///< name
  std::string scene_toml;       ///< resolved: every default filled in
  std::string folder;           ///< of files that the scene names; empty where it names none; decides nothing
  std::vector<std::string> other_tomls;  ///< of further panels, which differ in method alone
  std::string method;
  std::map<std::string, std::variant<double, std::string>> settings;  ///< of the method
  std::string halvings;  ///< which steps could only be made in parts, a sentence a run; empty where none
  std::string plan;      ///< why it was run with this method and these settings; empty where that was given
  Size size;
  int bits = 8;  ///< of a channel of a picture: 8, in PNG files, or 16, in TIFF files
  double frames_per_second = 30.0;
  std::string frame_rate = "30";  ///< the same, exactly: FrameRate::text()
  int frame_count = 0;            ///< of the whole scene, whether they were asked for or not
  double colour_range = 0;        ///< the top of the range of colours that was settled; 0: none was
  std::string picture;   ///< how it is drawn beyond the scene: samples, shadows, transparency, back end
  std::string drawn_by;  ///< which OpenGL drew; empty before anything was drawn
  std::string physics, drawing;       ///< what decided motion and look, see host/versions.h
  std::string build;                  ///< which build of taut was the last to work on it
  std::map<int, FrameRecord> frames;  ///< by number, from 1
  std::vector<FilmRecord> films, metrics;
};

/// Which of a manifest's lists of files is meant.
using FilmList = std::vector<FilmRecord> Manifest::*;

/// The hash of everything that decides what frames look like, worked out from the manifest itself. A motion's
/// comes from less: it has none here, and gives what it holds.
std::string inputs_of(const Manifest& manifest);

/// The manifest as JSON text.
std::string manifest_text(const Manifest& manifest);

/// Writes a manifest, atomically. Throws RunFailure.
void write_manifest(const std::filesystem::path& file, const Manifest& manifest);

/// Reads a manifest; nothing where there is no file. Throws OutputConflict when the file is not a manifest of
/// ours.
std::optional<Manifest> read_manifest(const std::filesystem::path& file);

}  // namespace taut
