#include <gtest/gtest.h>

#include <string>

#include "base/failure.h"
#include "output/film.h"
#include "program_on_the_path.h"
#include "temporary_folder.h"

namespace taut {
namespace {

std::string problem_of(const FilmSettings& settings) {
  try {
    check_film_settings(settings);
  } catch (const BadRequest& problem) {
    return problem.what();
  }
  return "";
}

TEST(FilmSettings, EveryEndingIsFineWithEvenSizes) {
  for (const char* file : {"a.mp4", "a.webm", "a.gif", "a.webp", "A.MP4"})
    EXPECT_EQ(problem_of({file, {64, 48}, {30}, false}), "") << file;
}

TEST(FilmSettings, OddSizesAreExplainedWhereColourIsStoredForSquares) {
  EXPECT_EQ(problem_of({"a.mp4", {65, 49}, {30}, false}),
            ".mp4 films store colour for squares of 2×2 pixels, so width and height have to be even: 66x50 "
            "instead of 65x49");
  EXPECT_NE(problem_of({"a.webm", {64, 49}, {30}, false}), "");
  EXPECT_EQ(problem_of({"a.gif", {65, 49}, {30}, false}), "");
  EXPECT_EQ(problem_of({"a.webp", {65, 49}, {30}, false}), "");
}

TEST(FilmSettings, UnknownEndingsAreToldTheKnownOnes) {
  EXPECT_EQ(problem_of({"a.avi", {64, 48}, {30}, false}),
            "a film's name has to end in .mp4, .webm, .gif, .webp or .mov; \"a.avi\" does not");
  EXPECT_NE(problem_of({"mp4", {64, 48}, {30}, false}), "");
}

TEST(FilmSettings, TransparencyNeedsAFormatThatHasIt) {
  EXPECT_EQ(problem_of({"a.webm", {64, 48}, {30}, true}), "");
  EXPECT_EQ(problem_of({"a.webp", {64, 48}, {30}, true}), "");
  EXPECT_EQ(problem_of({"a.mp4", {64, 48}, {30}, true}),
            ".mp4 films can't be transparent; .webm, .webp and .mov can");
}

TEST(FilmSettings, ClocksThatAreTooCoarseForARateSaySo) {
  const FrameRate television{24000, 1001};
  for (const char* name : {"a.mp4", "a.webm", "a.mov"})
    EXPECT_EQ(problem_of({name, {64, 48}, television, false}), "") << name;
  EXPECT_EQ(
      problem_of({"a.gif", {64, 48}, television, false}),
      ".gif films can't keep 24000/1001 frames a second, their clock is too coarse; .mp4, .webm and .mov "
      "can, or --fps 24");
  EXPECT_NE(problem_of({"a.webp", {64, 48}, {2997, 100}, false}), "");
  EXPECT_EQ(problem_of({"a.gif", {64, 48}, {60}, false}),
            ".gif films show at most 50 frames a second, not 60; --fps 50 does");
  EXPECT_EQ(problem_of({"a.gif", {64, 48}, {15, 2}, false}), "");
  EXPECT_EQ(problem_of({"a.gif", {64, 48}, {30, 149}, false}), "") << "each frame stands for seconds";
}

TEST(Film, AnAbandonedOneLeavesNothing) {
  const testing::TemporaryFolder folder;
  {
    Film film({folder / "a.mp4", {64, 48}, {30}, false});
    film.add(Image::blank({64, 48}, 3));
  }
  EXPECT_EQ(folder.entries(), 0U);
}

// What making a film throws when the encoder is that script.
std::string failure_with_encoder(const std::string& script) {
  const testing::TemporaryFolder programs, folder;
  testing::write_program(programs, "ffmpeg", script);
  const testing::FirstOnThePath path(programs);
  folder.write("a.mp4", "before");
  std::string failure = "no failure";
  try {
    Film film({folder / "a.mp4", {64, 48}, {30}, false});
    for (int i = 0; i < 3; ++i) film.add(Image::blank({64, 48}, 3));
    film.finish();
    film.commit();
  } catch (const RunFailure& problem) {
    failure = problem.what();
    failure.replace(failure.find(folder.path().string()), folder.path().string().size(), "FOLDER");
  }
  EXPECT_EQ(testing::read_file(folder / "a.mp4"), "before");
  EXPECT_EQ(folder.entries(), 1U);
  return failure;
}

TEST(Film, AnEncoderIsNotBelievedThatSaysAllIsWell) {
  EXPECT_EQ(failure_with_encoder("cat >/dev/null"), "ffmpeg could not make FOLDER/a.mp4: it is empty");
  EXPECT_EQ(failure_with_encoder("cat >/dev/null; for last; do :; done; echo film >\"${last#file:}\""),
            "ffmpeg could not make FOLDER/a.mp4: it is no MP4 or MOV film");
}

TEST(Film, HowAnEncoderEndedIsSaidInWords) {
  EXPECT_EQ(failure_with_encoder("cat >/dev/null; exit 7"),
            "ffmpeg could not make FOLDER/a.mp4: it ended with status 7");
  EXPECT_EQ(failure_with_encoder("cat >/dev/null; echo 'good bye' >&2; kill -SEGV $$"),
            "ffmpeg could not make FOLDER/a.mp4: it was ended by the signal \"Segmentation fault\"; its last "
            "words:\ngood bye\n");
}

}  // namespace
}  // namespace taut
