#include <gtest/gtest.h>

#include "base/failure.h"
#include "frames/film_time.h"

namespace taut {
namespace {

// As it is for a second, five times slower until 2 s, twice as fast from then on.
Look slowed() {
  Look look;
  look.speed = {{1.0, 0.2}, {2.0, 2.0}};
  return look;
}

TEST(FilmTime, IsTheSceneTimeWhereNothingIsSaid) {
  EXPECT_EQ(film_duration(Look{}, 4.0), 4.0);
  EXPECT_EQ(scene_time(Look{}, 0.1), 0.1);
  EXPECT_EQ(film_speed(Look{}, 3.0), 1.0);
}

TEST(FilmTime, StretchesWhatIsSlow) {
  EXPECT_DOUBLE_EQ(film_duration(slowed(), 4.0), 1.0 + 5.0 + 1.0);
  EXPECT_DOUBLE_EQ(film_duration(slowed(), 1.5), 1.0 + 2.5);
  EXPECT_DOUBLE_EQ(film_duration(slowed(), 0.5), 0.5) << "it ends before anything is slowed down";
  EXPECT_DOUBLE_EQ(scene_time(slowed(), 0.5), 0.5);
  EXPECT_DOUBLE_EQ(scene_time(slowed(), 3.5), 1.5);
  EXPECT_DOUBLE_EQ(scene_time(slowed(), 6.5), 3.0);
  EXPECT_EQ(film_speed(slowed(), 1.5), 0.2);
  EXPECT_EQ(film_speed(slowed(), 2.5), 2.0);
}

TEST(FilmTime, NeverGoesBack) {
  double last = -1.0;
  for (int frame = 0; frame < 300; ++frame) {
    const double time = scene_time(slowed(), frame / 30.0);
    EXPECT_GT(time, last);
    last = time;
  }
}

TEST(FilmTime, MayBeSlowFromTheStart) {
  Look look;
  look.speed = {{0.0, 0.5}};
  EXPECT_DOUBLE_EQ(film_duration(look, 3.0), 6.0);
  EXPECT_DOUBLE_EQ(scene_time(look, 1.0), 0.5);
  EXPECT_EQ(film_speed(look, 0.0), 0.5);
}

TEST(FilmTime, OfAFilmAsSlowAsAskedForIsAFractionOfItsOwn) {
  Look look;
  slow_down(look, 4.0);
  EXPECT_EQ(film_duration(look, 3.0), 12.0);
  for (int frame = 0; frame < 100; ++frame)
    EXPECT_EQ(scene_time(look, frame / 24.0), frame / 24.0 / 4.0) << "to the last bit";
  Look twice = slowed();
  slow_down(twice, 2.0);
  EXPECT_EQ(twice.speed, (std::vector<std::array<double, 2>>{{0.0, 0.5}, {1.0, 0.1}, {2.0, 1.0}}));
  EXPECT_DOUBLE_EQ(film_duration(twice, 4.0), 2.0 * film_duration(slowed(), 4.0));
  EXPECT_THROW(slow_down(twice, 1000.0), BadRequest);
}

}  // namespace
}  // namespace taut
