// What keeps light from all around from bodies and solids: one another, and grounds.

#include "geometry/contact_shade.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/geometry.h"
#include "geometry/hiders.h"
#include "small_scenes.h"

namespace taut {
namespace {

using testing::bare_look;
using testing::channel_at;
using testing::draw_once;

constexpr float shade_reach_here = 0.2F;  // m

Hider ball_hider(const Vec3& centre, double radius) {
  return hider_of(tapered_rod(centre, radius, centre, radius, {}));
}

BoxRecord box_around(const glm::vec3& centre, const glm::vec3& halves) {
  return {centre, {{halves.x, 0.0F, 0.0F}, {0.0F, halves.y, 0.0F}, {0.0F, 0.0F, halves.z}}, {}};
}

// How open a small flat thing at the origin is.
float open_to(const Hider& hider, const glm::vec3& normal, const glm::vec3& place = glm::vec3(0.0F)) {
  ShadedPoints points;
  points.add(place, normal);
  points.hide_by(hider, shade_reach_here);
  return points.openness(0);
}

TEST(Hiders, DarkenTheMoreTheNearerTheyAre) {
  for (const glm::vec3& way : {glm::vec3(0, -1, 0), glm::normalize(glm::vec3(1, -2, 0.5))}) {
    float before = 0.0F;
    for (const float away : {0.0F, 0.03F, 0.08F, 0.15F}) {
      const glm::vec3 centre = (away + 0.1F) * way;
      const float open =
          open_to(ball_hider({double(centre.x), double(centre.y), double(centre.z)}, 0.1), {0, -1, 0});
      EXPECT_GT(open, before) << away;
      before = open;
    }
    EXPECT_LT(before, 1.0F);
  }
  EXPECT_EQ(open_to(ball_hider({0.0, -0.31, 0.0}, 0.1), {0, -1, 0}), 1.0F) << "beyond the reach";
  EXPECT_EQ(open_to(ball_hider({0.0, -0.15, 0.0}, 0.1), {0, 1, 0}), 1.0F) << "behind";
}

TEST(Hiders, DarkenNothingThatLiesFlushWithThem) {
  // A rod that goes on as another, and boxes beside each other, seen from their upper sides.
  const TaperedRod rod = tapered_rod({0.0, -0.05, 0.0}, 0.05, {0.4, -0.05, 0.0}, 0.05, {});
  for (const float x : {-0.1F, -0.01F, 0.0F})
    EXPECT_NEAR(open_to(hider_of(rod), {0, 1, 0}, {x, 0.0F, 0.0F}), 1.0F, 1e-3F) << x;
  const Hider box = hider_of(box_around({0.2F, -0.2F, 0.0F}, {0.2F, 0.2F, 0.2F}));
  for (const float x : {-0.1F, -0.01F, 0.0F})
    EXPECT_NEAR(open_to(box, {0, 1, 0}, {x, 0.0F, 0.0F}), 1.0F, 1e-3F) << x;
}

TEST(Hiders, AGroundHidesHalfOfWhatAWallSeesAtItsFoot) {
  GroundPatch ground;
  ground.solid = true;
  ground.height = 0.0F;
  const Hider hider = hider_of(ground, shade_reach_here);
  EXPECT_NEAR(open_to(hider, {1, 0, 0}), std::exp(-1.6F * 0.5F), 0.02F);
  EXPECT_EQ(open_to(hider, {1, 0, 0}, {0.0F, 0.21F, 0.0F}), 1.0F);
  EXPECT_NEAR(open_to(hider, {0, 1, 0}), 1.0F, 1e-4F);
}

// All texels of two bodies of which one passes the other, a millimetre at a time.
TEST(ContactShade, ChangesLittleFromFrameToFrame) {
  std::vector<std::uint8_t> before;
  for (float x = -0.8F; x < 0.8F; x += 0.001F) {
    Bodies bodies;
    bodies.rods.push_back(tapered_rod({double(x), 0.12, 0.0}, 0.06, {double(x) + 0.3, 0.2, 0.1}, 0.04, {}));
    bodies.boxes.push_back(box_around({0.0F, -0.1F, 0.0F}, {0.3F, 0.1F, 0.2F}));
    GroundPatch ground;
    ground.solid = true;
    ground.height = 0.21F;
    add_contact_shades(bodies, {ground}, shade_reach_here);
    ASSERT_GE(bodies.boxes[0].shade.z, 2.0F) << "the ground is near it all the while";
    std::vector<std::uint8_t> faces;
    const auto width = static_cast<std::size_t>(bodies.boxes[0].shade.z + 1.0F);
    for (std::size_t y = 0; y < 2 * width; ++y)
      for (std::size_t i = 0; i < 3 * width; ++i)
        faces.push_back(
            bodies.shades.texels[(static_cast<std::size_t>(bodies.boxes[0].shade.y) + y) * ShadeTiles::width +
                                 static_cast<std::size_t>(bodies.boxes[0].shade.x) + i]);
    for (std::size_t i = 0; i < before.size(); ++i)
      ASSERT_LE(std::abs(faces[i] - before[i]), 6) << "texel " << i << " at " << x;
    before = faces;
  }
}

Look with_solids() {
  Look look = bare_look();
  look.shadows = look.ground = true;
  return look;
}

// A scene with and without what shadows bring, and how much darker a place is (levels of green).
class ContactPicture {
 public:
  ContactPicture(const Built& scene, const CameraPose& pose) : pose_(pose) {
    const RenderSettings settings{
        .size = {640, 360}, .samples = 4, .shadow_map_size = 1024, .transparent = false};
    Look look = with_solids();
    shaded_ = draw_once(scene.model, scene.start, look, settings, pose);
    look.shadows = false;
    lit_ = draw_once(scene.model, scene.start, look, settings, pose);
  }
  int darkening(const Vec3& place) const {
    const Vec3 at = picture_position(pose_, 640, 360, place);
    const int x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
    return channel_at(lit_, x, y, 1) - channel_at(shaded_, x, y, 1);
  }

