#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "program.h"

namespace taut::testing {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

Json probe(const std::string& film) {
  const Ran ran = run_program("ffprobe", {"-v", "error", "-count_frames", "-select_streams", "v:0",
                                          "-show_streams", "-show_format", "-of", "json", film});
  EXPECT_EQ(ran.status, 0) << ran.err;
  return Json::parse(ran.out);
}

class FilmTest : public ::testing::Test {
 protected:
  Ran render(const std::vector<std::string>& more) const {
    std::vector<std::string> words{"render", scene_, "-o", folder_ / "frames", "--size", "64x48", "--json"};
    words.insert(words.end(), more.begin(), more.end());
    return taut(words);
  }

  TemporaryFolder folder_;
  std::string scene_ = folder_.write("small.toml", small_scene());
};

TEST_F(FilmTest, HasTheRightSizeRateAndLength) {
  for (const std::string ending : {"mp4", "webm"}) {
    const std::string film = folder_ / ("film." + ending);
    ASSERT_EQ(render({"--film", film}).status, 0);
    const Json stream = probe(film)["streams"][0];
    EXPECT_EQ(stream["width"], 64) << ending;
    EXPECT_EQ(stream["height"], 48) << ending;
    EXPECT_EQ(stream["r_frame_rate"], "30/1") << ending;
    EXPECT_EQ(stream["nb_read_frames"], "30") << ending;
    EXPECT_EQ(stream["pix_fmt"], "yuv420p") << ending;
    EXPECT_EQ(stream["color_space"], "bt709") << ending;
    EXPECT_EQ(stream["color_range"], "tv") << ending;
    EXPECT_NEAR(std::stod(probe(film)["format"]["duration"].get<std::string>()), 1.0, 0.04) << ending;
  }
}

TEST_F(FilmTest, ForCuttingIsProResWithOpacity) {
  const std::string film = folder_ / "film.mov";
  ASSERT_EQ(render({"--film", film, "--fps", "24000/1001", "--transparent"}).status, 0);
  const Json stream = probe(film)["streams"][0];
  EXPECT_EQ(stream["codec_name"], "prores");
  EXPECT_EQ(stream["codec_tag_string"], "ap4h");
  EXPECT_EQ(stream["pix_fmt"].get<std::string>().substr(0, 8), "yuva444p");
  EXPECT_EQ(stream["r_frame_rate"], "24000/1001");
  EXPECT_EQ(stream["nb_read_frames"], "23");
  EXPECT_EQ(stream["color_space"], "bt709");
  EXPECT_EQ(render({"--film", film, "--fps", "24000/1001", "--transparent"}).status, 0) << "the same again";
  EXPECT_EQ(render({"--film", film, "--fps", "24000/1001"}).status, 4) << "without opacity";
  const std::string opaque = folder_ / "opaque.mov";
  ASSERT_EQ(taut({"render", scene_, "--no-frames", "--size", "65x49", "--film", opaque}).status, 0);
  EXPECT_EQ(probe(opaque)["streams"][0]["pix_fmt"].get<std::string>().substr(0, 7), "yuv444p");
  // Seen through where nothing is: the corner's opacity, as the film's own decoder gives it.
  const Ran corner =
      run_program("ffmpeg", {"-v", "error", "-i", film, "-frames:v", "1", "-vf", "alphaextract,crop=1:1:0:0",
                             "-f", "rawvideo", "-pix_fmt", "gray", "-"});
  EXPECT_EQ(corner.out, std::string(1, '\0'));
}

// How many pixels of one brightness lie side by side in the upper left corner of a film's seventh frame.
double mean_run(const std::string& film) {
  constexpr int width = 480;
  const Ran corner = run_program(
      "ffmpeg", {"-v", "error", "-i", film, "-vf", fmt::format("select=eq(n\\,6),crop={}:150:0:0", width),
                 "-frames:v", "1", "-f", "rawvideo", "-pix_fmt", "gray", "-"});
  double runs = 0.0;
  for (std::size_t i = 0; i < corner.out.size(); ++i)
    if (i % width == 0 || corner.out[i] != corner.out[i - 1]) ++runs;
  return static_cast<double>(corner.out.size()) / runs;
}

TEST_F(FilmTest, KeepsTheNoiseThatHidesBandsInTheSky) {
  for (const char* name : {"film.mp4", "film.webm"}) {
    const std::string film = folder_ / name;
    ASSERT_EQ(taut({"render", scene_, "--no-frames", "--size", "1280x720", "--film", film, "--set",
                    "world.duration=0.3"})
                  .status,
              0);
    const double run = mean_run(film);
    EXPECT_GT(run, 1.0) << name;
    EXPECT_LT(run, 8.0) << name;
  }
}

TEST_F(FilmTest, OfEverySecondFrameKeepsItsSpeed) {
  const std::string film = folder_ / "film.mp4";
  ASSERT_EQ(render({"--film", film, "--frames", "1-30:2"}).status, 0);
  const Json found = probe(film);
  EXPECT_EQ(found["streams"][0]["nb_read_frames"], "15");
  EXPECT_EQ(found["streams"][0]["r_frame_rate"], "15/1");
  EXPECT_NEAR(std::stod(found["format"]["duration"].get<std::string>()), 1.0, 0.01);
  // Frames that are all there already make the same film.
  const std::string again = folder_ / "again.mp4";
  ASSERT_EQ(render({"--film", again, "--frames", "1-30:2"}).status, 0);
  EXPECT_EQ(probe(again)["streams"][0]["r_frame_rate"], "15/1");
}

TEST_F(FilmTest, InSlowMotionHasMoreMoments) {
  const std::string film = folder_ / "slow.mp4";
  const Ran ran = render({"--film", film, "--slow", "4"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(Json::parse(ran.out)["frames"]["there"], 120);
  EXPECT_NEAR(std::stod(probe(film)["format"]["duration"].get<std::string>()), 4.0, 0.01);
  EXPECT_EQ(render({"--film", film, "--slow", "4"}).status, 0) << "the same again";
  EXPECT_EQ(render({"--film", film, "--slow", "2"}).status, 4) << "frames of other moments";
  EXPECT_EQ(render({"--slow", "0"}).status, 2);
  EXPECT_EQ(taut({"verify", folder_ / "frames", "--deep"}).status, 0);

  const std::string motion = folder_ / "motion";
  ASSERT_EQ(taut({"simulate", scene_, "-o", motion, "--slow", "3"}).status, 0);
  const std::vector<std::string> draw{"render",          "--motion", motion,  "-o",
                                      folder_ / "drawn", "--size",   "64x48", "--json"};
  const Ran drawn = taut(draw);
  ASSERT_EQ(drawn.status, 0) << drawn.err;
  EXPECT_EQ(Json::parse(drawn.out)["frames"]["there"], 90);
  std::vector<std::string> slower = draw;
  slower.insert(slower.end(), {"--slow", "2"});
  EXPECT_EQ(taut(slower).status, 2);
}

TEST_F(FilmTest, OfSixteenBitsIsMadeFromTiffFiles) {
  const std::string film = folder_ / "film.mov";
  const std::vector<std::string> deep{"--depth", "16", "--fps", "10", "--transparent"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.end(), deep.begin(), deep.end());
    return render(more);
  };
  ASSERT_EQ(with({}).status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "frames/frame-000010.tif"));
  EXPECT_FALSE(fs::exists(folder_ / "frames/frame-000010.png"));
  EXPECT_EQ(probe(folder_ / "frames/frame-000010.tif")["streams"][0]["pix_fmt"], "rgba64le");
  const Ran again = with({"--film", film});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(Json::parse(again.out)["frames"]["kept"], 10) << "the film is made from the files";
  EXPECT_EQ(probe(film)["streams"][0]["nb_read_frames"], "10");
  EXPECT_EQ(with({"--film", film}).status, 0) << "the same again";
  EXPECT_EQ(taut({"verify", folder_ / "frames"}).status, 0);
  EXPECT_EQ(render({"--fps", "10", "--transparent"}).status, 4) << "frames of eight bits";
  const Ran other = render({"--depth", "12"});
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.err.find("--depth is 8 or 16"), std::string::npos) << other.err;

