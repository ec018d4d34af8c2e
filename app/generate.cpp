#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string_view>

#include "choices.h"
#include "command_line.h"
#include "completions.h"
#include "exit_status.h"
#include "host/build_info.h"
#include "host/scene_folder.h"
#include "host/standard_streams.h"
#include "man_pages.h"
#include "output/atomic_file.h"
#include "scene/scene.h"
#include "verbs.h"

namespace taut {
namespace {

constexpr std::array<std::string_view, 3> generated{"completions", "man", "words"};

struct GenerateFlags {
  std::string what, which, scene;
};

void generate_completions(const ProgramFacts& program, const std::string& shell) {
  const auto shells = completed_shells();
  if (std::ranges::find(shells, shell) == shells.end()) not_one_of("the shell", shell, shells);
  write_result(completions(program, shell));
}

void generate_man_pages(const ProgramFacts& program, const std::filesystem::path& folder) {
  make_folder(folder);
  for (const ManPage& page : man_pages(program, version())) write_file(folder / page.file, page.text);
}

// What a scene holds, where there is one by that name.
std::string text_of(const std::string& scene) {
  if (scene.empty()) return {};
  try {
    return scene_text(find_scene(scene));
  } catch (const BadRequest&) {
    return {};  // the shell asks with whatever stands there so far
  }
}

// For completions: one a line, and nothing read but the folders and the text of a scene.
void generate_words(const std::string& of, const std::string& scene) {
  constexpr std::array<std::string_view, 2> known{"scenes", "keys"};
  if (of == "scenes")
    for (const std::filesystem::path& file : all_scene_files()) print_result("{}\n", file.stem().string());
  else if (of == "keys")
    for (const std::string& key : settable_keys(text_of(scene))) print_result("{}=\n", key);
  else
    not_one_of("words", of, known);
}

int generate(const CommandLine& program, const GenerateFlags& flags) {
  if (flags.what == "completions")
    generate_completions(program.facts(), flags.which);
  else if (flags.what == "man")
    generate_man_pages(program.facts(), flags.which.empty() ? "." : flags.which);
  else if (flags.what == "words")
    generate_words(flags.which, flags.scene);
  else
    not_one_of("what generate makes", flags.what, generated);
  return exit_done;
}

}  // namespace

void add_generate(CommandLine& program) {
  Verb* verb =
      program.add_subcommand("generate", "What packages hold beside the program, made from its help");
  const auto flags = std::make_shared<GenerateFlags>();
  verb->add_option("WHAT", flags->what,
                   "completions: those of a shell, on stdout; man: manual pages; words: for completions")
      ->required();
  verb->add_option("WHICH", flags->which,
                   "bash, zsh or fish; the folder for manual pages [.]; scenes or keys");
  verb->add_option("SCENE", flags->scene, "Of which the keys are");
  verb->footer(
      "Example:\n  taut generate completions bash > ~/.local/share/bash-completion/completions/taut\n"
      "  taut generate man ~/.local/share/man/man1");
  verb->hide();
  verb->action([&program, flags] { return generate(program, *flags); });
}

}  // namespace taut
