#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "base/stop.h"
#include "output/gnuplot.h"

namespace taut {

/// A file of a study, as it was made.
struct StudyFile {
  std::uintmax_t bytes = 0;
  std::string content;  ///< hash of its bytes
};

/// What a folder of a chart, of maps or of a sag sheet holds: contents.json in it.
struct StudyContents {
  std::string kind;                         ///< "chart", "stability" or "sag"
  std::string build, physics, judging;      ///< what made it last, see host/versions.h
  std::map<std::string, std::string> open;  ///< what is still to be run, by the chart or the maps it is of
  std::map<std::string, StudyFile> files;   ///< by name
};

/// The name of that file.
inline constexpr std::string_view study_contents_name = "contents.json";

/// Reads it. Throws OutputConflict where it is none that this taut wrote.
StudyContents read_study_contents(const std::filesystem::path& file);

/// Writes the files of a study, and says at the end what it wrote.
class StudyFolder {
 public:
  /// Makes the folder, and takes over what is known of files that this study doesn't write: a folder holds
  /// charts of several scenes. Throws RunFailure.
  StudyFolder(std::filesystem::path folder, std::string_view kind);

  /// Writes a file. Throws RunFailure.
  void write(const std::string& name, std::string_view text);
  void write(const std::string& name, std::span<const std::uint8_t> bytes);
  /// Draws a plot, as PNG and SVG. Throws RunFailure, and Interrupted.
  void draw(const std::string& stem, const PlotScript& plot, const StopTest& stop);
  /// Knows a file that something else has written, if it is there: the store of cases.
  void know(const std::string& name);
  /// Writes contents.json; `open` says what of `which` is still to be run, empty where nothing is. Throws
  /// RunFailure.
  void finish(const std::string& which, const std::string& open);

 private:
  std::filesystem::path folder_;
  StudyContents contents_;
};

}  // namespace taut