  // Of shards, too; and frames of another kind are taken away.
  const std::string parts = folder_ / "parts";
  for (const std::string shard : {"1/2", "2/2"})
    ASSERT_EQ(
        taut({"render", scene_, "-o", parts, "--size", "64x48", "--depth", "16", "--shard", shard}).status,
        0);
  ASSERT_EQ(taut({"merge", parts, "--film", folder_ / "merged.mov"}).status, 0);
  EXPECT_EQ(probe(folder_ / "merged.mov")["streams"][0]["nb_read_frames"], "30");
  ASSERT_EQ(taut({"render", scene_, "-o", parts, "--size", "64x48", "--overwrite"}).status, 0);
  EXPECT_FALSE(fs::exists(parts + "/frame-000001.tif"));
  EXPECT_EQ(taut({"verify", parts}).status, 0);
}

TEST_F(FilmTest, GifHasAllFrames) {
  const std::string film = folder_ / "film.gif";
  ASSERT_EQ(render({"--film", film, "--fps", "20"}).status, 0);
  const Json stream = probe(film)["streams"][0];
  EXPECT_EQ(stream["nb_read_frames"], "20");
  EXPECT_EQ(stream["r_frame_rate"], "20/1");
}

TEST_F(FilmTest, WebpIsAnAnimation) {
  const std::string film = folder_ / "film.webp";
  ASSERT_EQ(render({"--film", film}).status, 0);
  const std::string bytes = read_file(film);
  EXPECT_EQ(bytes.substr(0, 4) + bytes.substr(8, 4), "RIFFWEBP");
  EXPECT_NE(bytes.find("ANMF"), std::string::npos);
}

