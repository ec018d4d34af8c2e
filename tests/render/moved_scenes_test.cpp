// A scene that is turned or moved as a whole, gravity and camera with it, gives the same picture.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <variant>

#include "render/camera.h"
#include "small_scenes.h"

namespace taut {
namespace {

// A change of place of everything: x becomes turn·x + shift.
struct Move {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();

  Vec3 place(const Vec3& at) const { return turn * at + shift; }
  HalfSpace of(const HalfSpace& plane) const { return {place(plane.point), turn * plane.normal}; }
  Sphere of(const Sphere& sphere) const { return {place(sphere.centre), sphere.radius}; }
  Capsule of(const Capsule& capsule) const { return {place(capsule.a), place(capsule.b), capsule.radius}; }
  Box of(const Box& box) const { return {place(box.centre), box.half_size, turn * box.axes}; }
  MeshSolid of(const MeshSolid& solid) const { return {solid.mesh, place(solid.centre), turn * solid.axes}; }
};

Built moved(Built scene, const Move& move) {
  for (std::size_t i = 0; i < scene.start.position.size(); ++i)
    scene.start.position.set(i, move.place(scene.start.position.at(i)));
  scene.model.gravity = move.turn * scene.model.gravity;
  for (Collider& collider : scene.model.colliders)
    collider.shape = std::visit([&](const auto& shape) { return Shape(move.of(shape)); }, collider.shape);
  return scene;
}

struct View {
  Built scene;
  Look look;
  Camera camera;
};

View plain_view() {
  View view{testing::all_kinds(), {}, {}};
  view.look.surface = true;
  view.look.pattern = Pattern::checker;
  view.look.ground_height = 0.0;
  view.camera.eye = Vec3(1.7, 2.1, 4.6);
  view.camera.target = Vec3(0.0, 0.9, 0.0);
  return view;
}

View moved(View view, const Move& move) {
  view.scene = moved(std::move(view.scene), move);
  view.camera.eye = move.place(*view.camera.eye);
  view.camera.target = move.place(*view.camera.target);
  view.look.ground_height = up_direction(view.camera, view.scene.model).dot(move.shift);
  return view;
}

Image draw(const View& view) {
  const State& start = view.scene.start;
  return testing::draw_once(view.scene.model, start, view.look,
                            {.size = {320, 180}, .samples = 4, .shadow_map_size = 512, .transparent = false},
                            camera_pose(view.camera, view.scene.model, start, start));
}

void expect_same_picture(const View& expected, const View& actual) {
  const Image one = draw(expected), other = draw(actual);
  ASSERT_EQ(one.pixels.size(), other.pixels.size());
  int largest = 0;
  std::size_t off = 0;  // bytes by more than a level
  for (std::size_t i = 0; i < one.pixels.size(); ++i) {
    const int levels = std::abs(one.pixels[i] - other.pixels[i]);
    largest = std::max(largest, levels);
    off += levels > 1 ? 1 : 0;
  }
  // Places differ by the rounding of the move: a sample on an edge here and there falls to its other side.
  EXPECT_LE(off, one.pixels.size() / 1000) << "largest difference: " << largest << " levels";
}

class MovedScene : public ::testing::TestWithParam<MassShape> {
 protected:
  View view() const {
    View view = plain_view();
    view.look.mass_shape = GetParam();
    return view;
  }
};

TEST_P(MovedScene, LooksTheSameWhicheverWayIsUp) {
  const View upright = view();
  for (const Vec3& up : {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0.36, 0.48, -0.8)}) {
    SCOPED_TRACE(up.transpose());
    expect_same_picture(upright, moved(upright, {upright_axes(up), Vec3::Zero()}));
  }
}

TEST_P(MovedScene, LooksTheSameFarFromTheOrigin) {
  // Whole numbers of strong grid lines.
  const View near = view(), far = moved(near, {Eigen::Matrix3d::Identity(), {1e6, 2e5, -1e6}});
  expect_same_picture(near, far);
}

TEST_P(MovedScene, LooksTheSameFarFromTheOriginWithAnotherWayUp) {
  const View near = view();
  expect_same_picture(near, moved(near, {upright_axes(Vec3::UnitZ()), {1e6, -1e6, 2e5}}));
}

INSTANTIATE_TEST_SUITE_P(Masses, MovedScene, ::testing::Values(MassShape::sphere, MassShape::box),
                         [](const auto& test) {
                           return std::string(test.param == MassShape::box ? "Boxes" : "Spheres");
                         });

TEST(MovedScene, ACameraOverridesGravity) {
  View view = plain_view();
  view.scene.model.gravity = Vec3::Zero();
  View turned = moved(view, {upright_axes(Vec3::UnitZ()), Vec3::Zero()});
  turned.camera.up = Vec3(0, 0, 3);
  expect_same_picture(view, turned);
}

}  // namespace
}  // namespace taut
