// Bodies in the picture: tapered rods and balls are as round as they should be, limbs meet without seams, and
// several bodies are told apart.

#include "geometry/figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "colour_vision.h"
#include "geometry/body_hues.h"
#include "geometry/geometry.h"
#include "geometry/torso.h"
#include "geometry/view_matrices.h"
#include "small_scenes.h"

namespace taut {
namespace {

using testing::bare_look;
using testing::channel_at;
using testing::cut_out;
using testing::draw_once;
using testing::straight_on;

constexpr double pi = std::numbers::pi;

Built doll_scene(const PoseSpec& pose = {}, std::size_t count = 1) {
  Description description;
  for (std::size_t i = 0; i < count; ++i) {
    RagdollSpec doll;
    doll.name = "doll" + std::to_string(i);
    doll.position = {1.2 * static_cast<double>(i), 0.0, 0.0};
    doll.pose = pose;
    description.ragdolls.push_back(doll);
  }
  return build(description);
}

Bodies figures_of(const Built& scene, const Look& look = bare_look()) {
  return GeometryMaker(scene.model, scene.start, look).make(scene.start, straight_on())->bodies;
}

Image draw_rods(const std::vector<TaperedRod>& rods, const CameraPose& pose, const RenderSettings& settings) {
  const auto context = make_gl_context({});
  Renderer renderer(*context, bare_look(), settings);
  Geometry geometry;
  geometry.pose = pose;
  geometry.bodies.rods = rods;
  geometry.bounds = {glm::vec3(-1e3F), glm::vec3(1e3F)};
  return flatten(*renderer.draw(geometry));
}

// A pose from so far away that a ball's picture is as good as its section, and a metre so many pixels.
CameraPose from_afar(const Size& picture, double pixels_a_metre) {
  CameraPose pose;
  pose.eye = Vec3::Zero();
  pose.target = {0.0, 0.0, -2000.0};
  pose.field_of_view = 2.0 * std::atan(0.5 * picture.height / pixels_a_metre / 2000.0) * 180.0 / pi;
  return pose;
}

constexpr Colour grey{0.6, 0.6, 0.6};

TEST(TaperedRod, ABallIsRoundAtAnySize) {
  for (const int radius : {5, 12, 40, 130, 400}) {
    const Size picture{2 * radius + 60, 2 * radius + 60};
    const Vec3 centre{0.0, 0.0, -2000.0};
    const Image image = draw_rods({tapered_rod(centre, 1.0, centre, 1.0, grey)}, from_afar(picture, radius),
                                  cut_out(picture));
    // Across the edge along rays: how far out the ball reaches, by the share of each pixel that it covers.
    double least = 1e9, most = 0.0;
    for (int ray = 0; ray < 360; ++ray) {
      const double angle = ray * pi / 180.0;
      double reach = 0.0;
      constexpr double step = 0.1;
      for (double along = 0.5 * step; along < radius + 20.0; along += step) {
        const auto x = static_cast<int>(std::floor(0.5 * picture.width + along * std::cos(angle)));
        const auto y = static_cast<int>(std::floor(0.5 * picture.height + along * std::sin(angle)));
        reach += step * channel_at(image, x, y, 3) / 255.0;
      }
      least = std::min(least, reach);
      most = std::max(most, reach);
    }
    // A quarter of a pixel is what four samples leave of any edge.
    EXPECT_GT(least, radius - 0.62) << radius;
    EXPECT_LT(most, radius + 0.5) << radius;
  }
}

// Whether a place (m, in the picture's plane) is in the hull of two circles.
bool in_hull(const glm::dvec2& place, const glm::dvec2& a, double a_radius, const glm::dvec2& b,
             double b_radius) {
  // A ball between both has its centre and radius between theirs: the hull is all of these.
  for (int i = 0; i <= 100; ++i) {
    const double share = i / 100.0;
    if (glm::length(place - glm::mix(a, b, share)) <= std::lerp(a_radius, b_radius, share)) return true;
  }
  return false;
}

TEST(TaperedRod, CoversTheHullOfItsBalls) {
  const Size picture{240, 240};
  struct Case {
    double start_radius, end_radius, squeeze;
  };
  for (const Case& is : {Case{0.5, 0.2, 0.0}, Case{0.1, 0.6, 0.0}, Case{0.7, 0.05, 0.0}, Case{0.9, 0.1, 0.0},
                         Case{0.4, 0.4, 0.0}, Case{0.6, 0.3, 0.7}}) {
    const glm::dvec2 a(-0.35, -0.2), b(0.3, 0.25);
    TaperedRod rod =
        tapered_rod({a.x, a.y, -2000.0}, is.start_radius, {b.x, b.y, -2000.0}, is.end_radius, grey);
    rod.squeeze = {0.0F, static_cast<float>(is.squeeze), 0.0F};
    const Image image = draw_rods({rod}, from_afar(picture, 100.0), cut_out(picture));
    // Heights unsqueezed.
    const double stretch = 1.0 / (1.0 - is.squeeze * is.squeeze);
    const auto unsqueezed = [&](const glm::dvec2& at) { return glm::dvec2(at.x, at.y * stretch); };
    int wrong = 0;
    for (int y = 1; y < picture.height - 1; ++y)
      for (int x = 1; x < picture.width - 1; ++x) {
        const auto inside = [&](double right, double down) {
          const glm::dvec2 at((x + 0.5 + right - 120.0) / 100.0, -(y + 0.5 + down - 120.0) / 100.0);
          return in_hull(unsqueezed(at), unsqueezed(a), is.start_radius, unsqueezed(b), is.end_radius);
        };
        const bool middle = inside(0, 0);
        const bool near_edge = inside(1.5, 0) != middle || inside(-1.5, 0) != middle ||
                               inside(0, 1.5) != middle || inside(0, -1.5) != middle;
        if (!near_edge && channel_at(image, x, y, 3) != (middle ? 255 : 0)) ++wrong;
      }
    EXPECT_EQ(wrong, 0) << is.start_radius << ' ' << is.end_radius << ' ' << is.squeeze;
  }
}

TEST(TaperedRod, ThrowsItsOwnShadow) {
  // A thick end and a thin one above a floor: between the two the shadow narrows.
  Description description;
  MassSpec mass;
  mass.position = {0.0, 0.0, -3.0};
  mass.name = "far";
  description.masses = {mass};
  description.planes = {PlaneSpec{}};
  const Built scene = build(description);
  Look look = bare_look();
  look.ground = look.shadows = true;
  const CameraPose pose{{0.0, 6.0, 0.01}, {0.0, 0.0, 0.0}, 38.0};
  const RenderSettings settings{.size = {320, 320}, .samples = 4, .shadow_map_size = 1024};
  const auto geometry = GeometryMaker(scene.model, scene.start, look).make(scene.start, pose);
  Geometry with_rod = *geometry;
  const PictureSpace space(pose);
  // The light comes from (0.68, 1, 0.56): at height 1 the shadow is displaced by −0.68 and −0.56.
  with_rod.bodies.rods = {
      tapered_rod(space.place({-0.3, 1.0, 0.0}), 0.40, space.place({1.5, 1.0, 0.0}), 0.04, grey)};
  with_rod.bounds = {to_glm(space.place({-2.0, 0.0, 2.0})), to_glm(space.place({2.0, 1.5, -2.0}))};
  with_rod.bounds = {glm::min(with_rod.bounds.low, with_rod.bounds.high),
                     glm::max(with_rod.bounds.low, with_rod.bounds.high)};
  const auto context = make_gl_context({});
  Renderer renderer(*context, look, settings);
  const Image lit = flatten(*renderer.draw(*geometry)), shaded = flatten(*renderer.draw(with_rod));
  const auto darkening = [&](const Vec3& place) {
    const Vec3 at = picture_position(pose, 320, 320, place);
    const int x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
    return channel_at(lit, x, y, 1) - channel_at(shaded, x, y, 1);
  };
  EXPECT_GT(darkening({-0.98, 0.0, -0.86}), 25) << "under the thick end's side";
  EXPECT_LT(darkening({0.62, 0.0, -0.86}), 3) << "beside the thin end";
  EXPECT_GT(darkening({0.60, 0.0, -0.56}), 25) << "under the thin end";
}

TEST(Torso, IsAClosedSkinThatLooksOutwards) {
  for (const int sides : {8, 40}) {
    const std::vector<TorsoVertex> skin = torso_vertices(sides, 30);
    ASSERT_EQ(skin.size(), static_cast<std::size_t>(31 * sides));
    const auto corners = torso_corners();
    for (const TorsoVertex& vertex : skin) {
      EXPECT_NEAR(glm::length(vertex.outward), 1.0F, 1e-4F);
      // From the line of its middles outwards, and within its box.
      const glm::vec3 from_middle = vertex.place - glm::vec3(0.0F, 0.13F, 0.0F);
      EXPECT_GT(glm::dot(vertex.outward, from_middle), 0.0F);
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(vertex.place[axis], corners.front()[axis]);
        EXPECT_LE(vertex.place[axis], corners.back()[axis]);
      }
    }
  }
}

double distance_to(const Bone& bone, const State& state, const Vec3& place) {
  const auto end = [&](const std::array<Index, 2>& masses) -> Vec3 {
    return 0.5 * (state.position.at(masses[0]) + state.position.at(masses[1]));
  };
  const Vec3 from = end(bone.from), span = end(bone.to) - from;
  const double length = span.squaredNorm();
  const double share = length > 0.0 ? std::clamp((place - from).dot(span) / length, 0.0, 1.0) : 0.0;
  return (place - from - share * span).norm() - bone.radius;
}

TEST(Figures, KeepCloseToWhatCollides) {
  PoseSpec bent;
  bent.left_elbow = 60.0;
  bent.right_knee = -70.0;
  bent.left_hip = 50.0;
  const Built scene = doll_scene(bent);
  const double height = 1.75;
  const auto beyond = [&](const Vec3& seen) {
    const Vec3 place = seen + straight_on().eye;
    double least = 1e9;
    for (const Bone& bone : scene.model.bones) least = std::min(least, distance_to(bone, scene.start, place));
    return least / height;
  };
  const Bodies bodies = figures_of(scene);
  ASSERT_EQ(bodies.torsos.size(), 1U);
  const TorsoRecord& torso = bodies.torsos[0];
  double farthest = 0.0;
  for (const TorsoVertex& vertex : torso_vertices(40, 40)) {
    const glm::vec3 at = torso.origin + vertex.place.x * torso.axes[0] + vertex.place.y * torso.axes[1] +
                         vertex.place.z * torso.axes[2];
    farthest = std::max(farthest, beyond({at.x, at.y, at.z}));
  }
  EXPECT_LT(farthest, 0.034) << "the trunk";
  for (const TaperedRod& rod : bodies.rods)
    for (int end = 0; end < 2; ++end) {
      const glm::vec3 at = end == 0 ? rod.start : rod.end;
      const float radius =
          (end == 0 ? rod.start_radius : rod.end_radius) * (1.0F - glm::dot(rod.squeeze, rod.squeeze));
      EXPECT_LT(beyond({at.x, at.y, at.z}) + static_cast<double>(radius) / height, 0.03)
          << "a rod from " << rod.start.x << ' ' << rod.start.y << ' ' << rod.start.z;
    }
}

TEST(Figures, ShadingRunsOnSmoothlyThroughABentElbow) {
  PoseSpec bent;
  bent.left_elbow = 80.0;
  bent.left_shoulder = 20.0;
  const Built scene = doll_scene(bent);
  const auto place = [&](const std::string& name) -> Vec3 {
    const auto& names = scene.model.masses.name;
    const auto mass = std::ranges::find(names, "doll0." + name) - names.begin();
    return scene.start.position.at(static_cast<std::size_t>(mass));
  };
  const Vec3 elbow = 0.5 * (place("left_elbow.left") + place("left_elbow.right"));
  const Vec3 shoulder = place("left_shoulder"), wrist = place("left_wrist");
  for (const Colour& side : {Colour{2.0, 0.0, 0.0}, Colour{1.4, -0.6, -1.2}}) {
    const CameraPose pose{elbow + Vec3(side[0], side[1], side[2]), elbow, 20.0};
    const Image image = draw_once(scene.model, scene.start, bare_look(), cut_out({480, 480}), pose);
    int before = -1, largest = 0, covered = 0;
    for (int i = -200; i <= 200; ++i) {
      // Along the middle of the upper arm to the elbow and on along the forearm.
      const Vec3 at = i < 0 ? Vec3(elbow + i / 200.0 * 0.6 * (elbow - shoulder))
                            : Vec3(elbow + i / 200.0 * 0.6 * (wrist - elbow));
      const Vec3 pixel = picture_position(pose, 480, 480, at);
      const int x = static_cast<int>(pixel.x()), y = static_cast<int>(pixel.y());
      const int now = channel_at(image, x, y, 1);
      covered += channel_at(image, x, y, 3) == 255 ? 1 : 0;
      if (before >= 0) largest = std::max(largest, std::abs(now - before));
      before = now;
    }
    EXPECT_EQ(covered, 401);
    EXPECT_LE(largest, 8) << "levels from a pixel to the next";
  }
}

TEST(Figures, LimbsThatMeetHaveOneColourThereWhateverTheyAreColouredBy) {
  Built scene = doll_scene();
  for (std::size_t i = 0; i < scene.model.masses.size(); ++i)
    scene.start.velocity.set(i, Vec3(0.1 * static_cast<double>(i), 0.0, 0.0));
  Look look = bare_look();
  look.colour_by = ColourBy::speed;
  const Bodies bodies = figures_of(scene, look);
  int meetings = 0;
  bool graded = false;
  for (const TaperedRod& one : bodies.rods)
    for (const TaperedRod& other : bodies.rods) {
      graded = graded || one.start_colour != one.end_colour;
      if (one.end != other.start) continue;
      ++meetings;
      EXPECT_EQ(one.end_radius, other.start_radius);
      EXPECT_EQ(one.end_colour, other.start_colour);
    }
  EXPECT_GE(meetings, 8) << "elbows and knees, wrists and ankles";
  EXPECT_TRUE(graded) << "colours run from joint to joint";
}

// As an eye without the cones for green sees a colour.
Oklab without_green_cones(const Colour& colour) {
  std::array<double, 3> light{};
  for (std::size_t i = 0; i < 3; ++i) light[i] = std::pow(colour[i], 2.2);
  const auto [red, green, blue] = testing::without_green_cones(light);
  const auto shown = [](double value) { return std::pow(std::clamp(value, 0.0, 1.0), 1.0 / 2.2); };
  return oklab({shown(red), shown(green), shown(blue)});
}

double difference(const Oklab& a, const Oklab& b) {
  return std::hypot(a.lightness - b.lightness, a.green_red - b.green_red, a.blue_yellow - b.blue_yellow);
}

TEST(BodyHues, OneBodyHasTheColourThatWasAskedFor) {
  const Colour seed{0.86, 0.74, 0.60};
  EXPECT_EQ(body_hues(seed, 1), std::vector<Colour>{seed});
}

TEST(BodyHues, SeveralAreOfOneLightnessAndToldApartAlsoWithoutRedAndGreen) {
  for (const std::size_t count : {2U, 3U, 5U, 10U, 12U}) {
    const std::vector<Colour> hues = body_hues({0.86, 0.74, 0.60}, count);
    ASSERT_EQ(hues.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_NEAR(oklab(hues[i]).lightness, oklab(hues[0]).lightness, 0.01);
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_GT(difference(oklab(hues[i]), oklab(hues[j])), 0.03) << i << ' ' << j << " of " << count;
        EXPECT_GT(difference(without_green_cones(hues[i]), without_green_cones(hues[j])), 0.016)
            << i << ' ' << j << " of " << count;
      }
    }
    if (count < 5) continue;
    for (std::size_t i = 1; i < count; ++i)
      EXPECT_GT(difference(oklab(hues[i]), oklab(hues[i - 1])), 0.07) << "neighbours " << i;
  }
}

TEST(BodyHues, OklabAndBackIsTheSameColour) {
  for (const Colour& colour : {Colour{0.2, 0.5, 0.9}, Colour{1.0, 1.0, 1.0}, Colour{0.9, 0.1, 0.3}}) {
    const Colour back = colour_of(oklab(colour));
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(back[i], colour[i], 1e-5);
  }
  EXPECT_NEAR(oklab({1.0, 1.0, 1.0}).lightness, 1.0, 1e-6);
}

TEST(Figures, SeveralBodiesHaveAHueEach) {
  const Bodies one = figures_of(doll_scene()), three = figures_of(doll_scene({}, 3));
  EXPECT_EQ(one.torsos.at(0).colour, opaque(Look{}.bone_colour));
  ASSERT_EQ(three.torsos.size(), 3U);
  EXPECT_NE(three.torsos[0].colour, three.torsos[1].colour);
  EXPECT_NE(three.torsos[1].colour, three.torsos[2].colour);
  EXPECT_NE(three.torsos[0].colour, three.torsos[2].colour);
}

}  // namespace
}  // namespace taut
