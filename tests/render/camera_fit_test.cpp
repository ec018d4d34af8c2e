#include "render/camera_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "render/camera.h"

namespace taut {
namespace {

constexpr double field_of_view = 38.0, margin = 0.05;

// How far balls reach across a picture of that aspect, 0 to 1 from its left and upper edges.
struct Reach {
  double left = 2.0, right = -1.0, top = 2.0, bottom = -1.0;
};

struct Ball {
  Vec3 centre;
  double radius;
};

// By points all around each ball.
Reach reach_of_balls(const CameraPose& pose, double aspect, const std::vector<Ball>& balls) {
  const int height = 1000, width = static_cast<int>(std::lround(aspect * height));
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  Reach reach;
  for (const Ball& ball : balls)
    for (int i = 0; i < 200; ++i) {
      const Vec3 way = Vec3(normal(random), normal(random), normal(random)).normalized();
      const Vec3 at = picture_position(pose, width, height, ball.centre + ball.radius * way);
      EXPECT_GT(at.z(), 0.0);
      reach.left = std::min(reach.left, at.x() / width);
      reach.right = std::max(reach.right, at.x() / width);
      reach.top = std::min(reach.top, at.y() / height);
      reach.bottom = std::max(reach.bottom, at.y() / height);
    }
  return reach;
}

std::vector<Ball> random_balls(unsigned seed, double size) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-size, size);
  std::vector<Ball> balls;
  for (int i = 0; i < 20; ++i)
    balls.push_back({{3.0 * place(random) + 50.0 * size, place(random), 0.5 * place(random)},
                     i % 3 == 0 ? 0.2 * size : 0.0});
  return balls;
}

CameraPose pose_of(const CameraFit::Place& place) {
  return {place.eye, place.target, field_of_view, Vec3::UnitY()};
}

TEST(CameraFit, FillsThePictureUpToItsMargin) {
  for (const double size : {1e-3, 1.0, 1e4})
    for (const double aspect : {16.0 / 9.0, 4.0 / 3.0, 1.0, 9.0 / 16.0})
      for (const Vec3& direction : {Vec3(0, 0, 1), Vec3(0.4, 0.2, 1), Vec3(-1, 0.8, -0.3), Vec3(0, 1, 0)}) {
        const std::vector<Ball> balls = random_balls(3, size);
        CameraFit fit(sight_axes(direction, Vec3::UnitY()), field_of_view, aspect, margin);
        for (const Ball& ball : balls) fit.add(ball.centre, ball.radius);
        const CameraFit::Place place = fit.place(1e-3 * size);
        EXPECT_LT((place.eye - place.target).normalized().cross(direction.normalized()).norm(), 1e-9);
        const Reach reach = reach_of_balls(pose_of(place), aspect, balls);
        const double slack = 0.004;  // of points around the balls, and of whole pixels
        EXPECT_GT(reach.left, margin - slack);
        EXPECT_LT(reach.right, 1.0 - margin + slack);
        EXPECT_GT(reach.top, margin - slack);
        EXPECT_LT(reach.bottom, 1.0 - margin + slack);
        // No nearer eye would do: one pair of edges is met.
        const double wide = reach.right - reach.left, high = reach.bottom - reach.top;
        EXPECT_GT(std::max(wide, high), 1.0 - 2.0 * margin - 3.0 * slack);
        EXPECT_NEAR(0.5 * (wide > high ? reach.left + reach.right : reach.top + reach.bottom), 0.5, 0.01);
      }
}

TEST(CameraFit, KeepsAGivenCentreInTheMiddle) {
  const Vec3 centre(50.5, 0.3, 0.1);
  const std::vector<Ball> balls = random_balls(5, 1.0);
  CameraFit fit(sight_axes({0.3, 0.1, 1}, Vec3::UnitY()), field_of_view, 1.5, margin, centre);
  for (const Ball& ball : balls) fit.add(ball.centre, ball.radius);
  const CameraPose pose = pose_of(fit.place(0.1));
  const Vec3 seen = picture_position(pose, 1500, 1000, centre);
  EXPECT_NEAR(seen.x(), 750.0, 1e-6);
  EXPECT_NEAR(seen.y(), 500.0, 1e-6);
  const Reach reach = reach_of_balls(pose, 1.5, balls);
  EXPECT_GT(std::min({reach.left, reach.top, 1.0 - reach.right, 1.0 - reach.bottom}), margin - 0.004);
}

TEST(CameraFit, StaysInFrontOfWhatHasNoWidth) {
  CameraFit fit(sight_axes({0, 0, 1}, Vec3::UnitY()), field_of_view, 1.5, margin);
  fit.add({1, 2, 3}, 0.0);
  const CameraFit::Place place = fit.place(0.5);
  EXPECT_NEAR((place.eye - Vec3(1, 2, 3.5)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((place.target - Vec3(1, 2, 3)).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace taut
