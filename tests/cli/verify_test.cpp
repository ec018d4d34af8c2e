#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program.h"

namespace taut::testing {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

// A folder of ten frames and their film, which each test spoils in its own way.
class VerifyTest : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(render("frames", {"--film", folder_ / "frames/film.mp4"}).status, 0); }

  Ran render(const std::string& name, const Words& more = {}) const {
    Words words{"render", scene_, "-o", folder_ / name, "--size", "64x48", "--fps", "10"};
    words.insert(words.end(), more.begin(), more.end());
    return taut(words);
  }
  Ran verify(const Words& more = {}) const {
    Words words{"verify", folder_ / "frames"};
    words.insert(words.end(), more.begin(), more.end());
    return taut(words);
  }
  std::string frame(int number) const {
    return folder_ / ("frames/frame-00000" + std::string(1, static_cast<char>('0' + number)) + ".png");
  }
  void expect_fault(const std::string& text, const Words& more = {}) const {
    const Ran ran = verify(more);
    EXPECT_EQ(ran.status, 5) << ran.err;
    EXPECT_NE(ran.err.find(text), std::string::npos) << ran.err;
  }
  void change_manifest(const std::function<void(Json&)>& change) const {
    Json manifest = Json::parse(read_file(folder_ / "frames/manifest.json"));
    change(manifest);
    folder_.write("frames/manifest.json", manifest.dump());
  }

  TemporaryFolder folder_;
  std::string scene_ = folder_.write("small.toml", small_scene());
};

TEST_F(VerifyTest, WholeOutputIsWhole) {
  for (const Words& more : {Words{}, Words{"--deep"}}) {
    const Ran ran = verify(more);
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_NE(ran.err.find("10 checked"), std::string::npos) << ran.err;
  }
  const Json found = Json::parse(verify({"--json"}).out);
  EXPECT_EQ(found["whole"], true);
  EXPECT_EQ(found["checked"], 10);
}

TEST_F(VerifyTest, FindsAMissingFrame) {
  fs::remove(frame(4));
  expect_fault("frame-000004.png is missing");
}

TEST_F(VerifyTest, FindsATruncatedFrame) {
  fs::resize_file(frame(4), fs::file_size(frame(4)) - 20);
  expect_fault("frame-000004.png is not a whole picture");
}

TEST_F(VerifyTest, FindsSwappedFrames) {
  fs::rename(frame(2), frame(9) + ".other");
  fs::rename(frame(9), frame(2));
  fs::rename(frame(9) + ".other", frame(9));
  const Ran ran = verify();
  EXPECT_EQ(ran.status, 5);
  for (const char* name : {"frame-000002.png is not the picture", "frame-000009.png is not the picture"})
    EXPECT_NE(ran.err.find(name), std::string::npos) << ran.err;
}

// The same size, whole, and another grey in one pixel.
TEST_F(VerifyTest, FindsAnEditedPixel) {
  const Ran edit = run_program("ffmpeg", {"-v", "error", "-y", "-i", frame(5), "-vf",
                                          "drawbox=x=3:y=3:w=1:h=1:color=red", frame(5) + ".png"});
  ASSERT_EQ(edit.status, 0) << edit.err;
  fs::rename(frame(5) + ".png", frame(5));
  expect_fault("frame-000005.png is not the picture");
}

TEST_F(VerifyTest, FindsAFrameOfAnotherScene) {
  ASSERT_EQ(render("other", {"--set", "world.drag=5"}).status, 0);
  fs::copy_file(folder_ / "other/frame-000007.png", frame(7), fs::copy_options::overwrite_existing);
  expect_fault("frame-000007.png is not the picture");
}

// With the other scene's hashes in the manifest, only a second run can tell.
TEST_F(VerifyTest, DeepFindsAFrameOfAnotherSceneThatTheManifestKnows) {
  ASSERT_EQ(render("other", {"--set", "world.drag=5"}).status, 0);
  fs::copy_file(folder_ / "other/frame-000007.png", frame(7), fs::copy_options::overwrite_existing);
  const Json other = Json::parse(read_file(folder_ / "other/manifest.json"));
  change_manifest([&](Json& manifest) {
    for (const char* part : {"frames", "contents"}) manifest[part]["7"] = other[part]["7"];
  });
  EXPECT_EQ(verify().status, 0);
  expect_fault("frame 7: simulated again it has another state", {"--deep"});
}

