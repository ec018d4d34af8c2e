#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "base/failure.h"
#include "render/camera.h"
#include "render/renderer.h"
#include "small_scenes.h"

namespace taut {
namespace {

using testing::bare_look;
using testing::channel_at;
using testing::cut_out;
using testing::draw_once;
using testing::row_of_masses;
using testing::size;
using testing::straight_on;
using testing::upright_sheet;

/// The line of sight through a place in the picture of straight_on().
Vec3 sight_through(double x, double y) {
  const double metre = 2.0 * std::tan(19.0 * std::numbers::pi / 180.0) / size.height;
  return Vec3((x - 0.5 * size.width) * metre, (0.5 * size.height - y) * metre, -1.0).normalized();
}

double distance_to_sight(const Vec3& centre, int x, int y) {
  return (centre - straight_on().eye).cross(sight_through(x + 0.5, y + 0.5)).norm();
}

/// Every pixel clearly inside the silhouette is opaque, every one clearly outside is empty.
void expect_covers_sphere(const Image& image, const Vec3& centre, double radius) {
  const double pixel = 2.0 * std::tan(19.0 * std::numbers::pi / 180.0) / size.height * 5.0;  // m
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const double away = distance_to_sight(centre, x, y);
      const int alpha = channel_at(image, x, y, 3);
      if (away < radius - pixel) {
        ASSERT_EQ(255, alpha) << "inside, at " << x << ", " << y;
      }
      if (away > radius + pixel) {
        ASSERT_EQ(0, alpha) << "outside, at " << x << ", " << y;
      }
    }
  }
}

TEST(Sphere, CoversItsDisc) {
  const Built scene = row_of_masses({{0, 0, 0}});
  Look look = bare_look();
  look.masses = true;
  look.mass_radius = 0.8;
  const Image image = draw_once(scene.model, scene.start, look, cut_out(size), straight_on());
  ASSERT_EQ(4, image.channels);
  expect_covers_sphere(image, {0, 0, 0}, 0.8);
}

TEST(Sphere, CoversItsEllipseOffCentre) {
  const Built scene = row_of_masses({{-1.9, 0.7, 0}});
  Look look = bare_look();
  look.masses = true;
  look.mass_radius = 0.5;
  const Image image = draw_once(scene.model, scene.start, look, cut_out(size), straight_on());
  expect_covers_sphere(image, {-1.9, 0.7, 0}, 0.5);
}

TEST(Sphere, NearerOneHidesTheOther) {
  // The pinned one is red, the other gold, in whichever order they are drawn.
  for (const double red_depth : {-1.0, 1.0}) {
    const Built scene = row_of_masses({{0, 0, red_depth}, {0, 0, -red_depth}});
    Look look = bare_look();
    look.masses = true;
    look.mass_radius = 0.4;
    const Image image = draw_once(scene.model, scene.start, look, cut_out(size), straight_on());
    const int green = channel_at(image, size.width / 2, size.height / 2, 1);
    if (red_depth > 0) {
      EXPECT_LT(green, 70);
    } else {
      EXPECT_GT(green, 90);
    }
  }
}

TEST(Link, LiesBetweenItsMasses) {
  const Built scene = row_of_masses({{-1, 0.5, 0}, {1, 0.5, 0}});
  Look look = bare_look();
  look.links = true;
  look.link_radius = 0.1;
  const Image image = draw_once(scene.model, scene.start, look, cut_out(size), straight_on());
  const double upper = picture_position(straight_on(), size.width, size.height, {0, 0.6, 0}).y();
  const double lower = picture_position(straight_on(), size.width, size.height, {0, 0.4, 0}).y();
  for (int y = 0; y < size.height; ++y) {
    const int alpha = channel_at(image, size.width / 2, y, 3);
    if (y + 0.5 > upper + 1.0 && y + 0.5 < lower - 1.0) {
      EXPECT_EQ(255, alpha) << "row " << y;
    }
    if (y + 0.5 < upper - 1.0 || y + 0.5 > lower + 1.0) {
      EXPECT_EQ(0, alpha) << "row " << y;
    }
  }
}

TEST(Link, ThinnerThanAPixelGrowsFaintAndStaysWhole) {
  const Built scene = row_of_masses({{-2, -0.7, 0}, {2, 0.7, 0}});
  Look look = bare_look();
  look.links = true;
  look.link_radius = 0.004;  // 0.4 pixels wide
  const Image image = draw_once(scene.model, scene.start, look, cut_out(size), straight_on());
  for (int x = 60; x < 260; ++x) {
    int most = 0;
    for (int y = 0; y < size.height; ++y) most = std::max(most, channel_at(image, x, y, 3));
    EXPECT_GT(most, 0) << "gap in column " << x;
    EXPECT_LT(most, 255) << "column " << x;
  }
}

