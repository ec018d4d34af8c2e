// Shadows on grounds, as wide at their edges as what throws them is far off, and what keeps the sky from a
// ground.

#include "geometry/ground_shade.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "geometry/palette.h"
#include "small_scenes.h"

namespace taut {
namespace {

using testing::bare_look;
using testing::channel_at;
using testing::draw_once;
using testing::row_of_masses;

constexpr Size large{640, 360};

// From displayed to linear; see shaders/lighting.glsl.
double linear(double displayed) {
  const double square = displayed * displayed / 65025.0;
  return square / (1.0 - 0.12 * square);
}

// A scene with a ground, drawn with and without shadows from one place.
class GroundPicture {
 public:
  GroundPicture(const Built& scene, const Look& look, const CameraPose& pose) : pose_(pose) {
    RenderSettings settings{.size = large, .samples = 4, .shadow_map_size = 2048, .transparent = false};
    shaded_ = draw_once(scene.model, scene.start, look, settings, pose);
    Look unshaded = look;
    unshaded.shadows = false;
    lit_ = draw_once(scene.model, scene.start, unshaded, settings, pose);
  }

  // How much darker a place is, in levels of green.
  int darkening(const Vec3& place) const {
    const Vec3 at = picture_position(pose_, large.width, large.height, place);
    const int x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
    return channel_at(lit_, x, y, 1) - channel_at(shaded_, x, y, 1);
  }
  // Which share of the light is missing at a place.
  double missing(const Vec3& place) const {
    const Vec3 at = picture_position(pose_, large.width, large.height, place);
    const int x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
    return 1.0 - linear(channel_at(shaded_, x, y, 1)) / linear(channel_at(lit_, x, y, 1));
  }