 private:
  CameraPose pose_;
  Image shaded_, lit_;
};

Built on_ground(Description description) {
  MassSpec mass;
  mass.name = "far";
  mass.position = {-1.0, 0.02, -1.0};
  mass.radius = 0.01;
  description.masses.push_back(mass);
  Built scene = build(description);
  scene.model.colliders.push_back(Collider{HalfSpace{}});
  return scene;
}

constexpr double eye_away = 4.0;  // m: what is within 0.2 m darkens

TEST(ContactShade, ABoxIsDarkerAtItsFoot) {
  Description description;
  BoxSpec box;
  box.centre = {0.0, 0.4, 0.0};
  box.size = {0.8, 0.8, 0.8};
  description.boxes = {box};
  // On the side that the light falls on.
  const ContactPicture picture(on_ground(description), {{0.0, 0.4, 0.4 + eye_away}, {0.0, 0.4, 0.4}, 38.0});
  EXPECT_GT(picture.darkening({0.0, 0.015, 0.4}), 15);
  int before = 255;
  for (double height = 0.015; height < 0.4; height += 0.02) {
    const int darker = picture.darkening({0.0, height, 0.4});
    EXPECT_LE(darker, before) << height << " m high";
    before = darker;
  }
  EXPECT_EQ(picture.darkening({0.0, 0.25, 0.4}), 0);
}

TEST(ContactShade, BodiesThatTouchAreDarkerThere) {
  for (const double gap : {0.0, 0.5}) {
    Description description;
    for (const double side : {-1.0, 1.0})
      description.spheres.push_back(SphereSpec{{side * (0.3 + 0.5 * gap), 1.0, 0.0}, 0.3, 0.5, 0.0});
    const ContactPicture picture(on_ground(description), {{0.0, 1.0, eye_away}, {0.0, 1.0, 0.0}, 38.0});
    // On the left ball, half a radian off where it touches the other, towards the eye; and a place of the
    // right one that looks up.
    const double middle = 0.3 + 0.5 * gap;
    const int beside = picture.darkening({-middle + 0.3 * std::cos(0.5), 1.0, 0.3 * std::sin(0.5)});
    EXPECT_TRUE(gap > 0.0 || beside > 12) << beside;
    EXPECT_EQ(picture.darkening({middle + 0.1, 1.0 + 0.3 * std::sin(0.9), 0.15}), 0) << gap;
  }
}

TEST(ContactShade, IsThereOnlyWithShadowsAndWhereColoursMeanNothing) {
  const Built scene = testing::all_kinds();
  const auto shades = [&](const Look& look) {
    return GeometryMaker(scene.model, scene.start, look)
        .make(scene.start, {{0.0, 1.0, 5.0}, {0.0, 1.0, 0.0}, 38.0})
        ->bodies;
  };
  Look look = with_solids();
  const Bodies shaded = shades(look);
  EXPECT_FALSE(shaded.shades.texels.empty());
  EXPECT_TRUE(std::ranges::any_of(shaded.rods, [](const TaperedRod& rod) { return rod.shade != no_shade; }));
  look.colour_by = ColourBy::speed;
  EXPECT_TRUE(shades(look).shades.texels.empty());
  look.colour_by = ColourBy::plain;
  look.shadows = false;
  const Bodies plain = shades(look);
  EXPECT_TRUE(plain.shades.texels.empty());
  EXPECT_TRUE(std::ranges::all_of(plain.rods, [](const TaperedRod& rod) { return rod.shade == no_shade; }));
}

}  // namespace
}  // namespace taut
