// What holds the pins of a scene, worked out from its model.

#include "geometry/supports.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/geometry.h"
#include "small_scenes.h"

namespace taut {
namespace {

using testing::bare_look;
using testing::row_of_masses;

constexpr double pin_size = 0.02;  // m
const std::array floor_at_zero{Ground{}};

Supports supports_on_floor(const Built& scene) {
  return supports(scene.model, scene.start.position, {Vec3::UnitY(), floor_at_zero, pin_size});
}

// The longest of what stands still.
const SupportPart& longest(const Supports& made) {
  return *std::ranges::max_element(
      made.fixed, {}, [](const SupportPart& part) -> double { return (part.end - part.start).norm(); });
}

double distance_to_axis(const SupportPart& part, const Vec3& place) {
  const Vec3 span = part.end - part.start;
  const double share = span.squaredNorm() > 0.0
                           ? std::clamp((place - part.start).dot(span) / span.squaredNorm(), 0.0, 1.0)
                           : 0.0;
  return (place - part.start - share * span).norm();
}

SheetSpec sheet_of(int rows, int columns, const Vec3& from, const Vec3& to, const Vec3& down,
                   std::vector<std::string> pinned) {
  SheetSpec sheet;
  sheet.name = "cloth";
  sheet.rows = rows;
  sheet.columns = columns;
  sheet.from = from;
  sheet.to = to;
  sheet.down = down;
  sheet.pinned = std::move(pinned);
  return sheet;
}

Built only(const SheetSpec& sheet) {
  Description description;
  description.sheets = {sheet};
  return build(description);
}

SheetSpec drawn_curtain() {
  SheetSpec sheet = sheet_of(8, 28, {-1.0, 2.0, 0.0}, {1.0, 2.0, 0.0}, {0.0, -1.5, 0.0}, {});
  sheet.hooks.every = 9;
  sheet.hooks.draw = {{0.0, 1.0}, {2.0, 1.2}, {4.0, 0.4}};
  sheet.fullness = 1.6;
  return sheet;
}

TEST(Supports, DrivenHooksRunOnARailAsLongAsTheyEverMove) {
  const Built scene = only(drawn_curtain());
  const Supports made = supports_on_floor(scene);
  const SupportPart& rail = longest(made);
  EXPECT_NEAR(std::abs((rail.end - rail.start).normalized().x()), 1.0, 1e-9);
  State state = scene.start;
  for (double time = 0.0; time <= 5.0; time += 0.25) {
    place_pins(scene.model, time, state.position, state.velocity);
    for (const DrivenPin& hook : scene.model.driven_pins) {
      const Vec3 at = state.position.at(hook.mass);
      const Vec3 above = at + Vec3::UnitY() * (rail.start.y() - at.y());
      EXPECT_LT(distance_to_axis(rail, above), 1e-9) << "at " << time << " s";
    }
  }
  EXPECT_GT(rail.start.y(), 2.0);
  EXPECT_LT(rail.start.y(), 2.15) << "the cloth hangs just below";
  // A ring around the rail for each pin, which hangs from its lower side.
  ASSERT_EQ(made.carried.size(), scene.model.driven_pins.size());
  for (const CarriedPart& ring : made.carried) {
    const Vec3 at = scene.start.position.at(ring.mass);
    EXPECT_LT(distance_to_axis(rail, at + ring.part.start), 1e-9);
    EXPECT_NEAR(ring.part.start.norm(), ring.part.start_radius, 0.1 * ring.part.start_radius);
    EXPECT_TRUE(scene.model.masses.pinned(ring.mass));
  }
}

TEST(Supports, HooksAtRestHangOnARailToo) {
  SheetSpec sheet = drawn_curtain();
  sheet.hooks.draw.clear();
  const Built scene = only(sheet);
  const Supports made = supports_on_floor(scene);
  EXPECT_EQ(made.carried.size(), 4U);
  EXPECT_GT((longest(made).end - longest(made).start).norm(), 2.0);
}

TEST(Supports, AnUprightEdgeIsAPoleDownToTheGround) {
  const Built scene = only(sheet_of(6, 9, {0.5, 2.4, 0.0}, {2.0, 2.4, 0.0}, {0.0, -1.0, 0.0}, {"left"}));
  const Supports made = supports_on_floor(scene);
  const SupportPart& pole = longest(made);
  const auto [low, high] = std::minmax(pole.start.y(), pole.end.y());
  EXPECT_NEAR(low, 0.0, 1e-9);
  EXPECT_GT(high, 2.4);
  EXPECT_LT(high, 2.7);
  for (std::size_t mass = 0; mass < scene.model.masses.size(); mass += 9)
    EXPECT_LT(distance_to_axis(pole, scene.start.position.at(mass)), 1e-9);
  EXPECT_TRUE(made.carried.empty());

  // Without a ground it ends below the cloth, somewhere.
  const Supports floating = supports(scene.model, scene.start.position, {Vec3::UnitY(), {}, pin_size});
  const SupportPart& short_pole = longest(floating);
  const double end = std::min(short_pole.start.y(), short_pole.end.y());
  EXPECT_LT(end, 1.4);
  EXPECT_GT(end, 0.8);
}

TEST(Supports, APinnedEdgeIsHeldByABar) {
  const Built scene = only(sheet_of(6, 9, {-1.0, 2.0, 0.0}, {1.0, 2.0, 0.0}, {0.0, -1.0, 0.0}, {"top"}));
  const Supports made = supports_on_floor(scene);
  const SupportPart& bar = longest(made);
  for (Index mass = 0; mass < 9; ++mass)
    EXPECT_LT(distance_to_axis(bar, scene.start.position.at(mass)), 1e-9);
  EXPECT_GT(std::abs(bar.end.x() - bar.start.x()), 2.0);
  EXPECT_LT(std::abs(bar.end.x() - bar.start.x()), 2.5);
}

TEST(Supports, CornersOfALevelNetStandOnPosts) {
  const Built scene = only(sheet_of(5, 5, {-1.0, 1.2, -1.0}, {1.0, 1.2, -1.0}, {0.0, 0.0, 2.0},
                                    {"top-left", "top-right", "bottom-left", "bottom-right"}));
  const Supports made = supports_on_floor(scene);
  int posts = 0;
  for (const SupportPart& part : made.fixed) {
    if ((part.end - part.start).norm() < 1.0) continue;
    ++posts;
    const auto [low, high] = std::minmax(part.start.y(), part.end.y());
    EXPECT_NEAR(low, 0.0, 1e-9);
    EXPECT_GT(high, 1.2);
    EXPECT_NEAR(std::abs(part.start.x()), std::abs(part.start.z()), 1e-9);
    EXPECT_GT(std::abs(part.start.x()), 1.0) << "outside, where it hides no corner";
    EXPECT_LT(std::abs(part.start.x()), 1.1);
  }
  EXPECT_EQ(posts, 4);
}

TEST(Supports, RopesThatHangDownFromFourPinsHaveNoPosts) {
  Description description;
  for (const auto& [x, z] : {std::pair{-1.0, -1.0}, {-1.0, 1.0}, {1.0, -1.0}, {1.0, 1.0}}) {
    ChainSpec chain;
    chain.name = "rope" + std::to_string(description.chains.size());
    chain.from = {x, 2.0, z};
    chain.to = {x, 1.0, z};
    chain.links = 4;
    chain.pinned = {"first"};
    description.chains.push_back(chain);
  }
  const Supports made = supports_on_floor(build(description));
  EXPECT_EQ(made.beams.size(), 4U);
  for (const SupportPart& part : made.fixed) EXPECT_GE(std::min(part.start.y(), part.end.y()), 2.0);
}

TEST(Supports, ASinglePinHangsFromABracketAboveIt) {
  const Built scene = row_of_masses({{0.3, 2.0, 0.1}, {1.0, 2.0, 0.1}, {1.7, 2.0, 0.1}});
  const Supports made = supports_on_floor(scene);
  ASSERT_FALSE(made.fixed.empty());
  EXPECT_TRUE(made.carried.empty());
  bool touches = false;
  for (const SupportPart& part : made.fixed) {
    touches = touches || distance_to_axis(part, {0.3, 2.0, 0.1}) < 1e-9;
    EXPECT_GE(std::min(part.start.y(), part.end.y()), 2.0 - 1e-9);
    EXPECT_LT(std::max(part.start.y(), part.end.y()), 2.3);
  }
  EXPECT_TRUE(touches);
  ASSERT_EQ(made.beams.size(), 1U);
  EXPECT_GT(made.beams[0].centre.y(), 2.0);
  EXPECT_NEAR(made.beams[0].axes.determinant(), 1.0, 1e-9) << "or its faces would look inwards";
}

TEST(Supports, APinNearTheGroundIsAPegInIt) {
  const Built scene = row_of_masses({{0.0, 0.01, 0.0}, {1.0, 0.01, 0.0}, {2.0, 0.01, 0.0}});
  const Supports made = supports_on_floor(scene);
  ASSERT_EQ(made.fixed.size(), 1U);
  EXPECT_LT(std::min(made.fixed[0].start.y(), made.fixed[0].end.y()), 0.0);
  EXPECT_GT(std::max(made.fixed[0].start.y(), made.fixed[0].end.y()), 0.01);
}

TEST(Supports, APinThatMovesCarriesAHandle) {
  Description description;
  ChainSpec chain;
  chain.name = "rope";
  chain.from = {-0.5, 2.0, 0.0};
  chain.to = {0.5, 2.0, 0.0};
  chain.links = 6;
  chain.pinned = {"first", "last"};
  chain.last_motion.path = {Knot{0.0, {0.5, 2.0, 0.0}}, Knot{1.0, {0.2, 1.8, 0.3}}};
  description.chains = {chain};
  const Built scene = build(description);
  const Supports made = supports_on_floor(scene);
  ASSERT_FALSE(made.carried.empty());
  for (const CarriedPart& carried : made.carried) EXPECT_EQ(carried.mass, 6U);
  for (const SupportPart& part : made.fixed)
    EXPECT_LT((part.start - Vec3(-0.5, 2.0, 0.0)).norm(), 0.3) << "only the pin at rest has a bracket";
}

TEST(Supports, APinnedHandHoldsOnToABar) {
  Description description;
  RagdollSpec doll;
  doll.name = "doll";
  doll.position = {0.0, 1.0, 0.0};
  doll.pinned = {"left_hand"};
  description.ragdolls = {doll};
  const Built scene = build(description);
  const Supports made = supports_on_floor(scene);
  const auto& names = scene.model.masses.name;
  const auto hand = static_cast<std::size_t>(std::ranges::find(names, "doll.left_hand") - names.begin());
  bool held = false;
  for (const SupportPart& part : made.fixed) {
    const Vec3 span = part.end - part.start;
    const bool level = span.norm() > 0.1 && std::abs(span.y()) < 1e-9;
    held = held || (level && distance_to_axis(part, scene.start.position.at(hand)) < 1e-9);
  }
  EXPECT_TRUE(held);
}

TEST(Supports, NothingHoldsWhatIsNotPinnedOrHoldsNothing) {
  EXPECT_TRUE(supports_on_floor(row_of_masses({{0.0, 1.0, 0.0}})).fixed.empty()) << "a pin without links";
  const Built loose = only(sheet_of(4, 4, {0.0, 1.0, 0.0}, {1.0, 1.0, 0.0}, {0.0, -1.0, 0.0}, {}));
  EXPECT_TRUE(supports_on_floor(loose).fixed.empty());
}

TEST(Supports, StandWhereverUpIs) {
  const Built upright = only(sheet_of(6, 9, {0.5, 2.4, 0.0}, {2.0, 2.4, 0.0}, {0.0, -1.0, 0.0}, {"left"}));
  const Built tilted = only(sheet_of(6, 9, {0.0, 0.5, 2.4}, {0.0, 2.0, 2.4}, {0.0, 0.0, -1.0}, {"left"}));
  const std::array floor{Ground{Vec3::Zero(), Vec3::UnitZ(), false}};
  const Supports one = supports_on_floor(upright);
  const Supports other = supports(tilted.model, tilted.start.position, {Vec3::UnitZ(), floor, pin_size});
  ASSERT_EQ(one.fixed.size(), other.fixed.size());
  for (std::size_t i = 0; i < one.fixed.size(); ++i)
    EXPECT_NEAR(one.fixed[i].start.y(), other.fixed[i].start.z(), 1e-9);
}

// Of the rods that a picture of a scene shows.
std::vector<TaperedRod> drawn_rods(const Built& scene, const State& state, const Look& look) {
  const CameraPose pose{{0.0, 1.5, 6.0}, {0.0, 1.5, 0.0}, 38.0};
  return GeometryMaker(scene.model, scene.start, look).make(state, pose)->bodies.rods;
}

TEST(Supports, StandStillInAFilmWhileRingsFollowTheirHooks) {
  const Built scene = only(drawn_curtain());
  Look look = bare_look();
  look.supports = true;
  State later = scene.start;
  later.time = 2.0;
  place_pins(scene.model, 2.0, later.position, later.velocity);
  const std::vector<TaperedRod> first = drawn_rods(scene, scene.start, look),
                                last = drawn_rods(scene, later, look);
  ASSERT_EQ(first.size(), last.size());
  const std::size_t standing = supports_on_floor(scene).fixed.size();
  for (std::size_t i = 0; i < first.size(); ++i) {
    // The first hook is at the rail's end and stays.
    const bool moved = glm::length(first[i].start - last[i].start) > 1e-6F;
    EXPECT_EQ(moved, i >= standing + 1) << i;
  }
}

TEST(Supports, AreDrawnUnlessALookSaysOtherwise) {
  const Built scene = row_of_masses({{0.0, 1.0, 0.0}, {1.0, 1.0, 0.0}});
  EXPECT_FALSE(drawn_rods(scene, scene.start, Look{}).empty());
  EXPECT_TRUE(drawn_rods(scene, scene.start, bare_look()).empty());
}

TEST(Supports, AnEdgeThatIsMovedHasABarThatMovesAlong) {
  SheetSpec sheet = sheet_of(3, 5, {0.0, 1.0, 0.0}, {1.0, 1.0, 0.0}, {0.0, -0.5, 0.0}, {"top"});
  sheet.top_motion.sinusoid = SinusoidSpec{{0.0, 0.0, 0.2}, 3.0, 0.0};
  const Supports made = supports_on_floor(only(sheet));
  EXPECT_TRUE(made.fixed.empty());
  EXPECT_TRUE(made.beams.empty());
  ASSERT_EQ(made.carried.size(), 3U) << "a bar and its two ends";
  const SupportPart& bar = made.carried.front().part;
  EXPECT_GT((bar.end - bar.start).norm(), 1.0);
  EXPECT_LT(std::abs((bar.end - bar.start).normalized().x()), 1.0 + 1e-12);
  EXPECT_GT(std::abs((bar.end - bar.start).normalized().x()), 1.0 - 1e-12);
}

TEST(Supports, HiddenPinsHaveNone) {
  const Built scene = only(sheet_of(3, 5, {0.0, 1.0, 0.0}, {1.0, 1.0, 0.0}, {0.0, -0.5, 0.0}, {"top"}));
  const std::vector<bool> none(scene.model.masses.size(), false), all(scene.model.masses.size(), true);
  EXPECT_TRUE(supports(scene.model, scene.start.position, {Vec3::UnitY(), floor_at_zero, pin_size, &none})
                  .fixed.empty());
  EXPECT_FALSE(supports(scene.model, scene.start.position, {Vec3::UnitY(), floor_at_zero, pin_size, &all})
                   .fixed.empty());
}

}  // namespace
}  // namespace taut
