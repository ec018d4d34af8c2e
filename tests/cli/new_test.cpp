#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "program.h"
#include "scene/scene.h"

namespace taut::testing {
namespace {

namespace fs = std::filesystem;

class NewTest : public ::testing::Test {
 protected:
  Ran make(std::vector<std::string> words) const {
    words.insert(words.begin(), "new");
    return taut(words, {}, folder_.path());
  }
  void expect_refused(const std::vector<std::string>& words, int status, const std::string& said) const {
    const std::size_t before = folder_.entries();
    const Ran ran = make(words);
    EXPECT_EQ(ran.status, status) << ran.err;
    EXPECT_NE(ran.err.find(said), std::string::npos) << ran.err;
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(folder_.entries(), before);
  }

  TemporaryFolder folder_;
};

class NewKindTest : public NewTest, public ::testing::WithParamInterface<std::string> {};

TEST_P(NewKindTest, IsASceneWithoutNotesThatIsDrawnAtOnce) {
  const Ran ran = make({"first", "--kind", GetParam()});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Scene scene = load_scene(folder_ / "first.toml");
  EXPECT_EQ(scene.title, "first");
  EXPECT_TRUE(scene.notes.empty()) << scene.notes.front();
  const Ran checked = taut({"check", "first.toml", "--run"}, {}, folder_.path());
  EXPECT_EQ(checked.status, 0) << checked.err;
  const Ran drawn =
      taut({"render", "first.toml", "--frames", "1,30", "--size", "64x48", "-o", "frames", "--quiet"}, {},
           folder_.path());
  EXPECT_EQ(drawn.status, 0) << drawn.err;
  EXPECT_EQ(drawn.err, "");
  EXPECT_TRUE(fs::exists(folder_.path() / "frames/frame-000030.png"));
}

// What the comments leave to be uncommented is right, too.
TEST_P(NewKindTest, MayBeUncommented) {
  ASSERT_EQ(make({"first", "--kind", GetParam()}).status, 0);
  const std::string text = read_file(folder_ / "first.toml");
  const std::string whole = std::regex_replace(text, std::regex("\n# ([a-z_\\[])"), "\n$1");
  EXPECT_NE(whole, text);
  const Scene scene = parse_scene(whole, "whole.toml");
  EXPECT_TRUE(scene.notes.empty()) << scene.notes.front();
}

TEST_P(NewKindTest, WhatItSaysIsNextWorks) {
  const Ran ran = make({"first", "--kind", GetParam()});
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.err, "first.toml is written. Next:\n");
  // The same commands, as the shell reads them, made small.
  const std::string small =
      "set -e; taut() { case $1 in still) '" TAUT_PROGRAM "' \"$@\" --size 64x48 ;; render) '" TAUT_PROGRAM
      "' \"$@\" --size 64x48 --frames 1-3 ;; *) '" TAUT_PROGRAM "' \"$@\" ;; esac; }\n";
  const Ran next = run_program("/bin/sh", {"-c", small + ran.out}, {}, folder_.path());
  EXPECT_EQ(next.status, 0) << ran.out << next.err;
  EXPECT_TRUE(fs::exists(folder_.path() / "first.png"));
  EXPECT_TRUE(fs::exists(folder_.path() / "first.mp4"));
}

INSTANTIATE_TEST_SUITE_P(Kinds, NewKindTest, ::testing::Values("chain", "sheet", "ragdoll"),
                         [](const auto& test) { return test.param; });

TEST_F(NewTest, IsAChainUnlessItIsSaid) {
  ASSERT_EQ(make({"a"}).status, 0);
  ASSERT_EQ(make({"b", "--kind", "chain"}).status, 0);
  const std::string plain = read_file(folder_ / "a.toml"), chain = read_file(folder_ / "b.toml");
  EXPECT_EQ(std::regex_replace(plain, std::regex("\"a\""), "\"b\""), chain);
}

TEST_F(NewTest, LikeAnotherHasItsText) {
  ASSERT_EQ(make({"mine", "--like", "bola"}).status, 0);
  EXPECT_EQ(read_file(folder_ / "mine.toml"),
            "# A copy of bola.toml.\n" + read_file(fs::path(TAUT_SCENE_FOLDER) / "bola.toml"));
  EXPECT_EQ(make({"again", "--like", "mine.toml"}).status, 0);
}

TEST_F(NewTest, NeverOverwrites) {
  folder_.write("mine.toml", "as it was");
  expect_refused({"mine"}, 4, "mine.toml is there already");
  EXPECT_EQ(read_file(folder_ / "mine.toml"), "as it was");
  // A link that leads nowhere is somebody's, too.
  fs::create_symlink("nowhere", folder_.path() / "link.toml");
  expect_refused({"link"}, 4, "link.toml is there already");
}

TEST_F(NewTest, NamesThatAreNone) {
  for (const std::string name : {"../up", "a/b", "a.toml", "a b", "ä", "-", "~", "a\nb"})
    expect_refused({"--", name}, 2, "letters, digits");
  expect_refused({std::string(65, 'a')}, 2, "at most 64");
  expect_refused({""}, 2, "NAME needs a value");
  expect_refused({}, 2, "NAME");
  expect_refused({"a", "b"}, 2, "one word too many");
}

TEST_F(NewTest, ScenesThatAreNoneAreNotCopied) {
  folder_.write("bad.toml", "[world]\ngravty = 1\n");
  expect_refused({"mine", "--like", "bad.toml"}, 2, "unknown key \"gravty\"");
  expect_refused({"mine", "--like", "none.toml"}, 2, "there is no scene file none.toml");
  expect_refused({"mine", "--like", "bola", "--kind", "chain"}, 2, "excludes");
}

TEST_F(NewTest, AFolderThatTakesNoFile) {
  const Ran ran = taut({"new", "mine"}, {}, "/proc");
  EXPECT_EQ(ran.status, 1) << ran.err;
  EXPECT_EQ(ran.out, "");
}

}  // namespace
}  // namespace taut::testing