TEST(Link, BrokenOneIsNotDrawn) {
  Built scene = row_of_masses({{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}});
  scene.start.broken_at[0] = 0.0;
  Look look = bare_look();
  look.links = true;
  look.link_radius = 0.1;
  const Image image = draw_once(scene.model, scene.start, look, cut_out(size), straight_on());
  const Vec3 broken = picture_position(straight_on(), size.width, size.height, {-0.5, 0, 0});
  const Vec3 whole = picture_position(straight_on(), size.width, size.height, {0.5, 0, 0});
  EXPECT_EQ(0, channel_at(image, static_cast<int>(broken.x()), static_cast<int>(broken.y()), 3));
  EXPECT_EQ(255, channel_at(image, static_cast<int>(whole.x()), static_cast<int>(whole.y()), 3));
}

TEST(Surface, ShowsItsOtherColourFromBehind) {
  const Built scene = upright_sheet(3, 3);
  Look look = bare_look();
  look.surface = true;
  look.surface_colour = {0.9, 0.1, 0.1};
  look.surface_back_colour = {0.1, 0.1, 0.9};
  const CameraPose behind{{0, 0, -5}, {0, 0, 0}, 38.0};
  const Image one = draw_once(scene.model, scene.start, look, cut_out(size), straight_on());
  const Image other = draw_once(scene.model, scene.start, look, cut_out(size), behind);
  const int x = size.width / 2 + 10, y = size.height / 2;
  const int redness_of_one = channel_at(one, x, y, 0) - channel_at(one, x, y, 2);
  const int redness_of_other = channel_at(other, x, y, 0) - channel_at(other, x, y, 2);
  EXPECT_GT(std::abs(redness_of_one), 60);
  EXPECT_LT(redness_of_one * redness_of_other, 0);
}

TEST(Shadow, FallsWhereTheLightPutsIt) {
  Built scene = row_of_masses({{0, 1, 0}});
  scene.model.colliders = {Collider{HalfSpace{}}};
  Look look = bare_look();
  look.masses = look.ground = look.shadows = true;
  look.mass_radius = 0.3;
  RenderSettings settings{.size = size, .samples = 4, .shadow_map_size = 256, .transparent = false};
  const CameraPose pose{{0.0, 2.5, 5.0}, {0.0, 0.4, 0.0}, 38.0};
  const Image shaded = draw_once(scene.model, scene.start, look, settings, pose);
  settings.shadow_map_size = 0;
  const Image unshaded = draw_once(scene.model, scene.start, look, settings, pose);
  ASSERT_EQ(3, shaded.channels);
  const auto darkening = [&](const Vec3& point) {
    const Vec3 place = picture_position(pose, size.width, size.height, point);
    const int x = static_cast<int>(place.x()), y = static_cast<int>(place.y());
    return channel_at(unshaded, x, y, 1) - channel_at(shaded, x, y, 1);
  };
  // The light comes from (0.68, 1, 0.56): a metre up, the shadow is that far away on the ground.
  EXPECT_GT(darkening({-0.68, 0, -0.56}), 40);
  EXPECT_EQ(0, darkening({0.68, 0, 0.56}));
}

// A picture of nothing but ground, seen from above at a slant.
Image picture_of_ground(const Built& scene, const CameraPose& pose) {
  Look look = bare_look();
  look.ground = true;
  return draw_once(scene.model, scene.start, look, {.size = size, .samples = 4, .shadow_map_size = 0}, pose);
}

TEST(Ground, ASolidOneIsASurfaceAndADrawnOneAFewFaintLines) {
  Built scene = row_of_masses({{0, 0, 0}});
  const CameraPose pose{{0.0, 2.0, 5.0}, {0.0, 0.0, 0.0}, 38.0};
  const Image drawn = picture_of_ground(scene, pose);
  scene.model.colliders = {Collider{HalfSpace{}}};
  const Image solid = picture_of_ground(scene, pose);
  // Of the lower half, all that is near: how much of it is clearly darker than the mist (brightness 237)?
  int darker_drawn = 0, darker_solid = 0, darkest_drawn = 255;
  constexpr int mist = 237, clearly = 12;
  for (int y = size.height / 2; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      darker_drawn += channel_at(drawn, x, y, 1) < mist - clearly ? 1 : 0;
      darker_solid += channel_at(solid, x, y, 1) < mist - clearly ? 1 : 0;
      darkest_drawn = std::min(darkest_drawn, channel_at(drawn, x, y, 1));
    }
  const int pixels = size.width * size.height / 2;
  EXPECT_EQ(darker_solid, pixels);
  EXPECT_LT(darker_drawn, pixels / 4);
  EXPECT_LT(darkest_drawn, mist - 5) << "there are lines";
  EXPECT_GT(darkest_drawn, mist - 60) << "and they are faint";
}

