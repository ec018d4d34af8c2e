#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "methods/registry.h"
#include "program.h"

// Completions and manual pages, as shells and man read them.

namespace taut::testing {
namespace {

namespace fs = std::filesystem;
using Offered = std::set<std::string>;

bool there_is(const std::string& program) {
  return run_program("/bin/sh", {"-c", "command -v " + program}).status == 0;
}

Offered offered_lines(const std::string& text) {
  Offered lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.insert(line);
  return lines;
}

// All flags that a help shows, with their dashes.
Offered flags_in(const std::string& help) {
  const std::regex flag("--?[a-z][a-z-]*");
  Offered flags;
  std::istringstream stream(help);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with("  -")) continue;
    const std::string names = line.substr(2, line.find_first_of(" ", 2) - 2);
    for (std::sregex_iterator match(names.begin(), names.end(), flag), end; match != end; ++match)
      flags.insert(match->str());
  }
  return flags;
}

std::vector<std::string> verbs_in_the_help() {
  const std::string help = taut({"--help"}).out;
  const std::regex verb("\n  ([a-z]+)  ");
  const std::string verbs = help.substr(help.find("Subcommands:"));
  std::vector<std::string> names;
  for (std::sregex_iterator match(verbs.begin(), verbs.end(), verb), end; match != end; ++match)
    names.push_back((*match)[1]);
  return names;
}

class BashCompletionsTest : public ::testing::Test {
 protected:
  // What bash would offer for the last of some words.
  Offered offered(const std::vector<std::string>& words) const {
    std::string script = "source '" + file_ + "'\nCOMP_WORDS=('" TAUT_PROGRAM "'";
    for (const std::string& word : words) script += " '" + word + "'";
    script += ")\nCOMP_CWORD=" + std::to_string(words.size()) +
              "\n_taut '" TAUT_PROGRAM "'\n[ ${#COMPREPLY[@]} -eq 0 ] || printf '%s\\n' \"${COMPREPLY[@]}\"";
    const Ran ran = run_program("bash", {"-c", script}, {}, folder_.path());
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    return offered_lines(ran.out);
  }

  TemporaryFolder folder_;
  std::string file_ = folder_.write("taut.bash", taut({"generate", "completions", "bash"}).out);
};

TEST_F(BashCompletionsTest, OfVerbsAreThoseOfTheHelp) {
  const std::vector<std::string> verbs = verbs_in_the_help();
  EXPECT_GT(verbs.size(), 10U);
  EXPECT_EQ(offered({""}), Offered(verbs.begin(), verbs.end()));
  EXPECT_EQ(offered({"st"}), (Offered{"still", "strip", "stability"}));
  EXPECT_EQ(offered({"--v"}), (Offered{"--version"}));
}

TEST_F(BashCompletionsTest, OfFlagsAreThoseOfEveryVerbsHelp) {
  for (const std::string& verb : verbs_in_the_help()) {
    Offered flags = flags_in(taut({verb, "--help"}).out);
    // The help says --captions alone, which --no-captions is the other side of.
    if (flags.contains("--captions")) flags.insert("--no-captions");
    EXPECT_GT(flags.size(), 1U) << verb;
    EXPECT_EQ(offered({verb, "-"}), flags) << verb;
  }
}

TEST_F(BashCompletionsTest, OfScenesAreNamesAndFiles) {
  folder_.write("my-own.toml", small_scene());
  folder_.write("notes.txt", "");
  fs::create_directory(folder_.path() / "more");
  const Offered all = offered({"render", ""});
  Offered expected{"my-own.toml", "more"};
  for (const auto& entry : fs::directory_iterator(TAUT_SCENE_FOLDER))
    if (entry.path().extension() == ".toml") expected.insert(entry.path().stem().string());
  EXPECT_EQ(all, expected);
  EXPECT_EQ(offered({"check", "bola", "my"}), (Offered{"my-own.toml"}));
  EXPECT_EQ(offered({"new", "rope", "--like", "bo"}), (Offered{"bola"}));
}

