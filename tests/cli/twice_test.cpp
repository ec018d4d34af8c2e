#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "program.h"

// The same command twice is quiet success, always; and no two programs work in one folder at once.

namespace taut::testing {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

class TwiceTest : public ::testing::Test {
 protected:
  // Two equal commands, from a folder of their own; the second has nothing left to do.
  void expect_twice(const Words& words) {
    for (int again = 0; again < 2; ++again) {
      const Ran ran = taut(words, environment_, folder_.path());
      EXPECT_EQ(ran.status, 0) << words[0] << " " << again << "\n" << ran.err;
    }
  }

  TemporaryFolder folder_;
  std::string scene_ = folder_.write("small.toml", small_scene());
  Environment environment_{{"TAUT_CACHE", folder_ / "cache"}};
};

TEST_F(TwiceTest, AnyVerb) {
  expect_twice({"render", "small.toml", "--size", "64x48"});
  expect_twice({"render", "small.toml", "--size", "64x48", "--film", "small.mp4"});
  expect_twice({"render", "small.toml", "--size", "64x48", "--no-frames", "--film", "alone.mp4"});
  expect_twice({"render", "small.toml", "--size", "64x48", "-o", "new/frames", "--film", "new/film.webm"});
  expect_twice({"render", "small.toml", "--size", "64x48", "-o", "x", "--film", "./x/../y/film.gif"});
  expect_twice({"render", "small.toml", "--size", "64x48", "-o", "x", "--film", "x/film.webp"});
  expect_twice(
      {"render", "small.toml", "--size", "64x48", "-o", "x", "--frames", "3-9", "--film", "part.mp4"});
  expect_twice({"render", "small.toml", "--size", "64x48", "-o", "parts", "--shard", "1/2"});
  expect_twice({"compare", "small.toml", "--methods", "xpbd,verlet", "--size", "64x48", "--film", "c.mp4"});
  expect_twice({"simulate", "small.toml", "-o", "motion"});
  expect_twice({"render", "--motion", "motion", "--size", "64x48", "-o", "drawn", "--film", "drawn.mp4"});
  expect_twice({"still", "small.toml", "--at", "0.5", "--size", "64x48", "-o", "still.png"});
  expect_twice({"strip", "small.toml", "--count", "2", "--size", "64x48", "-o", "strip.png"});
  expect_twice({"sag", "hanging-chain-two-pins", "--passes", "1,4", "--size", "64x48", "-o", "sag"});
  expect_twice({"chart", "pendulum", "--methods", "rattle", "--horizon", "0.1s", "-o", "chart"});
  expect_twice({"stability", "level-chain", "--methods", "xpbd", "--axes", "step,mass-ratio", "--grid", "2x2",
                "--duration", "0.1", "-o", "maps"});
  expect_twice({"export", "small.toml", "-o", "small.csv"});
  expect_twice({"export", "small.toml", "-o", "small.npz"});
  expect_twice({"export", "small.toml", "--format", "vtp", "-o", "small-vtp"});
  expect_twice({"merge", "out/small"});
  expect_twice({"merge", "out/small", "--film", "merged.mp4"});
  expect_twice({"verify", "out/small"});
}

// What the first left is not touched by the second.
TEST_F(TwiceTest, TheSecondWritesNothing) {
  const Words words{"render", "small.toml", "--size", "64x48", "-o", "frames", "--film", "film.mp4"};
  ASSERT_EQ(taut(words, {}, folder_.path()).status, 0);
  const auto film = fs::last_write_time(folder_ / "film.mp4");
  const auto frame = fs::last_write_time(folder_ / "frames/frame-000001.png");
  ASSERT_EQ(taut(words, {}, folder_.path()).status, 0);
  EXPECT_EQ(fs::last_write_time(folder_ / "film.mp4"), film);
  EXPECT_EQ(fs::last_write_time(folder_ / "frames/frame-000001.png"), frame);
}

// A program that ended between the manifest's film and the film's name: the film is made again.
TEST_F(TwiceTest, AFilmThatOnlyTheManifestKnowsIsMadeAgain) {
  const Words words{"render", "small.toml", "--size", "64x48", "-o", "frames", "--film", "film.mp4"};
  ASSERT_EQ(taut(words, {}, folder_.path()).status, 0);
  const std::string film = read_file(folder_ / "film.mp4");
  fs::remove(folder_ / "film.mp4");
  ASSERT_EQ(taut(words, {}, folder_.path()).status, 0);
  EXPECT_TRUE(read_file(folder_ / "film.mp4") == film);
}

TEST_F(TwiceTest, AFilmOfUnknownOriginStays) {
  for (const Words& words :
       {Words{"render", "small.toml", "--size", "64x48", "-o", "frames", "--film", "film.mp4"},
        Words{"render", "small.toml", "--size", "64x48", "--no-frames", "--film", "film.mp4"},
        Words{"merge", "frames", "--film", "film.mp4"}}) {
    if (words[0] == "merge") {
      ASSERT_EQ(taut({"render", "small.toml", "--size", "64x48", "-o", "frames"}, {}, folder_.path()).status,
                0);
    }
    folder_.write("film.mp4", "a wedding");
    EXPECT_EQ(taut(words, {}, folder_.path()).status, 4);
    EXPECT_EQ(read_file(folder_ / "film.mp4"), "a wedding");
  }
}

// Two with different settings at once: one works, the other says so, and nothing is mixed.
TEST_F(TwiceTest, OneRunAtATimeInAFolder) {
  Ran first, second;
  const auto render = [&](const std::string& drag, Ran& ran) {
    ran = taut({"render", scene_, "--set", "world.duration=30", "--set", "world.drag=" + drag, "--size",
                "64x48", "-o", folder_ / "frames"});
  };
  std::thread other([&] { render("1", first); });
  render("2", second);
  other.join();
  const bool first_won = first.status == 0;
  EXPECT_NE(first.status == 0, second.status == 0) << first.err << second.err;
  const Ran& lost = first_won ? second : first;
  EXPECT_TRUE(lost.status == 1 || lost.status == 4) << lost.err;
  EXPECT_EQ(taut({"verify", folder_ / "frames"}).status, 0);
  EXPECT_FALSE(fs::exists(folder_ / "frames/.manifest.json.lock"));
}

TEST_F(TwiceTest, EqualRunsAtOnceDoNotDisturbEachOther) {
  std::vector<Ran> ran(3);
  std::vector<std::thread> threads;
  for (Ran& one : ran)
    threads.emplace_back([&] { one = taut({"simulate", scene_, "-o", folder_ / "motion"}); });
  for (std::thread& thread : threads) thread.join();
  for (const Ran& one : ran) EXPECT_TRUE(one.status == 0 || one.status == 1) << one.status << one.err;
  EXPECT_EQ(taut({"simulate", scene_, "-o", folder_ / "motion"}).status, 0);
  EXPECT_EQ(taut({"verify", folder_ / "motion", "--deep"}).status, 0);
}

}  // namespace
}  // namespace taut::testing
