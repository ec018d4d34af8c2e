#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/failure.h"
#include "base/json_text.h"
#include "choices.h"
#include "command_line.h"
#include "exit_status.h"
#include "host/scene_folder.h"
#include "host/standard_streams.h"
#include "output/atomic_file.h"
#include "scene/scene.h"
#include "scene_templates.h"
#include "verbs.h"

namespace taut {
namespace {

namespace fs = std::filesystem;

struct NewFlags {
  std::string name, kind, like;
  bool json = false, quiet = false;
};

std::vector<std::string_view> kinds() {
  std::vector<std::string_view> kinds;
  kinds.reserve(scene_templates().size());
  for (const SceneTemplate& each : scene_templates()) kinds.push_back(each.kind);
  return kinds;
}

// A name that a file, a folder of frames and a command line can have without quotes.
void check_name(const std::string& name) {
  constexpr std::size_t longest = 64;
  const auto fits = [](char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
           (letter >= '0' && letter <= '9') || letter == '-' || letter == '_';
  };
  if (name.empty() || name.front() == '-' || name.size() > longest || !std::ranges::all_of(name, fits))
    throw BadRequest(fmt::format(
        "a scene's name is made of letters, digits, - and _, at most {}; the file gets .toml behind it; not "
        "\"{}\"",
        longest, name));
}

const SceneTemplate& template_of(const std::string& kind) {
  const std::vector<std::string_view> known = kinds();
  const auto found = std::ranges::find(known, kind);
  if (found == known.end()) not_one_of("--kind", kind, known);
  return scene_templates()[static_cast<std::size_t>(found - known.begin())];
}

std::string with_name(std::string_view text, const std::string& name) {
  constexpr std::string_view placeholder = "NAME";
  std::string named(text);
  return named.replace(named.find(placeholder), placeholder.size(), name);
}

// The text of a scene as it is. Throws BadRequest where it would be no scene in the current folder.
std::string copy_of(const std::string& scene, const std::string& name) {
  const fs::path file = find_scene(scene);
  load_scene(file);
  const std::string text = fmt::format("# A copy of {}.\n{}", file.filename().string(), scene_text(file));
  parse_scene(text, name + ".toml");
  return text;
}

std::vector<std::string> commands_to_try(const std::string& file, const NewFlags& flags,
                                         const SceneTemplate& begun) {
  std::vector<std::string> commands{fmt::format("taut still {} --at 1s -o {}.png", file, flags.name),
                                    fmt::format("taut render {} --film {}.mp4", file, flags.name)};
  if (flags.like.empty())
    commands.push_back(
        fmt::format("taut render {} {} --no-frames --film {}-2.mp4", file, begun.look, flags.name));
  commands.push_back(fmt::format("taut check {} --explain", file));
  return commands;
}

int make_scene(const NewFlags& flags) {
  check_name(flags.name);
  const std::string kind = flags.kind.empty() ? "chain" : flags.kind;
  const SceneTemplate& begun = template_of(kind);
  const std::string text =
      flags.like.empty() ? with_name(begun.text, flags.name) : copy_of(flags.like, flags.name);
  const fs::path file = flags.name + ".toml";
  std::error_code error;
  if (fs::exists(fs::symlink_status(file, error)))
    throw OutputConflict(fmt::format("{} is there already, and stays as it is", file.string()));
  write_file(file, text);
  const std::vector<std::string> next = commands_to_try(file.string(), flags, begun);
  if (flags.json) {
    print_result("{}\n", json_text(nlohmann::ordered_json{{"file", file.string()}, {"next", next}}, 2));
  } else if (!flags.quiet) {
    tell("{} is written. Next:\n", file.string());
    for (const std::string& command : next) print_result("{}\n", command);
  }
  return exit_done;
}

}  // namespace

void add_new(CommandLine& program) {
  Verb* verb =
      program.add_subcommand("new", "A scene to begin with, with comments that say what its keys do");
  const auto flags = std::make_shared<NewFlags>();
  verb->add_option("NAME", flags->name,
                   "Its name: NAME.toml is written into the current folder, if it isn't there")
      ->required();
  Flag* kind = verb->add_option("--kind", flags->kind, "What it is made of: chain, sheet or ragdoll [chain]")
                   ->one_of(as_words(kinds()));
  verb->add_option("--like", flags->like, "A copy of this scene instead, a file or one of `taut list scenes`")
      ->names_a(ValueKind::scene)
      ->excludes(kind);
  verb->add_flag("--json", flags->json, "Print the file's name and what to try next as JSON");
  verb->add_flag("--quiet", flags->quiet, "Don't say what to try next");
  verb->footer(
      "Example:\n  taut new rope && taut render rope.toml --film rope.mp4\n  taut new flag-2 --like flag");
  verb->action([flags] { return make_scene(*flags); });
}

}  // namespace taut
