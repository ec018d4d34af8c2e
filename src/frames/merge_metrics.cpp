#include "merge_metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "base/failure.h"
#include "base/split.h"
#include "frames/frame_selection.h"
#include "frames/metrics.h"
#include "frames/shard_file.h"
#include "output/content_hash.h"
#include "side_files.h"

namespace taut {
namespace {

namespace fs = std::filesystem;

// What several files of metrics say, frame by frame.
struct Rows {
  std::string header;                   // of a table
  std::map<int, std::string> by_frame;  // every frame's lines, of several methods a line each
};

// The frame that a row is of.
int frame_of(std::string_view row, bool as_lines) {
  if (as_lines) return nlohmann::json::parse(row).at("frame").get<int>();
  int frame = 0;
  if (std::from_chars(row.data(), row.data() + row.size(), frame).ec != std::errc())
    throw OutputConflict("a row of metrics begins with no frame");
  return frame;
}

// Frames that are known from another file stay as they are there.
void add_rows(std::string_view text, const fs::path& file, Rows& rows) {
  const bool as_lines = are_lines(file);
  if (!as_lines) {
    const std::string header(text.substr(0, text.find('\n') + 1));
    if (rows.header.empty()) rows.header = header;
    if (header != rows.header)
      throw OutputConflict(
          fmt::format("{} has other columns than the metrics of other shards", file.string()));
    text.remove_prefix(header.size());
  }
  std::map<int, std::string> here;
  for (const std::string_view line : split(text, '\n'))
    if (!line.empty()) here[frame_of(line, as_lines)] += fmt::format("{}\n", line);
  rows.by_frame.merge(here);
}

Rows rows_of(const std::vector<ShardFolder>& parts, const fs::path& file) {
  Rows rows;
  bool any = false;
  for (const ShardFolder& part : parts)
    for (const FilmRecord& record : part.manifest.metrics) {
      const fs::path there = part.folder / record.file;
      if (there.extension() != file.extension()) continue;
      any = true;
      const std::optional<std::string> bytes = bytes_of_file(there);
      if (bytes && content_hash_of(*bytes) == record.content) add_rows(*bytes, there, rows);
    }
  if (!any)
    throw BadRequest(fmt::format("no shard has kept metrics as {}: taut render --shard i/n --metrics FILE{}",
                                 file.extension().string(), file.extension().string()));
  return rows;
}

}  // namespace

std::vector<int> merge_metrics(const std::vector<ShardFolder>& parts, FrameFolder& folder,
                               const fs::path& into, const fs::path& file) {
  const std::vector<int> frames = all_frames(folder.manifest().frame_count);
  SideFile wanted = side_file(&Manifest::metrics, file, into, frames);
  if (is_made(wanted, &folder.manifest())) return {};
  const Rows rows = rows_of(parts, file);
  std::vector<int> missing;
  std::string text = rows.header;
  for (const int frame : frames) {
    const auto found = rows.by_frame.find(frame);
    if (found == rows.by_frame.end())
      missing.push_back(frame);
    else
      text += found->second;
  }
  if (!missing.empty()) return missing;
  const Book book = folder.book();
  leave_text(wanted, book, text);
  std::erase_if(book.manifest->metrics, [&](const FilmRecord& record) {
    const fs::path part = fs::path(record.file).filename();
    return record.file != wanted.record.file && part.extension() == file.extension() &&
           shard_file_name(part.string()).has_value();
  });
  book.save();
  return {};
}

}  // namespace taut
