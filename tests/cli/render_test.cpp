#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "program.h"

namespace taut::testing {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

// Renders the small scene in a folder of its own: 30 small frames.
class RenderTest : public ::testing::Test {
 protected:
  Ran render(const Words& more = {}, const Environment& environment = {}) const {
    Words words{"render", scene_, "-o", frames_, "--size", "64x48", "--json"};
    words.insert(words.end(), more.begin(), more.end());
    return taut(words, environment);
  }
  std::string frame(int number) const {
    char name[32];
    std::snprintf(name, sizeof name, "/frame-%06d.png", number);
    return frames_ + name;
  }
  std::size_t frames_there() const {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(frames_)) count += entry.path().extension() == ".png";
    return count;
  }
  std::map<std::string, std::string> all_files() const {
    std::map<std::string, std::string> contents;
    for (const auto& entry : fs::directory_iterator(frames_))
      contents[entry.path().filename().string()] = read_file(entry.path());
    return contents;
  }

  TemporaryFolder folder_;
  std::string scene_ = folder_.write("small.toml", small_scene());
  std::string frames_ = folder_ / "frames";
};

TEST_F(RenderTest, MakesWholeFramesAndAManifest) {
  const Ran ran = render();
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(frames_there(), 30U);
  EXPECT_EQ(run_program("pngcheck", {"-q", frame(1), frame(15), frame(30)}).status, 0);
  EXPECT_NE(read_file(frame(1)), read_file(frame(30))) << "the mass swings";

  const Json manifest = Json::parse(read_file(frames_ + "/manifest.json"));
  EXPECT_EQ(manifest["scene"], "small");
  EXPECT_EQ(manifest["method"], "xpbd");
  EXPECT_EQ(manifest["width"], 64);
  EXPECT_EQ(manifest["frames_per_second"], 30.0);
  EXPECT_EQ(manifest["frames"].size(), 30U);
  EXPECT_NE(manifest["frames"]["1"], manifest["frames"]["30"]);

  const Json summary = Json::parse(ran.out);
  EXPECT_EQ(summary["frames"]["asked"], 30);
  EXPECT_EQ(summary["frames"]["there"], 30);
  EXPECT_EQ(summary["frames"]["kept"], 0);
  EXPECT_EQ(summary["last_state_hash"], manifest["frames"]["30"]);
}