TEST_F(VerifyTest, FindsAnotherBuildsPhysicsAndDrawing) {
  change_manifest([](Json& manifest) { manifest["physics"] = "0000000000000000"; });
  expect_fault("made by a taut whose methods move otherwise");
  expect_fault("its inputs are not the hash of what it says");
}

TEST_F(VerifyTest, AnotherBuildOfTheSamePhysicsIsOnlyNoted) {
  change_manifest([](Json& manifest) { manifest["build"] = "taut of yesterday"; });
  const Ran ran = verify();
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.err.find("another build of the same physics, taut of yesterday"), std::string::npos)
      << ran.err;
  // Such a build's frames are gone on with.
  fs::remove(frame(3));
  EXPECT_NE(render("frames").err.find("9 of them there already"), std::string::npos);
}

TEST_F(VerifyTest, FindsAChangedSceneInTheManifest) {
  change_manifest([](Json& manifest) {
    manifest["scene_toml"] = manifest["scene_toml"].get<std::string>() + "# one more line\n";
  });
  expect_fault("its inputs are not the hash of what it says");
}

TEST_F(VerifyTest, FindsAFlippedByteInAFilm) {
  std::string film = read_file(folder_ / "frames/film.mp4");
  film[film.size() / 2] ^= 1;
  folder_.write("frames/film.mp4", film);
  expect_fault("the film film.mp4 is not the one that was made");
}

TEST_F(VerifyTest, FindsAFrameThatNobodyMade) {
  fs::copy_file(frame(3), folder_ / "frames/frame-000099.png");
  expect_fault("frame-000099.png is in no manifest");
}

TEST_F(VerifyTest, FindsABrokenManifest) {
  folder_.write("frames/manifest.json", "{");
  expect_fault("is not a manifest");
}

TEST_F(VerifyTest, FramesThatWereNotAskedForAreStillToBeMade) {
  ASSERT_EQ(render("some", {"--frames", "1-4"}).status, 0);
  const Ran ran = taut({"verify", folder_ / "some"});
  EXPECT_EQ(ran.status, 3) << ran.err;
  EXPECT_NE(ran.err.find("frames 5-10"), std::string::npos) << ran.err;
}

TEST_F(VerifyTest, KnowsMotionsAndFilmsWithoutFrames) {
  ASSERT_EQ(taut({"simulate", scene_, "-o", folder_ / "motion"}).status, 0);
  EXPECT_EQ(taut({"verify", folder_ / "motion", "--deep"}).status, 0);
  std::string motion = read_file(folder_ / "motion/motion.bin");
  motion[motion.size() - 30] ^= 1;
  folder_.write("motion/motion.bin", motion);
  EXPECT_EQ(taut({"verify", folder_ / "motion"}).status, 5);

  const std::string film = folder_ / "alone.mp4";
  ASSERT_EQ(taut({"render", scene_, "--no-frames", "--film", film, "--size", "64x48"}).status, 0);
  EXPECT_EQ(taut({"verify", film}).status, 0);
  fs::resize_file(film, fs::file_size(film) - 1);
  EXPECT_EQ(taut({"verify", film}).status, 5);
}

TEST_F(VerifyTest, WithoutAManifestThereIsNothingToSay) {
  EXPECT_EQ(taut({"verify", folder_ / "nowhere"}).status, 2);
  fs::create_directory(folder_ / "empty");
  EXPECT_EQ(taut({"verify", folder_ / "empty"}).status, 2);
}

// A rerun mends what verify finds.
TEST_F(VerifyTest, TheSameCommandMendsIt) {
  fs::remove(frame(1));
  fs::resize_file(frame(2), 100);
  fs::copy_file(frame(3), frame(4), fs::copy_options::overwrite_existing);
  EXPECT_EQ(verify().status, 5);
  EXPECT_EQ(render("frames", {"--film", folder_ / "frames/film.mp4"}).status, 0);
  EXPECT_EQ(verify().status, 0);
}

}  // namespace
}  // namespace taut::testing