// Every frame of an animation as a whole: what is only changed in places leaves ghosts.
TEST_F(FilmTest, WebpHasWholeFramesOnly) {
  const std::string film = folder_ / "film.webp";
  ASSERT_EQ(render({"--film", film}).status, 0);
  const std::string bytes = read_file(film);
  const auto number_at = [&](std::size_t at) {  // 24 bits, the lowest first
    return static_cast<unsigned char>(bytes.at(at)) | static_cast<unsigned char>(bytes.at(at + 1)) << 8 |
           static_cast<unsigned char>(bytes.at(at + 2)) << 16;
  };
  int frames = 0;
  for (std::size_t at = bytes.find("ANMF"); at != std::string::npos; at = bytes.find("ANMF", at + 4)) {
    ++frames;
    // After the chunk's name and length: left, top, width − 1, height − 1.
    EXPECT_EQ(number_at(at + 8), 0);
    EXPECT_EQ(number_at(at + 11), 0);
    EXPECT_EQ(number_at(at + 14), 63);
    EXPECT_EQ(number_at(at + 17), 47);
  }
  EXPECT_EQ(frames, 30);
}

TEST_F(FilmTest, TelevisionsRatesAreExact) {
  for (const std::string ending : {"mp4", "webm"}) {
    const std::string film = folder_ / ("film." + ending);
    const Ran ran = render({"--film", film, "--fps", "24000/1001", "--overwrite"});
    ASSERT_EQ(ran.status, 0) << ran.err;
    const Json stream = probe(film)["streams"][0];
    EXPECT_EQ(stream["r_frame_rate"], "24000/1001") << ending;
    EXPECT_EQ(stream["nb_read_frames"], "23") << ending;
  }
}

TEST_F(FilmTest, GoesIntoAPipeAsItGrows) {
  // Standard output, in the usual format and in others; and a pipe with a name.
  const auto into = [&](const std::string& film, const std::string& command) {
    const std::string words = std::string(TAUT_PROGRAM) + " render " + scene_ +
                              " --no-frames --size 64x48 --quiet " + "--film " + film + command;
    const Ran ran =
        run_program("bash", {"-c", "set -o pipefail; cd " + folder_.path().string() + "; " + words});
    EXPECT_EQ(ran.status, 0) << film << ": " << ran.err;
  };
  for (const auto& [film, format] : {std::pair{"-", "mp4"}, {"webm:-", "webm"}, {"gif:-", "gif"}}) {
    into(film, " | cat > piped");
    const Json found = probe(folder_ / "piped");
    EXPECT_NE(found["format"]["format_name"].get<std::string>().find(format), std::string::npos) << film;
    EXPECT_EQ(found["streams"][0]["nb_read_frames"], "30") << film;
  }
  ASSERT_EQ(run_program("mkfifo", {folder_ / "named.mp4"}).status, 0);
  into("named.mp4", " & timeout 20 cat named.mp4 > piped; wait $!");
  EXPECT_TRUE(fs::is_fifo(folder_ / "named.mp4")) << "a pipe is written into, not replaced";
  EXPECT_EQ(probe(folder_ / "piped")["streams"][0]["nb_read_frames"], "30");
}