TEST(Ground, APlaneIsDrawnWhereItIs) {
  Built scene = row_of_masses({{0, 0, 0}});
  const CameraPose pose{{0.0, 0.0, 5.0}, {0.0, 0.0, 0.0}, 38.0};
  // Rising to the right at 45 degrees through the middle of the picture.
  scene.model.colliders = {Collider{HalfSpace{{0, 0, 0}, Vec3(-1, 1, 0).normalized()}}};
  EXPECT_EQ(picture_of_ground(scene, pose).pixels,
            [&] {
              Look none = bare_look();
              return draw_once(scene.model, scene.start, none,
                               {.size = size, .samples = 4, .shadow_map_size = 0}, pose);
            }()
                .pixels)
      << "the eye lies in it, so there is nothing to see";
  std::get<HalfSpace>(scene.model.colliders[0].shape).point = {0.0, -0.5, 0.0};
  const Image image = picture_of_ground(scene, pose);
  const int below = channel_at(image, size.width / 2 + 80, size.height / 2 + 10, 1);
  const int above = channel_at(image, size.width / 2 - 80, size.height / 2 - 10, 1);
  EXPECT_LT(below, above - 10) << "below the slope, and above it";
}

TEST(Transparency, IsEmptyWhereNothingIs) {
  const Built scene = row_of_masses({{0, 0, 0}});
  Look look = bare_look();
  look.ground = true;
  const Image image = draw_once(scene.model, scene.start, look, cut_out(size), straight_on());
  EXPECT_EQ(0, *std::max_element(image.pixels.begin(), image.pixels.end()));
}

TEST(Transparency, EdgesKeepTheirColour) {
  const Built scene = row_of_masses({{0, 0, 0}});
  Look look = bare_look();
  look.masses = true;
  look.mass_radius = 0.8;
  look.pin_colour = {1.0, 1.0, 1.0};
  const Image image = draw_once(scene.model, scene.start, look, cut_out(size), straight_on());
  int edges = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const int alpha = channel_at(image, x, y, 3);
      if (alpha == 0 || alpha == 255) continue;
      ++edges;
      // With the empty background mixed in, a quarter covered pixel would be under a quarter as bright.
      EXPECT_GT(channel_at(image, x, y, 1), 90) << "alpha " << alpha;
    }
  }
  EXPECT_GT(edges, 50);
}

TEST(Settings, SizesThatCannotBeDrawnAreRefused) {
  const auto context = make_gl_context();
  for (const Size bad : {Size{0, 100}, Size{100, -1}, Size{1000000, 100}}) {
    EXPECT_THROW(Renderer(*context, bare_look(), cut_out(bad)), BadRequest);
  }
}

TEST(Settings, QualitiesHaveNames) {
  EXPECT_EQ(1, render_settings_for(quality_named("draft").value()).samples);
  EXPECT_EQ(1920, render_settings_for(quality_named("fine").value()).size.width);
  EXPECT_FALSE(quality_named("best").has_value());
}

TEST(Renderer, DrawsTheSamePictureTwice) {
  const Built scene = testing::folded_sheet(8, 8);
  Look look;
  look.surface = true;
  testing::StatePainter renderer(scene, look, {.size = size});
  const CameraPose pose{{1, 1, 5}, {0, 1, 0}, 38.0};
  const Image first = renderer.draw(scene.start, pose);
  State moved = scene.start;
  moved.position.add(20, {0.1, 0, 0});
  const Image second = renderer.draw(moved, pose);
  EXPECT_EQ(first.pixels, renderer.draw(scene.start, pose).pixels);
  EXPECT_NE(first.pixels, second.pixels);
}

