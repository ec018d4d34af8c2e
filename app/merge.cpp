#include "frames/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/failure.h"
#include "base/json_text.h"
#include "command_line.h"
#include "exit_status.h"
#include "frames/frame_selection.h"
#include "host/standard_streams.h"
#include "interrupted.h"
#include "output/film.h"
#include "study/merge_cases.h"
#include "verbs.h"

namespace taut {
namespace {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;

struct MergeFlags {
  std::vector<std::string> folders;
  std::string output, film, metrics;
  bool json = false, quiet = false;
};

Json frames_to_json(const MergedFrames& merged, const MergeFlags& flags) {
  Json json{{"there", merged.count},
            {"missing", merged.missing},
            {"unmeasured", merged.unmeasured},
            {"film", nullptr},
            {"metrics", nullptr}};
  if (merged.film_made) json["film"] = flags.film;
  if (merged.metrics_made) json["metrics"] = flags.metrics;
  return json;
}

Json cases_to_json(const std::vector<MergedCases>& joined) {
  Json json = Json::array();
  for (const MergedCases& merged : joined)
    json.push_back({{"file", merged.file.string()},
                    {"cases", merged.count},
                    {"shards", merged.shards},
                    {"holes", merged.holes}});
  return json;
}

MergedFrames merge_all_frames(const std::vector<fs::path>& folders, const fs::path& into,
                              const MergeFlags& flags, const StopTest& stop) {
  MergeWishes wishes;
  if (!flags.film.empty()) wishes.film = flags.film;
  if (!flags.metrics.empty()) wishes.metrics = flags.metrics;
  MergedFrames merged = merge_frames(folders, into, wishes, stop);
  if (!merged.missing.empty())
    tell("taut: {}: frames {} are missing\n", into.string(), selection_text(merged.missing));
  if (!merged.unmeasured.empty())
    tell("taut: {}: metrics of frames {} are missing\n", into.string(), selection_text(merged.unmeasured));
  if (!flags.quiet)
    tell("{}: {} frames{}{}\n", into.string(), merged.count,
         merged.film_made ? ", film in " + flags.film : "",
         merged.metrics_made ? ", metrics in " + flags.metrics : "");
  return merged;
}

std::vector<MergedCases> merge_all_cases(const std::vector<fs::path>& folders, const fs::path& into,
                                         const MergeFlags& flags) {
  std::vector<MergedCases> joined = merge_cases(folders, into);
  for (const MergedCases& merged : joined) {
    for (const std::string& hole : merged.holes) tell("taut: {}: {}\n", merged.file.string(), hole);
    if (!flags.quiet)
      tell("{}: {} cases of {} shards; the same command without --shard draws them\n", merged.file.string(),
           merged.count, merged.shards);
  }
  return joined;
}

int merge(const MergeFlags& flags) {
  const std::vector<fs::path> folders(flags.folders.begin(), flags.folders.end());
  for (const fs::path& folder : folders)
    if (!fs::is_directory(folder)) throw BadRequest(fmt::format("there is no folder {}", folder.string()));
  if (folders.size() > 1 && flags.output.empty())
    throw BadRequest("with several folders -o says which one they are joined in");
  const fs::path into = flags.output.empty() ? folders.front() : fs::path(flags.output);
  const bool frames = std::ranges::any_of(folders, holds_frames);
  if (!frames && !holds_cases(folders))
    throw BadRequest(fmt::format("{} holds neither frames nor cases of shards", folders.front().string()));
  if (!frames && !(flags.film.empty() && flags.metrics.empty()))
    throw BadRequest("--film and --metrics are for frames, and there are none");
  if (!flags.film.empty()) require_film_encoder();
  const InterruptWatch interrupts(end_at_once);
  return unless_interrupted(interrupts, "running the same again goes on", [&] {
    std::optional<MergedFrames> pictures;
    if (frames) pictures = merge_all_frames(folders, into, flags, stop_test(interrupts));
    const std::vector<MergedCases> cases = merge_all_cases(folders, into, flags);
    if (flags.json)
      print_result("{}\n", json_text(Json{{"folder", into.string()},
                                          {"frames", pictures ? frames_to_json(*pictures, flags) : Json()},
                                          {"cases", cases_to_json(cases)}},
                                     2));
    const bool whole = (!pictures || (pictures->missing.empty() && pictures->unmeasured.empty())) &&
                       std::ranges::all_of(cases, [](const MergedCases& each) { return each.holes.empty(); });
    return whole ? exit_done : exit_incomplete;
  });
}

}  // namespace

void add_merge(CommandLine& program) {
  Verb* verb = program.add_subcommand("merge", "Join what shards have made, and name what is missing");
  const auto flags = std::make_shared<MergeFlags>();
  verb->add_option("FOLDER", flags->folders, "The folder that shards have filled together, or one of each")
      ->names_a(ValueKind::folder)
      ->required();
  verb->add_option("-o,--output", flags->output, "Join them in this folder [the one that is named]")
      ->names_a(ValueKind::folder);
  verb->add_option("--film", flags->film, "Make a film of the frames when all are there, as render does")
      ->names_a(ValueKind::file);
  verb->add_option("--metrics", flags->metrics,
                   "Join the metrics that the shards have kept, as .csv or .jsonl as they are")
      ->names_a(ValueKind::file);
  verb->add_flag("--json", flags->json, "Print what was joined as JSON on stdout");
  verb->add_flag("--quiet", flags->quiet, "Say only what is missing");
  verb->footer(
      "Status 3: something is missing. Joining again changes nothing.\n\n"
      "Example:\n  for i in 1 2 3 4; do taut render curtain --shard $i/4 -o frames & done; wait\n"
      "  taut merge frames --film curtain.mp4");
  verb->action([flags] { return merge(*flags); });
}

}  // namespace taut