TEST_F(FilmTest, WhatCannotBePipedIsSaidBeforehand) {
  const Ran webp = taut({"render", scene_, "--no-frames", "--film", "webp:-"}, {}, folder_.path());
  EXPECT_EQ(webp.status, 2);
  EXPECT_NE(webp.err.find("pipe"), std::string::npos) << webp.err;
  EXPECT_EQ(render({"--film", "-"}).status, 2) << "where JSON goes already";
}

TEST_F(FilmTest, ABrokenPipeIsAnError) {
  const Ran ran =
      run_program("bash", {"-c", std::string(TAUT_PROGRAM) + " render " + scene_ +
                                     " --no-frames --size 640x480 --film - | true; exit ${PIPESTATUS[0]}"});
  EXPECT_EQ(ran.status, 1) << ran.err;
  EXPECT_NE(ran.err.find("ffmpeg could not make"), std::string::npos) << ran.err;
}

TEST_F(FilmTest, NeedsNoFrames) {
  const std::string film = folder_ / "film.mp4";
  const Ran ran =
      taut({"render", scene_, "--no-frames", "--film", film, "--size", "64x48"}, {}, folder_.path());
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(folder_.entries(), 3U) << "the scene, the film and its hidden manifest";
}

TEST_F(FilmTest, ShowsTheFramesInOrder) {
  const std::string film = folder_ / "film.mp4";
  ASSERT_EQ(render({"--film", film}).status, 0);
  // The film as PNG frames again, and how far each is from the frame of its number and from the others.
  ASSERT_EQ(run_program("ffmpeg", {"-v", "error", "-i", film, folder_ / "film-%06d.png"}).status, 0);
  const auto difference = [&](const char* filmed, const char* frame) {
    const Ran ran =
        run_program("ffmpeg", {"-v", "info", "-i", folder_ / (std::string("film-") + filmed + ".png"), "-i",
                               folder_ / (std::string("frames/frame-") + frame + ".png"), "-lavfi", "psnr",
                               "-f", "null", "-"});
    const std::size_t at = ran.err.find("average:");
    EXPECT_NE(at, std::string::npos) << ran.err;
    return std::stod(ran.err.substr(at + 8));
  };
  for (const char* number : {"000001", "000015", "000030"}) {
    EXPECT_GT(difference(number, number), 30.0) << number;
    for (const char* other : {"000001", "000015", "000030"}) {
      if (std::string(other) == number) continue;
      EXPECT_LT(difference(number, other), difference(number, number)) << number << ' ' << other;
    }
  }
}

TEST_F(FilmTest, IsKeptWhenItIsThereAlready) {
  const std::string film = folder_ / "film.mp4";
  ASSERT_EQ(render({"--film", film}).status, 0);
  const auto written = fs::last_write_time(film);
  ASSERT_EQ(render({"--film", film}).status, 0);
  EXPECT_EQ(fs::last_write_time(film), written);
  fs::remove(film);
  const Ran again = render({"--film", film});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(Json::parse(again.out)["frames"]["kept"], 30) << "the frames are not written again for it";
  EXPECT_EQ(probe(film)["streams"][0]["nb_read_frames"], "30");
}

TEST_F(FilmTest, OfUnknownOriginIsAConflict) {
  const std::string film = folder_.write("film.mp4", "a holiday");
  for (const std::string frames : {"--no-frames", "--json"}) {
    const Ran ran = render({"--film", film, frames});
    EXPECT_EQ(ran.status, 4) << ran.err;
    EXPECT_EQ(read_file(film), "a holiday");
  }
  EXPECT_EQ(render({"--film", film, "--overwrite"}).status, 0);
  EXPECT_EQ(probe(film)["streams"][0]["nb_read_frames"], "30");
}

}  // namespace
}  // namespace taut::testing