TEST(Renderer, DrawsTheSameWhateverItDrewBefore) {
  Built scene = testing::all_kinds();
  Look look;
  look.surface = true;
  const std::array<CameraPose, 5> poses{
      CameraPose{{1.5, 1.6, 4.2}, {0.0, 0.8, 0.0}, 38.0}, CameraPose{{1.5, 1.6, 4.2}, {0.3, 0.7, 0.0}, 38.0},
      CameraPose{{1.5, 1.6, 4.2}, {0.3, 0.7, 0.0}, 45.0}, CameraPose{{-2.0, 0.6, 3.0}, {0.0, 0.8, 0.0}, 50.0},
      CameraPose{{0.3, 4.0, 1.0}, {0.0, 0.0, 0.0}, 38.0}};
  testing::StatePainter one(scene, look, {.size = size});
  for (const std::size_t i : {0U, 1U, 2U, 2U, 3U, 4U, 0U}) {
    testing::StatePainter fresh(scene, look, {.size = size});
    EXPECT_EQ(one.draw(scene.start, poses.at(i)).pixels, fresh.draw(scene.start, poses.at(i)).pixels) << i;
  }
}

TEST(Renderer, HandsOutFramesInTheOrderTheyWereSubmitted) {
  const Built scene = testing::folded_sheet(8, 8);
  Look look;
  look.surface = true;
  testing::StatePainter painter(scene, look, {.size = size});
  const CameraPose pose{{1, 1, 5}, {0, 1, 0}, 38.0};
  State moved = scene.start;
  for (std::size_t i = 0; i < moved.position.size(); ++i) moved.position.add(i, {0.1, 0.2, 0.3});
  const Image first = painter.draw(scene.start, pose), second = painter.draw(moved, pose);
  for (int round = 0; round < 3; ++round) {
    painter.renderer().submit(*painter.maker().make(scene.start, pose));
    painter.renderer().submit(*painter.maker().make(moved, pose));
    EXPECT_EQ(flatten(*painter.renderer().fetch()).pixels, first.pixels);
    EXPECT_EQ(flatten(*painter.renderer().fetch()).pixels, second.pixels);
  }
}

/// How many different shares of a pixel the edges of a picture's things cover.
std::size_t levels_of_alpha(int samples) {
  const Built scene = testing::folded_sheet(8, 8);
  Look look = bare_look();
  look.surface = true;
  RenderSettings settings = cut_out(size);
  settings.samples = samples;
  const Image image =
      draw_once(scene.model, scene.start, look, settings, {{0.4, 1.3, 5.0}, {0.0, 1.3, 0.0}, 38.0});
  std::set<int> levels;
  for (std::size_t i = 3; i < image.pixels.size(); i += 4) levels.insert(image.pixels[i]);
  return levels.size();
}

TEST(Samples, EightMakeSmootherEdgesThanFour) {
  EXPECT_EQ(levels_of_alpha(1), 2U);
  EXPECT_EQ(levels_of_alpha(4), 5U);
  EXPECT_GE(levels_of_alpha(8), 8U);
}

TEST(Settings, AQualityGoesWithAnySize) {
  EXPECT_EQ(render_settings_for(Quality::standard).shadow_map_size,
            render_settings_for(Quality::standard, Size{640, 360}).shadow_map_size);
  const RenderSettings large = render_settings_for(Quality::fine, Size{3840, 2160});
  EXPECT_EQ(large.samples, render_settings_for(Quality::fine).samples);
  EXPECT_EQ(large.size.width, 3840);
  EXPECT_EQ(large.shadow_map_size, 4096);
  EXPECT_EQ(render_settings_for(Quality::draft, Size{3840, 2160}).shadow_map_size, 0);
  EXPECT_LE(render_settings_for(Quality::fine, Size{16384, 16384}).shadow_map_size, 8192);
}

// A picture so narrow that the sky changes by a few steps of its eight bits only.
TEST(Sky, PassesFromStepToStepWithoutBands) {
  Look look = testing::bare_look();
  const Built scene = testing::row_of_masses({{0.0, 0.0, 0.0}});
  const CameraPose pose{{0.0, 0.0, 0.0}, {0.0, 0.1, -1.0}, 2.0};
  const Image image =
      testing::draw_once(scene.model, scene.start, look, {.size = {64, 256}, .samples = 1}, pose);
  int between = 0, blocks = 0;
  for (int top = 0; top < 256; top += 4) {
    int sum = 0;
    for (int pixel = 0; pixel < 16; ++pixel)
      sum += testing::channel_at(image, 32 + pixel % 4, top + pixel / 4, 0);
    const int over_a_step = sum % 16;
    between += over_a_step >= 3 && over_a_step <= 13 ? 1 : 0;
    ++blocks;
  }
  EXPECT_GT(between, blocks / 2) << "of " << blocks << " places most lie between two steps";
}

}  // namespace
}  // namespace taut