TEST_F(RenderTest, SaysWhatDrewAndWhereTheTimeWent) {
  const Ran ran = render({"-v", "--film", folder_ / "film.mp4"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json summary = Json::parse(ran.out);
  const std::string drawn_by = summary["drawn_by"];
  EXPECT_NE(drawn_by.find("OpenGL"), std::string::npos) << drawn_by;
  EXPECT_EQ(Json::parse(read_file(frames_ + "/manifest.json"))["drawn_by"], drawn_by);
  double sum = 0.0;
  for (const char* stage : {"simulate", "shape", "draw", "flatten", "compress", "write", "feed", "encode"}) {
    ASSERT_TRUE(summary["stage_seconds"].contains(stage)) << stage;
    EXPECT_GT(summary["stage_seconds"][stage], 0.0) << stage;
    sum += summary["stage_seconds"][stage].get<double>();
  }
  const double cores = std::max(1U, std::thread::hardware_concurrency());
  EXPECT_LT(sum, 1.2 * cores * summary["seconds"].get<double>() + 0.2) << "no time is counted twice";
  EXPECT_NE(ran.err.find("milliseconds of a processor a frame"), std::string::npos) << ran.err;
  EXPECT_EQ(render({"--overwrite"}).err.find("milliseconds of a processor"), std::string::npos);
}

TEST_F(RenderTest, AQualityGoesWithASize) {
  const Ran draft = render({"--quality", "draft", "--frames", "1"});
  ASSERT_EQ(draft.status, 0) << draft.err;
  const Json manifest = Json::parse(read_file(frames_ + "/manifest.json"));
  EXPECT_EQ(manifest["width"], 64);
  EXPECT_NE(manifest["picture"].get<std::string>().find("1 samples, shadows 0"), std::string::npos)
      << manifest["picture"];
  ASSERT_EQ(render({"--quality", "fine", "--frames", "1", "--overwrite"}).status, 0);
  EXPECT_NE(read_file(frames_ + "/manifest.json").find("8 samples, shadows 2048"), std::string::npos);
}

TEST_F(RenderTest, TheManifestsSceneGivesTheSameStates) {
  ASSERT_EQ(render().status, 0);
  const Json first = Json::parse(read_file(frames_ + "/manifest.json"));
  scene_ = folder_.write("again.toml", first["scene_toml"].get<std::string>());
  frames_ = folder_ / "again";
  ASSERT_EQ(render().status, 0);
  EXPECT_EQ(Json::parse(read_file(frames_ + "/manifest.json"))["frames"], first["frames"]);
}

TEST_F(RenderTest, GoesToOutByDefault) {
  const Ran ran = taut({"render", scene_, "--size", "64x48", "--frames", "1"}, {}, folder_.path());
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_TRUE(fs::exists(folder_ / "out/small/frame-000001.png"));
}

TEST_F(RenderTest, AgainIsDoneAtOnce) {
  ASSERT_EQ(render().status, 0);
  const auto before = all_files();
  const auto written = fs::last_write_time(frame(3));
  const Ran again = render();
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(Json::parse(again.out)["frames"]["kept"], 30);
  EXPECT_EQ(fs::last_write_time(frame(3)), written);
  EXPECT_EQ(all_files(), before);
}

TEST_F(RenderTest, GoesOnWhereItStopped) {
  ASSERT_EQ(render().status, 0);
  const auto whole = all_files();
  const auto written = fs::last_write_time(frame(3));
  fs::remove(frame(7));
  fs::resize_file(frame(8), 100);
  const Ran again = render();
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(Json::parse(again.out)["frames"]["kept"], 28) << "one was gone, one was cut";
  EXPECT_EQ(fs::last_write_time(frame(3)), written);
  EXPECT_EQ(all_files(), whole);
}

TEST_F(RenderTest, OnlyTheChosenFramesAreMade) {
  ASSERT_EQ(render({"--frames", "2-6:2,30"}).status, 0);
  EXPECT_EQ(frames_there(), 4U);
  const std::string sixth = read_file(frame(6)), last = read_file(frame(30));
  const Ran rest = render();
  EXPECT_EQ(rest.status, 0);
  EXPECT_EQ(Json::parse(rest.out)["frames"]["kept"], 4);

  frames_ = folder_ / "at once";
  ASSERT_EQ(render().status, 0);
  EXPECT_EQ(read_file(frame(6)), sixth) << "a frame is the same whichever others are made";
  EXPECT_EQ(read_file(frame(30)), last);
}

TEST_F(RenderTest, FramesOfOtherInputsAreNeverMixedIn) {
  ASSERT_EQ(render().status, 0);
  const auto before = all_files();
  const std::vector<std::pair<Words, std::string>> changes{
      {{"--set", "world.drag=0.5"}, "another version of the scene"},
      {{"--set", "passes=2"}, "other settings"},
      {{"--method", "verlet"}, "the method xpbd"},
      {{"--fps", "25"}, "30 frames/s"},
      {{"--color", "speed"}, "another version of the scene"},
      {{"--transparent"}, "other picture settings"}};
  for (const auto& [flags, said] : changes) {
    const Ran ran = render(flags);
    EXPECT_EQ(ran.status, 4) << flags[0] << ran.err;
    EXPECT_NE(ran.err.find(said), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find("--overwrite"), std::string::npos) << ran.err;
  }
  EXPECT_EQ(all_files(), before);
}

TEST_F(RenderTest, OverwriteStartsAfresh) {
  ASSERT_EQ(render().status, 0);
  const Ran ran = render({"--set", "world.duration=0.5", "--overwrite"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(frames_there(), 15U) << "none of the other scene's frames is left";
}

TEST_F(RenderTest, FramesWithoutAManifestAreAConflict) {
  fs::create_directory(frames_);
  folder_.write("frames/frame-000001.png", "who knows");
  const Ran ran = render();
  EXPECT_EQ(ran.status, 4) << ran.err;
  EXPECT_EQ(read_file(frame(1)), "who knows");
  EXPECT_EQ(render({"--overwrite"}).status, 0);
  EXPECT_NE(read_file(frame(1)), "who knows");
}

TEST_F(RenderTest, TransparentFramesHaveAlpha) {
  ASSERT_EQ(render({"--transparent", "--frames", "1"}).status, 0);
  const Ran checked = run_program("pngcheck", {frame(1)});
  EXPECT_NE(checked.out.find("32-bit RGB+alpha"), std::string::npos) << checked.out;
}

TEST_F(RenderTest, QuietSaysNothing) {
  const Ran ran = taut({"render", scene_, "-o", frames_, "--size", "64x48", "--frames", "1", "--quiet"});
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(ran.out + ran.err, "");
}

TEST_F(RenderTest, MassesBelowAGroundThatStopsNothingGetANote) {
  const std::string note = "masses is below the drawn ground at y = 1.5, which stops nothing";
  const Words high{"--set", "look.ground_height=1.5", "--set", "camera.eye=[0, 3, 5]", "--size", "64x48",
                   "--json"};
  const auto say = [&](Words words) {
    words.insert(words.end(), high.begin(), high.end());
    const Ran ran = taut(words);
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_NE(ran.err.find(note), std::string::npos) << ran.err;
    EXPECT_NE(Json::parse(ran.out).value("note", "").find(note), std::string::npos) << ran.out;
    words.push_back("--quiet");
    words.push_back(words.front() == "render" ? "--overwrite" : "--json");
    EXPECT_EQ(taut(words).err, "");
  };
  say({"render", scene_, "-o", frames_});
  say({"still", scene_, "--at", "0.6s", "-o", folder_ / "still.png"});
  say({"strip", scene_, "--count", "3", "-o", folder_ / "strip.png"});
  const Ran ran = render({"--overwrite"});
  EXPECT_EQ(ran.err.find("drawn ground"), std::string::npos) << ran.err;
  EXPECT_FALSE(Json::parse(ran.out).contains("note")) << ran.out;
}

TEST_F(RenderTest, TheScenesFolderCanBeChosen) {
  const Ran ran = taut({"render", "small", "-o", frames_, "--size", "64x48", "--frames", "1"},
                       {{"TAUT_SCENES", folder_.path().string()}});
  EXPECT_EQ(ran.status, 0) << ran.err;
}

TEST_F(RenderTest, StillsAndStrips) {
  const std::string still = folder_ / "still.png", strip = folder_ / "strip.png";
  EXPECT_EQ(taut({"still", scene_, "--at", "0.5s", "--size", "64x48", "-o", still}).status, 0);
  EXPECT_NE(run_program("pngcheck", {still}).out.find("64x48"), std::string::npos);
  EXPECT_EQ(taut({"strip", scene_, "--count", "5", "--size", "64x48", "-o", strip}).status, 0);
  EXPECT_NE(run_program("pngcheck", {strip}).out.find("320x48"), std::string::npos);
  // The picture of a time is the frame of that time.
  ASSERT_EQ(render({"--frames", "16"}).status, 0);
  EXPECT_EQ(read_file(still), read_file(frame(16)));
}

}  // namespace
}  // namespace taut::testing
