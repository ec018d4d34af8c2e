#include "film_records.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "base/failure.h"
#include "output/atomic_file.h"
#include "output/content_hash.h"

namespace taut {

namespace {

namespace fs = std::filesystem;

// The record of that name, where its file is still the one on disk; else null.
const FilmRecord* film_on_disk(const std::vector<FilmRecord>& films, const std::string& name,
                               const fs::path& file) {
  const std::optional<std::string> content = content_hash(file);
  const auto found = std::ranges::find_if(
      films, [&](const FilmRecord& film) { return film.file == name && film.content == content; });
  return content && found != films.end() ? &*found : nullptr;
}

}  // namespace

std::string film_name_from(const fs::path& folder, const fs::path& film) {
  std::error_code error;
  // Of absolute names: whether a folder is there yet changes nothing.
  const fs::path relative = fs::proximate(fs::absolute(film), fs::absolute(folder), error);
  return error ? film.string() : relative.string();
}

fs::path film_manifest_file(const fs::path& film) {
  return film.parent_path() / fmt::format(".{}.json", film.filename().string());
}

const FilmRecord* known_film(const std::vector<FilmRecord>& films, const std::string& name,
                             const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) return nullptr;
  if (const FilmRecord* there = film_on_disk(films, name, file)) return there;
  throw OutputConflict(
      fmt::format("{} exists, and nothing here says that it was made from the same inputs; "
                  "--overwrite replaces it",
                  file.string()));
}

FilmRecord film_record(const std::string& name, const std::string& frames, const fs::path& temporary) {
  return {name, frames, size_of_file(temporary), content_hash(temporary).value_or("")};
}

}  // namespace taut
