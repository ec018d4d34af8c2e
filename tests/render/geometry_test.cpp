// What pictures show, worked out without OpenGL; and that what is left out of drawing would not have shown.

#include "geometry/geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/frame_block.h"
#include "geometry/region.h"
#include "small_scenes.h"

namespace taut {
namespace {

using testing::all_kinds;
using testing::bare_look;
using testing::row_of_masses;
using testing::size;
using testing::straight_on;

std::shared_ptr<const Geometry> geometry_of(const Built& scene, const Look& look, const CameraPose& pose) {
  return GeometryMaker(scene.model, scene.start, look).make(scene.start, pose);
}

Look all_drawn() {
  Look look;
  look.surface = true;
  return look;
}

// From afar, close by, from above, past the edge of the picture, and from inside the scene.
std::vector<CameraPose> views() {
  return {{{1.5, 1.6, 4.2}, {0.0, 0.8, 0.0}, 38.0},
          {{0.4, 0.9, 1.7}, {0.3, 0.8, 0.0}, 70.0},
          {{0.1, 5.0, 0.2}, {0.0, 0.0, 0.0}, 38.0},
          {{1.5, 1.6, 4.2}, {1.9, 0.8, 0.0}, 20.0},
          {{0.5, 1.2, 0.1}, {-1.0, 1.0, 0.0}, 90.0}};
}

// Visits the outermost pixels of a region, but for those at the picture's own edge.
template <typename Visit>
void for_each_at_its_edge(const Region& region, const Visit& visit) {
  const int right = region.left + region.width - 1, bottom = region.top + region.height - 1;
  for (int y = region.top; y <= bottom; ++y)
    for (int x = region.left; x <= right; ++x) {
      const bool at_side = (x == region.left && x > 0) || (x == right && x < size.width - 1);
      const bool at_end = (y == region.top && y > 0) || (y == bottom && y < size.height - 1);
      if (at_side || at_end) visit(x, y);
    }
}

TEST(DrawnRegion, NothingReachesItsEdge) {
  const Built scene = all_kinds();
  for (const CameraPose& pose : views()) {
    const Region region = drawn_region(*geometry_of(scene, all_drawn(), pose), size);
    const Image image =
        testing::draw_once(scene.model, scene.start, all_drawn(), testing::cut_out(size), pose);
    int covered = 0;
    for_each_at_its_edge(region,
                         [&](int x, int y) { covered += testing::channel_at(image, x, y, 3) > 0 ? 1 : 0; });
    EXPECT_EQ(covered, 0) << "seen from " << pose.eye.transpose();
  }
}

TEST(DrawnRegion, IsNoLargerThanItNeedsToBe) {
  const Built scene = row_of_masses({{0, 0, 0}});
  Look look = bare_look();
  look.masses = true;
  look.mass_radius = 0.5;
  const Region region = drawn_region(*geometry_of(scene, look, straight_on()), size);
  const double radius = 0.5 / 5.0 / (2.0 * std::tan(19.0 * 3.14159265 / 180.0)) * size.height;  // pixels
  EXPECT_GE(region.width, 2.0 * radius);
  EXPECT_LE(region.width, 2.6 * radius + 6.0);
  EXPECT_TRUE(drawn_region(*geometry_of(scene, bare_look(), straight_on()), size).empty());
}

TEST(ShadowRegion, NoShadowReachesItsEdge) {
  Built scene = all_kinds();
  scene.model.colliders.push_back(Collider{HalfSpace{}});
  Look lit = all_drawn();
  lit.shadows = false;
  for (const CameraPose& pose : views()) {
    const auto geometry = geometry_of(scene, all_drawn(), pose);
    if (geometry->grounds.empty()) continue;
    const RenderSettings settings{.size = size, .samples = 1, .shadow_map_size = 512};
    const float blur = 6.0F * light_block(*geometry, settings.shadow_map_size).shadow.z;
    const Region region = shadow_region(*geometry, geometry->grounds.front(), size, blur);
    // Of the ground alone: everything else is thrown away again.
    const Region drawn = drawn_region(*geometry, size);
    const Image shaded = testing::draw_once(scene.model, scene.start, all_drawn(), settings, pose);
    const Image unshaded = testing::draw_once(scene.model, scene.start, lit, settings, pose);
    int darker = 0;
    for_each_at_its_edge(region, [&](int x, int y) {
      const bool on_ground =
          x < drawn.left || x >= drawn.left + drawn.width || y < drawn.top || y >= drawn.top + drawn.height;
      if (on_ground && testing::channel_at(shaded, x, y, 1) + 2 < testing::channel_at(unshaded, x, y, 1))
        ++darker;
    });
    EXPECT_EQ(darker, 0) << "seen from " << pose.eye.transpose();
  }
}

TEST(Grounds, HideOnlyWhatReachesBelowThem) {
  Built scene = row_of_masses({{0, 0.5, 0}});
  scene.model.colliders = {Collider{HalfSpace{}}};
  Look look = bare_look();
  look.masses = look.ground = true;
  const CameraPose pose{{0.0, 1.5, 5.0}, {0.0, 0.4, 0.0}, 38.0};
  for (const auto& [radius, hides] : {std::pair{0.3, false}, std::pair{0.7, true}}) {
    look.mass_radius = radius;
    const auto geometry = geometry_of(scene, look, pose);
    ASSERT_EQ(geometry->grounds.size(), 1U);
    EXPECT_EQ(may_hide(geometry->grounds.front(), *geometry), hides) << radius;
  }
  // And it does: half of a ball that is half in the ground is seen.
  scene.start.position.set(0, {0.0, 0.0, 0.0});
  const Image image = testing::draw_once(scene.model, scene.start, look, {.size = size}, pose);
  const auto redness_at = [&](const Vec3& place) {
    const Vec3 at = picture_position(pose, size.width, size.height, place);
    const int x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
    return testing::channel_at(image, x, y, 0) - testing::channel_at(image, x, y, 1);
  };
  EXPECT_GT(redness_at({0.0, 0.4, 0.5}), 60);
  EXPECT_LT(redness_at({0.0, -0.4, 0.5}), 20) << "below the ground";
}

}  // namespace
}  // namespace taut
