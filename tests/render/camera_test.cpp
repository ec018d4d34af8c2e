#include "render/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/failure.h"
#include "small_scenes.h"

namespace taut {
namespace {

using testing::row_of_masses;

void expect_near(const Vec3& expected, const Vec3& actual) {
  EXPECT_NEAR(expected.x(), actual.x(), 1e-5);
  EXPECT_NEAR(expected.y(), actual.y(), 1e-5);
  EXPECT_NEAR(expected.z(), actual.z(), 1e-5);
}

TEST(Camera, StaysWhereItIsPut) {
  const Built scene = row_of_masses({{0, 0, 0}, {1, 0, 0}});
  State later = scene.start;
  later.time = 7.0;
  const Camera camera{.eye = Vec3(1, 2, 3), .target = Vec3(0, 1, 0), .field_of_view = 50.0, .follow = {}};
  const CameraPose pose = camera_pose(camera, scene.model, scene.start, later);
  expect_near({1, 2, 3}, pose.eye);
  expect_near({0, 1, 0}, pose.target);
  EXPECT_DOUBLE_EQ(50.0, pose.field_of_view);
}

TEST(Camera, OrbitsCounterClockwiseSeenFromAbove) {
  const Built scene = row_of_masses({{0, 0, 0}, {1, 0, 0}});
  State later = scene.start;
  later.time = 3.0;
  const Camera camera{.eye = Vec3(1, 2, 4), .target = Vec3(1, 1, 0), .orbit = 30.0, .follow = {}};
  const CameraPose pose = camera_pose(camera, scene.model, scene.start, later);
  // A quarter turn takes +z to +x, seen from above (y towards the viewer) counter-clockwise.
  expect_near({5, 2, 0}, pose.eye);
  expect_near({1, 1, 0}, pose.target);
}

TEST(Camera, OrbitsAboutTheAxisThatGravityPointsAlong) {
  Built scene = row_of_masses({{0, 0, 0}, {1, 0, 0}});
  scene.model.gravity = {0.0, 0.0, -9.81};
  State later = scene.start;
  later.time = 3.0;
  const Camera camera{.eye = Vec3(4, 1, 2), .target = Vec3(0, 1, 1), .orbit = 30.0, .follow = {}};
  const CameraPose pose = camera_pose(camera, scene.model, scene.start, later);
  // A quarter turn takes +x to +y, seen from above (z towards the viewer) counter-clockwise.
  expect_near({0, 5, 2}, pose.eye);
  expect_near({0, 0, 1}, pose.up);
}

TEST(Camera, UpIsAgainstGravityUnlessTheCameraSaysOtherwise) {
  Model model;
  expect_near({0, 1, 0}, up_direction({}, model));
  model.gravity = {-3.0, 0.0, 4.0};
  expect_near({0.6, 0, -0.8}, up_direction({}, model));
  Camera camera;
  camera.up = Vec3(0, 0, 2);
  expect_near({0, 0, 1}, up_direction(camera, model));
  model.gravity = Vec3::Zero();
  expect_near({0, 1, 0}, up_direction({}, model));
}

TEST(Camera, UprightAxesAreTurnedTheShortestWay) {
  for (const Vec3& up : {Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0.36, 0.48, -0.8), Vec3(0, -1, 0)}) {
    const Eigen::Matrix3d axes = upright_axes(up);
    expect_near(up, axes.col(1));
    EXPECT_NEAR((axes.transpose() * axes - Eigen::Matrix3d::Identity()).norm(), 0.0, 1e-12) << up.transpose();
    EXPECT_NEAR(axes.determinant(), 1.0, 1e-12) << up.transpose();
    // The angle of the turn is that between y and up.
    EXPECT_NEAR(axes.trace(), 1.0 + 2.0 * up.y(), 1e-12) << up.transpose();
  }
}

TEST(Camera, FollowsAMassAsFarAsItHasMoved) {
  const Built scene = row_of_masses({{0, 0, 0}, {1, 0, 0}});
  State later = scene.start;
  later.position.set(1, {1.5, -2.0, 0.25});
  const Camera camera{.eye = Vec3(0, 1, 5), .target = Vec3(0, 1, 0), .follow = "m1"};
  const CameraPose pose = camera_pose(camera, scene.model, scene.start, later);
  expect_near({0.5, -1.0, 5.25}, pose.eye);
  expect_near({0.5, -1.0, 0.25}, pose.target);
}

TEST(Camera, CannotFollowAMassThatIsNotThere) {
  const Built scene = row_of_masses({{0, 0, 0}, {1, 0, 0}});
  const Camera camera{.eye = Vec3(0, 1, 5), .target = Vec3(0, 1, 0), .follow = "m9"};
  EXPECT_THROW(camera_pose(camera, scene.model, scene.start, scene.start), BadRequest);
}

TEST(PicturePosition, TargetIsInTheMiddle) {
  expect_near({640, 360, 5}, picture_position(testing::straight_on(), 1280, 720, {0, 0, 0}));
}

TEST(PicturePosition, UpperEdgeIsHalfTheFieldOfViewAway) {
  const double height = 5.0 * std::tan(19.0 * std::numbers::pi / 180.0);
  const Vec3 top = picture_position(testing::straight_on(), 1280, 720, {0, height, 0});
  EXPECT_NEAR(640.0, top.x(), 1e-3);
  EXPECT_NEAR(0.0, top.y(), 1e-3);
}

TEST(PicturePosition, RightIsRight) {
  EXPECT_GT(picture_position(testing::straight_on(), 1280, 720, {1, 0, 0}).x(), 640.0);
}

TEST(PicturePosition, LookingStraightDownIsDefined) {
  const CameraPose down{{0, 5, 0}, {0, 0, 0}, 38.0};
  const Vec3 middle = picture_position(down, 200, 200, {0, 0, 0});
  EXPECT_NEAR(100.0, middle.x(), 1e-3);
  EXPECT_NEAR(100.0, middle.y(), 1e-3);
  EXPECT_LT(picture_position(down, 200, 200, {0, 0, -1}).y(), 100.0);
}

TEST(PicturePosition, IsAsExactFarFromTheOrigin) {
  const Vec3 far(1e6, 2e5, -1e6), point(0.3, -0.7, 0.2);
  CameraPose pose = testing::straight_on();
  const Vec3 near_place = picture_position(pose, 1280, 720, point);
  pose.eye += far;
  pose.target += far;
  expect_near(near_place, picture_position(pose, 1280, 720, point + far));
}

}  // namespace
}  // namespace taut
