#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "frames/frame_folder.h"
#include "output/manifest.h"

namespace taut {

/// A file that stands beside frames or a motion: a film, or metrics.
struct SideFile {
  FilmList list = &Manifest::films;  ///< where a manifest has its like
  std::filesystem::path file;        ///< where it lies; a pipe of a film has no record
  FilmRecord record;                 ///< as it stands in the manifest: of one to be made, name and frames
  bool make = false;                 ///< it is asked for and not there yet
};

/// How a film is named in the manifest of a folder (empty: the current one): from there, so that both can be
/// moved together.
std::string film_name_from(const std::filesystem::path& folder, const std::filesystem::path& film);

/// The manifest of a film that has no folder of frames: a hidden file beside it.
std::filesystem::path film_manifest_file(const std::filesystem::path& film);

/// A file to be made beside what is in a folder (empty: the current one), of frames.
SideFile side_file(FilmList list, const std::filesystem::path& file, const std::filesystem::path& folder,
                   const std::vector<int>& frames);

/// Whether a file is there already, of the frames it is asked for of, as a manifest (null: none) knows it.
/// Throws OutputConflict where something else has its name.
bool is_made(const SideFile& wanted, const Manifest* known);

/// Gives a file that is done its name, by `commit`. The manifest knows it before, beside what stood there: at
/// whatever moment the program ends, nothing stands there that nothing is known of. `temporary` is where it
/// lies until then. Throws RunFailure.
void leave(SideFile& made, const Book& book, const std::filesystem::path& temporary,
           const std::function<void()>& commit);

/// Writes a side file whose whole text is known, and leave()s it. Throws RunFailure.
void leave_text(SideFile& made, const Book& book, std::string_view text);

}  // namespace taut
