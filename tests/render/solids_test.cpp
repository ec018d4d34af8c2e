// Bones, solids and boxes in the picture.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "small_scenes.h"

namespace taut {
namespace {

using testing::bare_look;
using testing::channel_at;
using testing::cut_out;
using testing::draw_once;
using testing::size;
using testing::straight_on;

// The pixel in which straight_on() sees a place.
std::array<int, 2> pixel_of(const Vec3& place) {
  const double metre = 2.0 * std::tan(19.0 * std::numbers::pi / 180.0) / size.height;
  const double away = 5.0 - place.z();
  return {static_cast<int>(0.5 * size.width + place.x() / (away * metre)),
          static_cast<int>(0.5 * size.height - place.y() / (away * metre))};
}

int alpha_at(const Image& image, const Vec3& place) {
  const auto [x, y] = pixel_of(place);
  return channel_at(image, x, y, 3);
}

Built scene_with(Description description) {
  MassSpec mass;
  mass.name = "far";
  mass.position = {0.0, 0.0, -2.0};
  mass.radius = 0.01;
  description.masses.push_back(mass);
  return build(description);
}

TEST(Solids, ABoxCoversItsTurnedSquareAndNothingElse) {
  Description description;
  BoxSpec box;
  box.size = {1.0, 1.0, 0.2};
  box.turn = {0.0, 0.0, 45.0};
  description.boxes = {box};
  const Built scene = scene_with(description);
  const Image image = draw_once(scene.model, scene.start, bare_look(), cut_out(size), straight_on());
  EXPECT_EQ(alpha_at(image, {0.0, 0.65, 0.1}), 255) << "its corner points up";
  EXPECT_EQ(alpha_at(image, {0.45, 0.45, 0.1}), 0);
  EXPECT_EQ(alpha_at(image, {0.0, 0.0, 0.1}), 255);
  Look without = bare_look();
  without.colliders = false;
  const Image empty = draw_once(scene.model, scene.start, without, cut_out(size), straight_on());
  EXPECT_EQ(alpha_at(empty, {0.0, 0.0, 0.1}), 0);
}

TEST(Solids, ACapsuleHasRoundEnds) {
  Description description;
  description.capsules = {CapsuleSpec{{-0.5, 0.0, 0.0}, {0.5, 0.0, 0.0}, 0.3, 0.5, 0.0}};
  const Built scene = scene_with(description);
  const Image image = draw_once(scene.model, scene.start, bare_look(), cut_out(size), straight_on());
  EXPECT_EQ(alpha_at(image, {0.0, 0.27, 0.0}), 255);
  EXPECT_EQ(alpha_at(image, {0.75, 0.0, 0.0}), 255) << "the end reaches beyond the line";
  EXPECT_EQ(alpha_at(image, {0.75, 0.25, 0.0}), 0) << "and is round";
}

TEST(Bones, StandInForTheMassesAndLinksOfARagdoll) {
  Description description;
  RagdollSpec doll;
  doll.name = "doll";
  description.ragdolls = {doll};
  const Built scene = build(description);
  const Image image = draw_once(scene.model, scene.start, bare_look(), cut_out(size), straight_on());
  EXPECT_EQ(alpha_at(image, {0.0, 0.25, 0.0}), 255) << "the trunk";
  EXPECT_EQ(alpha_at(image, {0.0, -0.4, 0.0}), 0) << "between the legs";
  Look masses = bare_look();
  masses.masses = masses.links = true;
  EXPECT_EQ(draw_once(scene.model, scene.start, masses, cut_out(size), straight_on()).pixels, image.pixels);
}

// A face that is lit is lit evenly, however slant the light falls on it: no stripes of its own shadow.
TEST(Solids, FacesThrowNoShadowOnThemselves) {
  for (double turn = -50.0; turn <= 140.0; turn += 10.0) {
    Description description;
    BoxSpec box;
    box.size = {3.0, 1.4, 0.6};
    box.turn = {0.0, turn, 0.0};
    description.boxes = {box};
    const Built scene = scene_with(description);
    Look look = bare_look();
    look.shadows = true;
    RenderSettings settings = cut_out(size);
    settings.shadow_map_size = 128;
    const double angle = turn * std::numbers::pi / 180.0;
    const CameraPose facing{{5.0 * std::sin(angle), 0.0, 5.0 * std::cos(angle)}, {0.0, 0.0, 0.0}, 38.0};
    const Image image = draw_once(scene.model, scene.start, look, settings, facing);
    look.shadows = false;
    const Image unshaded = draw_once(scene.model, scene.start, look, settings, facing);
    int darker = 0;
    for (int y = size.height / 2 - 25; y < size.height / 2 + 25; ++y)
      for (int x = size.width / 2 - 60; x < size.width / 2 + 60; ++x)
        darker = std::max(darker, channel_at(unshaded, x, y, 1) - channel_at(image, x, y, 1));
    EXPECT_LE(darker, 1) << "turned by " << turn;
  }
}

TEST(Bones, JointsAtAStopShineAndOthersDoNot) {
  Description description;
  RagdollSpec doll;
  doll.name = "doll";
  doll.pose.left_knee = -90.0;   // bent as far as it goes
  doll.pose.right_knee = -46.8;  // half way
  description.ragdolls = {doll};
  const Built scene = build(description);
  Look look = bare_look();
  look.colour_by = ColourBy::limit;
  const CameraPose pose{{0.0, -0.35, 5.0}, {0.0, -0.35, 0.0}, 38.0};
  const Image image = draw_once(scene.model, scene.start, look, cut_out(size), pose);
  const auto colour_of = [&](const std::string& name) {
    const auto& names = scene.model.masses.name;
    const auto mass = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    Vec3 place = scene.start.position.at(mass);
    place.y() += 0.35;
    const auto [x, y] = pixel_of(place);
    return channel_at(image, x, y, 0) - channel_at(image, x, y, 2);  // red over blue
  };
  EXPECT_GT(colour_of("doll.left_knee.left"), 60) << "at its stop: yellow";
  EXPECT_LT(colour_of("doll.right_knee.right"), 0) << "half way: violet";
}

TEST(MassBoxes, TurnWithTheirLinks) {
  Built scene = testing::row_of_masses({{-1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}});
  Look look = bare_look();
  look.masses = true;
  look.mass_shape = MassShape::box;
  look.mass_radius = 0.3;
  State turned = scene.start;
  for (std::size_t i = 0; i < 3; ++i) {
    const double along = static_cast<double>(i) - 1.0;
    turned.position.set(i, Vec3(along, along, 0.0) / std::sqrt(2.0));
  }
  testing::StatePainter renderer(scene, look, cut_out(size));
  EXPECT_EQ(alpha_at(renderer.draw(scene.start, straight_on()), {0.25, 0.25, 0.3}), 255)
      << "a square's corner";
  const Image image = renderer.draw(turned, straight_on());
  EXPECT_EQ(alpha_at(image, {0.25, 0.25, 0.3}), 0);
  EXPECT_EQ(alpha_at(image, {0.0, 0.36, 0.3}), 255) << "now points up";
}

}  // namespace
}  // namespace taut