TEST_F(BashCompletionsTest, OfMethodsAreThoseOfTheRegistry) {
  Offered methods;
  for (const Method& method : all_methods()) methods.insert(std::string(method.name));
  EXPECT_EQ(offered({"render", "bola", "--method", ""}), methods);
  EXPECT_EQ(offered({"render", "bola", "--method", "=", "sh"}), (Offered{"shake"}));
  EXPECT_EQ(offered({"render", "bola", "--method", "="}), methods);
  EXPECT_EQ(offered({"compare", "bola", "--methods", "euler,sh"}), (Offered{"euler,shake"}));
  EXPECT_EQ(offered({"stability", "--methods", "xpbd,rat"}), (Offered{"xpbd,rattle"}));
}

TEST_F(BashCompletionsTest, OfOtherValues) {
  EXPECT_EQ(offered({"render", "bola", "--quality", ""}), (Offered{"draft", "standard", "fine"}));
  EXPECT_EQ(offered({"render", "bola", "--colour", "s"}), (Offered{"strain", "speed"}));
  EXPECT_EQ(offered({"export", "bola", "--format", ""}),
            (Offered{"csv", "npz", "vtp", "obj", "ply", "pc2", "usda", "glb"}));
  EXPECT_EQ(offered({"export", "bola", "--table", "l"}), (Offered{"links"}));
  EXPECT_EQ(offered({"list", ""}), (Offered{"scenes", "methods", "keys", "formats", "gl"}));
  EXPECT_EQ(offered({"new", "rope", "--kind", ""}), (Offered{"chain", "sheet", "ragdoll"}));
  EXPECT_EQ(offered({"chart", "--errors", "strain,e"}), (Offered{"strain,energy"}));
  EXPECT_EQ(offered({"render", "bola", "--fps", ""}), Offered());
}

TEST_F(BashCompletionsTest, OfKeysAreThoseOfTheScene) {
  EXPECT_EQ(offered({"render", "bola", "--set", "world.d"}), (Offered{"world.duration=", "world.drag="}));
  EXPECT_EQ(offered({"render", "curtain", "--set", "sheet.cloth.break"}),
            (Offered{"sheet.cloth.break_stretch=", "sheet.cloth.break_tension=", "sheet.cloth.break_at="}));
  EXPECT_EQ(offered({"check", "curtain", "--set", "ragdoll."}), Offered()) << "it has none";
  EXPECT_TRUE(offered({"chart", "--set", "chain."}).contains("chain.*.links="));
  EXPECT_TRUE(offered({"render", "curtain", "--set", "sheet.cloth.dia"})
                  .contains("sheet.cloth.diagonals.stiffness="));
  EXPECT_EQ(offered({"render", "bola", "--set", "world.drag", "=", "0"}), Offered());
}

// Each of them can be set: an error is about the value, never the key.
TEST(Completions, OfKeysAreThoseThatCanBeSet) {
  const TemporaryFolder folder;
  int tried = 0;
  for (const std::string scene : {"curtain", "ragdoll-drop", "poncho"}) {
    for (const std::string& key : offered_lines(taut({"generate", "words", "keys", scene}).out)) {
      if (++tried % 7 != 0) continue;
      const Ran ran = taut({"check", scene, "--set", key + "\"?\""});
      EXPECT_EQ(ran.err.find("unknown key"), std::string::npos) << ran.err;
    }
  }
  EXPECT_GT(tried, 300);
}

TEST(Completions, AreReadByTheirShells) {
  const TemporaryFolder folder;
  int tried = 0;
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    const Ran made = taut({"generate", "completions", shell});
    ASSERT_EQ(made.status, 0) << made.err;
    if (!there_is(shell)) continue;
    const Ran read = run_program(shell, {"-n", folder.write(shell, made.out)});
    EXPECT_EQ(read.status, 0) << shell << ": " << read.err;
    EXPECT_EQ(read.err, "") << shell;
    ++tried;
  }
  EXPECT_GT(tried, 0);
}

