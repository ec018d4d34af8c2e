#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "frames/frame_folder.h"
#include "output/manifest.h"

namespace taut {

/// How a film is named in the manifest of a folder (empty: the current one): from there, so that both can be
/// moved together.
std::string film_name_from(const std::filesystem::path& folder, const std::filesystem::path& film);

/// The manifest of a film that has no folder of frames: a hidden file beside it.
std::filesystem::path film_manifest_file(const std::filesystem::path& film);

/// Throws OutputConflict where a file is there that none of a manifest's records is of; gives the one that
/// is, or null where there is no such file.
const FilmRecord* known_film(const std::vector<FilmRecord>& films, const std::string& name,
                             const std::filesystem::path& file);

/// A record of a film under its temporary name.
FilmRecord film_record(const std::string& name, const std::string& frames,
                       const std::filesystem::path& temporary);

}  // namespace taut
