#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>

#include "output/manifest.h"

namespace taut {

/// A folder of frames and the manifest that says what they were made from.
class FrameFolder {
 public:
  /// Looks at what is there; writes nothing. `wanted` is the manifest of what is about to be made. Unless
  /// told to overwrite, takes over what was made from the same inputs and is whole, and throws OutputConflict
  /// when there is anything else.
  FrameFolder(std::filesystem::path folder, Manifest wanted, bool overwrite);

  /// Makes the folder, takes away what is to be overwritten, and writes the manifest. Throws RunFailure.
  void begin();

  /// What there is, and what it was made from.
  const Manifest& manifest() const { return manifest_; }
  bool has(int frame) const { return manifest_.frames.contains(frame); }
  std::filesystem::path frame_file(int frame) const;

  /// Writes a frame's file and remembers what it shows. The manifest on disk follows now and then. Throws
  /// RunFailure.
  void write(int frame, std::span<const std::uint8_t> png, const std::string& state_hash);
  /// Remembers a film, in place of one of the same name.
  void add_film(const FilmRecord& film);
  /// Remembers which steps could only be made in parts (Manifest::halvings).
  void set_halvings(const std::string& halvings) { manifest_.halvings = halvings; }
  /// Remembers what draws (GlContext::description()).
  void set_drawn_by(const std::string& drawn_by) { manifest_.drawn_by = drawn_by; }
  /// Brings the manifest on disk up to date. Throws RunFailure.
  void save();

 private:
  std::filesystem::path manifest_file() const { return folder_ / "manifest.json"; }
  void keep_whole_frames(const std::map<int, std::string>& frames);
  void remove_frames() const;

  std::filesystem::path folder_;
  Manifest manifest_;
  bool overwrite_;
  std::size_t unsaved_ = 0;  ///< frames since the manifest was written
};

}  // namespace taut