// fish tells what it would offer.
TEST(Completions, OfFish) {
  if (!there_is("fish")) GTEST_SKIP() << "there is no fish here";
  const TemporaryFolder folder;
  const std::string file = folder.write("taut.fish", taut({"generate", "completions", "fish"}).out);
  const auto offered = [&](const std::string& line) {
    const Ran ran =
        run_program("fish",
                    {"--no-config", "-c",
                     "source " + file + "; complete -C'" + line + "' | string split -f1 \\t; or true"},
                    {{"HOME", folder.path().string()},
                     {"PATH", fs::path(TAUT_PROGRAM).parent_path().string() + ":/usr/bin:/bin"}},
                    folder.path());
    EXPECT_EQ(ran.status, 0) << ran.err;
    return offered_lines(ran.out);
  };
  EXPECT_EQ(offered("taut st"), (Offered{"still", "strip", "stability"}));
  EXPECT_EQ(offered("taut render bola --quality "), (Offered{"draft", "standard", "fine"}));
  EXPECT_EQ(offered("taut render bol"), (Offered{"bola"}));
  EXPECT_EQ(offered("taut compare bola --methods euler,ratt"), (Offered{"euler,rattle"}));
}

class ManPagesTest : public ::testing::Test {
 protected:
  static std::string plain(const fs::path& page) {
    const Ran ran = run_program("/bin/sh", {"-c", "man -E UTF-8 -l '" + page.string() + "' | col -b"},
                                {{"MANWIDTH", "200"}, {"LC_ALL", "C.UTF-8"}});
    return ran.out;
  }

  TemporaryFolder folder_;
};

TEST_F(ManPagesTest, AreOneForTheProgramAndOneAVerb) {
  ASSERT_EQ(taut({"generate", "man", folder_ / "man1"}).status, 0);
  Offered pages, expected{"taut.1"};
  for (const auto& entry : fs::directory_iterator(folder_.path() / "man1"))
    pages.insert(entry.path().filename().string());
  for (const std::string& verb : verbs_in_the_help()) expected.insert("taut-" + verb + ".1");
  EXPECT_EQ(pages, expected);
}

TEST_F(ManPagesTest, HaveNothingThatManWarnsOf) {
  if (!there_is("man")) GTEST_SKIP() << "there is no man here";
  ASSERT_EQ(taut({"generate", "man"}, {}, folder_.path()).status, 0);
  for (const auto& entry : fs::directory_iterator(folder_.path())) {
    const Ran ran =
        run_program("man", {"--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", entry.path().string()},
                    {{"LC_ALL", "C.UTF-8"}});
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(ran.err, "") << entry.path();
  }
}

TEST_F(ManPagesTest, SayWhatTheHelpSays) {
  if (!there_is("man") || !there_is("col")) GTEST_SKIP() << "there is no man here";
  ASSERT_EQ(taut({"generate", "man"}, {}, folder_.path()).status, 0);
  const std::string still = plain(folder_.path() / "taut-still.1");
  for (const std::string& flag : flags_in(taut({"still", "--help"}).out))
    EXPECT_NE(still.find(flag), std::string::npos) << flag << "\n" << still;
  EXPECT_NE(still.find("taut still curtain --at 2.5s -o curtain.png"), std::string::npos) << still;
  EXPECT_NE(still.find("taut still SCENE -o FILE [flags]"), std::string::npos) << still;
  EXPECT_NE(still.find("TAUT_SIMD"), std::string::npos) << still;
}

TEST(Generate, IsLeftOutOfTheHelp) {
  EXPECT_EQ(taut({"--help"}).out.find("generate"), std::string::npos);
  EXPECT_EQ(taut({"generate", "--help"}).status, 0);
}

TEST(Generate, AFolderThatCannotBeMade) {
  const TemporaryFolder folder;
  const Ran ran = taut({"generate", "man", folder.write("file", "") + "/man1"});
  EXPECT_EQ(ran.status, 1) << ran.err;
  EXPECT_NE(ran.err.find("man1"), std::string::npos) << ran.err;
}

TEST(Version, SaysWhatItWasBuiltWith) {
  const std::string text = taut({"--version"}).out;
  EXPECT_TRUE(text.starts_with("taut ")) << text;
  EXPECT_EQ(std::ranges::count(text, '\n'), 5) << text;
  for (const char* part :
       {"\ncommit ", "flags ", "\nmoves as ", "\nvector instructions: ", "scalar", "\nOpenGL: "})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

}  // namespace
}  // namespace taut::testing
