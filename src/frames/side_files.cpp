#include "side_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <system_error>
#include <vector>

#include "base/failure.h"
#include "frames/frame_selection.h"
#include "output/atomic_file.h"
#include "output/content_hash.h"
#include "output/film.h"

namespace taut {
namespace {

namespace fs = std::filesystem;

// Forgets all of that name but the one that has it now. Whether there were any.
bool keep_only(const FilmRecord& made, std::vector<FilmRecord>& list) {
  const auto others = std::erase_if(list, [&](const FilmRecord& other) { return other.file == made.file; });
  list.push_back(made);
  return others > 1;
}

}  // namespace

std::string film_name_from(const fs::path& folder, const fs::path& film) {
  std::error_code error;
  // Of absolute names: whether a folder is there yet changes nothing.
  const fs::path relative =
      fs::proximate(fs::absolute(film), fs::absolute(folder.empty() ? "." : folder), error);
  return error ? film.string() : relative.string();
}

fs::path film_manifest_file(const fs::path& film) {
  return film.parent_path() / fmt::format(".{}.json", film.filename().string());
}

SideFile side_file(FilmList list, const fs::path& file, const fs::path& folder,
                   const std::vector<int>& frames) {
  return {list, file, {film_name_from(folder, file), selection_text(frames), 0, {}}, true};
}

bool is_made(const SideFile& wanted, const Manifest* known) {
  std::error_code error;
  if (is_film_stream(wanted.file) || !fs::exists(wanted.file, error)) return false;
  const std::optional<std::string> content = content_hash(wanted.file);
  if (known != nullptr && content)
    for (const FilmRecord& there : known->*wanted.list)
      if (there.file == wanted.record.file && there.content == content)
        return there.frames == wanted.record.frames;
  throw OutputConflict(
      fmt::format("{} exists, and nothing here says that it was made from the same inputs; "
                  "--overwrite replaces it",
                  wanted.file.string()));
}

void leave(SideFile& made, const Book& book, const fs::path& temporary, const std::function<void()>& commit) {
  made.record.bytes = size_of_file(temporary);
  made.record.content = content_hash(temporary).value_or("");
  if (book.manifest != nullptr) {
    (book.manifest->*made.list).push_back(made.record);
    book.save();
  }
  commit();
  if (book.manifest != nullptr && keep_only(made.record, book.manifest->*made.list)) book.save();
}

void leave_text(SideFile& made, const Book& book, std::string_view text) {
  if (made.file.has_parent_path()) make_folder(made.file.parent_path());
  PendingFile file(made.file);
  file.replace(text);
  leave(made, book, file.temporary_name(), [&] { file.commit(); });
}

}  // namespace taut
