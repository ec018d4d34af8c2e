#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "base/failure.h"
#include "film_check.h"
#include "output/film.h"
#include "temporary_folder.h"

namespace taut {
namespace {

using testing::TemporaryFolder;

constexpr std::size_t frames = 7;

// Frames that differ, of noise, so that they need some bytes.
Image noise(std::size_t frame, int channels) {
  Image image = Image::blank({64, 48}, channels);
  std::uint32_t state = static_cast<std::uint32_t>(frame) + 1;
  for (std::uint8_t& value : image.pixels) {
    state = state * 1664525U + 1013904223U;
    value = static_cast<std::uint8_t>(state >> 24U);
  }
  return image;
}

void make_film(const std::string& file, std::size_t count, bool transparent = false) {
  Film film({file, {64, 48}, {30}, transparent});
  for (std::size_t i = 0; i < count; ++i) film.add(noise(i, transparent ? 4 : 3));
  film.finish();
  film.commit();
}

class FilmCheckTest : public ::testing::TestWithParam<const char*> {};

TEST_P(FilmCheckTest, AWholeFilmIsFineAndOneOfAnotherLengthIsNot) {
  const TemporaryFolder folder;
  const std::string ending = GetParam(), file = folder / ("film" + ending);
  make_film(file, frames);
  EXPECT_EQ(film_problem(file, ending, frames), "");
  EXPECT_EQ(film_problem(file, ending, frames + 1), "it has 7 frames of 8");
  EXPECT_EQ(film_problem(file, ending, frames - 1), "it has 7 frames of 6");
}

TEST_P(FilmCheckTest, AFilmOfOneFrameIsFine) {
  const TemporaryFolder folder;
  const std::string ending = GetParam(), file = folder / ("film" + ending);
  make_film(file, 1);
  EXPECT_EQ(film_problem(file, ending, 1), "");
}

// Wherever a full disk may have cut it.
TEST_P(FilmCheckTest, NoBeginningOfAFilmIsAFilm) {
  const TemporaryFolder folder;
  const std::string ending = GetParam(), file = folder / ("film" + ending);
  make_film(file, frames);
  const std::uintmax_t whole = std::filesystem::file_size(file);
  ASSERT_GT(whole, 1000U);
  const std::uintmax_t step = std::max<std::uintmax_t>(1, whole / 5000);
  for (std::uintmax_t length = whole - 1; length < whole; length -= step) {
    std::filesystem::resize_file(file, length);
    ASSERT_NE(film_problem(file, ending, frames), "") << length << " of " << whole;
  }
}

TEST_P(FilmCheckTest, WhatIsNoFilmAtAllIsToldSo) {
  const TemporaryFolder folder;
  const std::string ending = GetParam();
  EXPECT_EQ(film_problem(folder.write("empty", ""), ending, frames), "it is empty");
  EXPECT_NE(film_problem(folder.write("words", std::string(5000, 'x')), ending, frames), "");
  EXPECT_NE(film_problem(folder.write("zeros", std::string(5000, '\0')), ending, frames), "");
  EXPECT_THROW(film_problem(folder / "none", ending, frames), RunFailure);
}

INSTANTIATE_TEST_SUITE_P(Endings, FilmCheckTest, ::testing::Values(".mp4", ".webm", ".gif", ".webp", ".mov"),
                         [](const auto& test) { return std::string(test.param).substr(1); });

TEST(FilmCheck, TransparentFilmsAreFineToo) {
  const TemporaryFolder folder;
  for (const std::string ending : {".webm", ".webp", ".mov"}) {
    make_film(folder / ("film" + ending), frames, true);
    EXPECT_EQ(film_problem(folder / ("film" + ending), ending, frames), "") << ending;
  }
}

// What does not move is stored in few bytes, and still counts.
TEST(FilmCheck, FramesThatAreAlikeAreCounted) {
  const TemporaryFolder folder;
  for (const std::string ending : {".mp4", ".webm", ".gif", ".webp"}) {
    const std::string file = folder / ("film" + ending);
    Film film({file, {64, 48}, {30}, false});
    for (std::size_t i = 0; i < 40; ++i) film.add(noise(0, 3));
    film.finish();
    film.commit();
    EXPECT_EQ(film_problem(file, ending, 40), "") << ending;
  }
}

}  // namespace
}  // namespace taut