 private:
  CameraPose pose_;
  Image shaded_, lit_;
};

Look with_ground() {
  Look look = bare_look();
  look.ground = look.shadows = look.masses = true;
  return look;
}

// A mass out of the way, a ground at y = 0, and a thin plate that ends at x = −1, so high.
Built plate_at(double height) {
  Description description;
  MassSpec mass;
  mass.name = "far";
  mass.position = {1.0, 0.02, 1.0};
  mass.radius = 0.01;
  description.masses.push_back(mass);
  BoxSpec plate;
  plate.centre = {0.0, height, 0.0};
  plate.size = {2.0, 0.002, 3.0};
  description.boxes = {plate};
  Built scene = build(description);
  scene.model.colliders.push_back(Collider{HalfSpace{}});
  return scene;
}

// How far it is (m) from where a tenth of the light is missing to where nine tenths are.
double penumbra_of_plate(double height, double eye, double inside) {
  const glm::vec3 light = direction_to_light();
  const double slant = double(light.x / light.y);
  const Vec3 edge(-1.0 - slant * height, 0.0, -double(light.z / light.y) * height);
  // Straight above the shadow's edge, a little aside of the grid's lines.
  const CameraPose pose{edge + Vec3(0.0, eye, 1e-3), edge, 38.0};
  const GroundPicture seen(plate_at(height), with_ground(), pose);
  const double whole = seen.missing(edge + Vec3(inside, 0.0, 0.05));
  EXPECT_GT(whole, 0.2);
  double dark = 0.0, bright = 0.0;
  for (double x = -inside; x < inside; x += 0.0005) {
    const double share = seen.missing(edge + Vec3(x, 0.0, 0.05)) / whole;
    if (share < 0.1) bright = x;
    if (share < 0.9) dark = x;
  }
  return dark - bright;
}

TEST(Penumbra, IsAsWideAsTheLightSaysAndGrowsWithTheHeight) {
  const glm::vec3 light = direction_to_light();
  for (const double height : {0.6, 1.2, 2.4}) {
    // Of a round light, 0.687 of the radius lies on each side between a tenth and nine tenths; the circle
    // that it draws across its way is stretched along x where it falls on the ground.
    const double stretch = std::hypot(1.0, double(light.x / light.y));
    const double expected = 2.0 * 0.687 * double(light_spread) * height / double(light.y) * stretch;
    EXPECT_NEAR(penumbra_of_plate(height, 1.2, 0.35) / expected, 1.0, 0.15) << height << " m high";
  }
}

TEST(Penumbra, IsSharpWhereAThingTouchesTheGround) {
  EXPECT_LT(penumbra_of_plate(0.05, 0.6, 0.025), 0.015);
}

// A ball of 0.5 m, so high above the ground, seen from the side that is lit, low over the ground.
GroundPicture ball_at(double height) {
  Built scene = row_of_masses({{0.0, 0.5 + height, 0.0}});
  scene.model.colliders = {Collider{HalfSpace{}}};
  Look look = with_ground();
  look.mass_radius = 0.5;
  return {scene, look, {{3.9, 0.9, 3.2}, {0.0, 0.4, 0.0}, 38.0}};
}

Vec3 towards_light(double distance) {
  const glm::vec3 light = direction_to_light();
  return distance * Vec3(double(light.x), 0.0, double(light.z)).normalized();
}

TEST(Contact, ABallDarkensTheGroundAroundWhereItTouches) {
  const GroundPicture ball = ball_at(0.0);
  // From 0.45 of its radius on no shadow falls on this side.
  EXPECT_GT(ball.darkening(towards_light(0.27)), 10);
  int before = 255;
  for (double distance = 0.2; distance < 1.6; distance += 0.02) {
    const int darker = ball.darkening(towards_light(distance));
    EXPECT_LE(darker, before) << distance << " m away";
    before = darker;
  }
  for (double distance = 1.4; distance < 2.5; distance += 0.1)
    EXPECT_EQ(ball.darkening(towards_light(distance)), 0) << distance << " m away";
}

TEST(Contact, WhatIsFarAboveTheGroundDarkensNothing) {
  const GroundPicture ball = ball_at(0.6);
  for (double distance = -0.1; distance < 1.6; distance += 0.1)
    EXPECT_EQ(ball.darkening(towards_light(distance)), 0) << distance << " m away";
}

TEST(Reduced, PixelsFindTheirPlaceWhateverThePartAndTheSize) {
  for (const Size& whole : {Size{640, 360}, Size{641, 359}, Size{33, 17}})
    for (const Region& part :
         {Region{0, 0, whole.width, whole.height}, Region{7, 5, 20, 9}, Region{8, 6, 1, 1}}) {
      const Reduced made = reduced(part, whole);
      EXPECT_LE(made.corner.x + made.part.width, made.picture.width);
      EXPECT_LE(made.corner.y + made.part.height, made.picture.height);
      for (const glm::vec2& pixel : {glm::vec2(0.5F), glm::vec2(part.width, part.height) - 0.5F}) {
        const glm::vec2 texel = pixel * made.scale + made.start + glm::vec2(made.corner);
        const glm::vec2 share =
            (pixel + glm::vec2(part.left, part.top)) / glm::vec2(whole.width, whole.height);
        EXPECT_NEAR(texel.x / static_cast<float>(made.picture.width), share.x, 1e-5F);
        EXPECT_NEAR(texel.y / static_cast<float>(made.picture.height), share.y, 1e-5F);
        EXPECT_GE(texel.x, static_cast<float>(made.corner.x));
        EXPECT_LE(texel.x, static_cast<float>(made.corner.x + made.part.width));
      }
    }
}

TEST(Grounds, AreAsDarkAtTheEdgesOfThePictureAsBeside) {
  Built scene = row_of_masses({{0.0, 0.5, 0.0}});
  scene.model.colliders = {Collider{HalfSpace{}}};
  Look look = with_ground();
  look.mass_radius = 0.3;
  // The shadow's middle is at the picture's edge, the upper or the lower one.
  for (const Size& whole : {Size{160, 91}, Size{161, 90}})
    for (const double middle : {0.0, -0.56}) {
      const RenderSettings settings{.size = whole, .samples = 4, .shadow_map_size = 1024};
      const CameraPose pose{{-0.34, 4.0, middle + 0.02}, {-0.34, 0.0, middle}, 8.0};
      const Image shaded = draw_once(scene.model, scene.start, look, settings, pose);
      const auto green_at = [&](int x, int y) { return channel_at(shaded, x, y, 1); };
      int darkest = 255;
      for (int x = 1; x < 80; ++x) {  // further right is the ball
        EXPECT_NEAR(green_at(x, 0), green_at(x, 1), 9) << x;
        EXPECT_NEAR(green_at(x, whole.height - 1), green_at(x, whole.height - 2), 9) << x;
        darkest = std::min({darkest, green_at(x, 0), green_at(x, whole.height - 1)});
      }
      EXPECT_LT(darkest, 140) << "a shadow";
    }
}

}  // namespace
}  // namespace taut
