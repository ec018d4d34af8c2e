// Sag and rest shapes of a scene that is turned as a whole, gravity with it.

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include "measure/rest_shape.h"
#include "model/measures.h"
#include "scenes_of_the_program.h"

namespace taut::test {
namespace {

Scene turned(Scene scene, const Eigen::Matrix3d& turn) {
  scene.model.gravity = turn * scene.model.gravity;
  for (std::size_t i = 0; i < scene.start.position.size(); ++i)
    scene.start.position.set(i, turn * scene.start.position.at(i));
  for (DrivenPin& pin : scene.model.driven_pins) {
    auto& path = std::get<Path>(pin.motion);
    for (Knot& knot : path.knots) knot.position = turn * knot.position;
    for (Vec3& velocity : path.velocities) velocity = turn * velocity;
  }
  return scene;
}

std::vector<Eigen::Matrix3d> turns() {
  const auto about = [](double angle, const Vec3& axis) {
    return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  };
  const double quarter = 0.5 * std::numbers::pi;
  return {about(quarter, Vec3::UnitX()), about(quarter, Vec3::UnitZ()), about(2.0 * quarter, Vec3::UnitX()),
          about(0.8, Vec3(1.0, -2.0, 0.5))};
}

TEST(GravityDirection, SagIsAlongGravity) {
  const Scene scene = scene_called("hanging-chain-two-pins");
  const State rest = exact_rest_shape(scene.model, scene.start, {}).state;
  const double upright = sag(scene.model, rest);
  for (const Eigen::Matrix3d& turn : turns()) {
    Scene other = turned(scene, turn);
    State state = rest;
    for (std::size_t i = 0; i < rest.position.size(); ++i) state.position.set(i, turn * rest.position.at(i));
    EXPECT_NEAR(sag(other.model, state), upright, 1e-12) << other.model.gravity.transpose();
  }
}

TEST(GravityDirection, WithoutGravityYIsUp) {
  Scene scene = scene_called("hanging-chain-two-pins");
  const double with = sag(scene.model, scene.start);
  scene.model.gravity = Vec3::Zero();
  EXPECT_EQ(up_direction(scene.model), Vec3(0, 1, 0));
  EXPECT_EQ(sag(scene.model, scene.start), with);
}

TEST(GravityDirection, ExactRestShapesTurnWithIt) {
  for (const char* name : {"hanging-chain-two-pins", "hanging-chain"}) {
    const Scene scene = scene_called(name);
    const State rest = exact_rest_shape(scene.model, scene.start, {}).state;
    for (const Eigen::Matrix3d& turn : turns()) {
      const Scene other = turned(scene, turn);
      const RestShape shape = exact_rest_shape(other.model, other.start, {});
      EXPECT_EQ(shape.how, "balance of forces") << name << ", gravity " << other.model.gravity.transpose();
      double farthest = 0.0;
      for (std::size_t i = 0; i < rest.position.size(); ++i)
        farthest = std::max(farthest, (shape.state.position.at(i) - turn * rest.position.at(i)).norm());
      EXPECT_LT(farthest, 1e-11) << name << ", gravity " << other.model.gravity.transpose();
      EXPECT_NEAR(shape.state.tension[0], rest.tension[0], 1e-9);
      EXPECT_NEAR(sag(other.model, shape.state), sag(scene.model, rest), 1e-12);
    }
  }
}

}  // namespace
}  // namespace taut::test
