// Faces that touch: nothing passes through anything at any speed, thickness, friction, momentum, bits, and
// what is refused.

#include <fmt/format.h>

#include "face_scenes.h"
#include "model/face_pairs.h"
#include "other_process.h"

namespace taut::test {
namespace {

class FaceMethods : public ::testing::TestWithParam<std::string> {};

void set_speed(Built& built, const Sheet& sheet, const Vec3& velocity) {
  for (Index i = 0; i < sheet.rows * sheet.columns; ++i)
    if (!built.model.masses.pinned(sheet.first_mass + i))
      built.start.velocity.set(sheet.first_mass + i, velocity);
}

// A small sheet, turned at random, is shot at one whose rim is held.
Built shot_at_a_held_sheet(const std::string& method, unsigned seed, double speed) {
  std::mt19937 random(seed);
  Description description;
  SheetSpec target = sheet_around("target", Vec3::Zero(), Eigen::Matrix3d::Identity(), 1.0, 6, 0.02);
  target.pinned = {"top", "bottom", "left", "right"};
  std::uniform_real_distribution<double> aside(-0.15, 0.15);
  const Vec3 middle(aside(random), 0.3, aside(random));
  description.sheets = {target, sheet_around("shot", middle, random_frame(random), 0.2, 2, 0.02)};
  Built built = built_for(method, description);
  set_speed(built, built.model.sheets[1], {0.0, -speed, 0.0});
  return built;
}

// Says whether faces are through each other at the end of a step or, where it is long, on the way there.
std::size_t tangles_on_the_way(const Model& model, const State& before, const State& after, int looks) {
  std::size_t most = 0;
  for (int look = 1; look <= looks; ++look) {
    State between = after;
    const double share = static_cast<double>(look) / looks;
    for (std::size_t i = 0; i < after.position.size(); ++i)
      between.position.set(i, (1.0 - share) * before.position.at(i) + share * after.position.at(i));
    most = std::max(most, exact_tangles(model, between));
  }
  return most;
}

// Corners on faces and edges on edges, from a tenth of a thickness a step to many sheets' widths.
TEST_P(FaceMethods, NothingPassesAtAnySpeed) {
  for (const double speed : {1.0, 10.0, 100.0, 1000.0})
    for (const double rate : {60.0, 600.0})
      for (unsigned seed = 0; seed < 8; ++seed) {
        const Built built = shot_at_a_held_sheet(GetParam(), seed, speed);
        const Model& model = built.model;
        taut::Run moving(model, built.start, settings(GetParam(), rate, 2));
        const double until = std::min(0.5, 3.0 / speed + 3.0 / rate);
        while (moving.state().time < until) {
          const State before = moving.state();
          ASSERT_TRUE(moving.step()) << moving.failure();
          const std::string label =
              fmt::format("{} m/s at {}/s, seed {}, {} s", speed, rate, seed, moving.state().time);
          ASSERT_EQ(tangles_on_the_way(model, before, moving.state(), speed / rate > 0.1 ? 8 : 1), 0U)
              << label;
          ASSERT_EQ(tangled_places(model, moving.state()), 0U) << label;
          // Beyond that speed the target is torn out of shape, though not apart.
          const Index first = speed <= 10.0 ? model.sheets[1].first_mass : no_link;
          for (Index i = first; i < model.masses.size(); ++i)
            ASSERT_TRUE(is_above(moving.state().position.at(i), model, moving.state(), model.sheets[0]))
                << label;
        }
      }
}

TEST_P(FaceMethods, MomentumIsKeptWhenSheetsMeet) {
  for (const double speed : {0.5, 5.0, 50.0}) {
    std::mt19937 random(7);
    Description description;
    description.gravity = Vec3::Zero();
    description.sheets = {sheet_around("one", Vec3::Zero(), Eigen::Matrix3d::Identity(), 0.5, 5, 0.02),
                          sheet_around("other", {0.05, 0.25, 0.0}, random_frame(random), 0.3, 4, 0.02)};
    Built built = built_for(GetParam(), description);
    set_speed(built, built.model.sheets[1], {0.0, -speed, 0.1 * speed});
    const Vec3 before = linear_momentum(built.model, built.start);
    const State end = run(built, settings(GetParam(), 600.0, 2), 0.6);
    const Vec3 after = linear_momentum(built.model, end);
    EXPECT_LT((after - before).norm(), 1e-12 * static_cast<double>(built.model.masses.size()) * before.norm())
        << speed;
    // It has hit: the other one did not take all of its momentum along.
    Vec3 of_other = Vec3::Zero();
    for (Index i = built.model.sheets[1].first_mass; i < built.model.masses.size(); ++i)
      of_other += built.model.masses.mass[i] * end.velocity.at(i);
    EXPECT_GT(of_other.y(), 0.9 * before.y()) << speed;
  }
}

// One small sheet lies on a large one that is held all around and tilted.
Description sheet_on_a_slope(double degrees, double friction) {
  const Eigen::Matrix3d frame =
      Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, Vec3::UnitZ()).toRotationMatrix();
  Description description;
  SheetSpec slope = sheet_around("slope", Vec3::Zero(), frame, 3.0, 1, 0.02);
  slope.pinned = {"top", "bottom"};
  SheetSpec lying = sheet_around("lying", 0.02 * frame.col(1) + 0.5 * frame.col(0), frame, 0.5, 5, 0.02);
  slope.faces->friction = lying.faces->friction = friction;
  description.sheets = {slope, lying};
  return description;
}

TEST_P(FaceMethods, FrictionHoldsASheetOnASheetUpToItsAngle) {
  for (const double friction : {0.2, 0.5}) {
    const double angle = std::atan(friction) * 180.0 / std::numbers::pi;
    const Built held = built_for(GetParam(), sheet_on_a_slope(angle - 3.0, friction));
    EXPECT_LT((centre_of_mass(held.model, run(held, settings(GetParam(), 600.0, 2), 2.0)) -
               centre_of_mass(held.model, held.start))
                  .norm(),
              2e-3)
        << friction;
    const Built sliding = built_for(GetParam(), sheet_on_a_slope(angle + 10.0, friction));
    const double radians = (angle + 10.0) * std::numbers::pi / 180.0, time = 0.5;
    const double way = 0.5 * 9.81 * (std::sin(radians) - friction * std::cos(radians)) * time * time;
    EXPECT_NEAR((centre_of_mass(sliding.model, run(sliding, settings(GetParam(), 600.0, 2), time)) -
                 centre_of_mass(sliding.model, sliding.start))
                    .norm(),
                way, 0.05 * way)
        << friction;
  }
}

// Two sheets fall crosswise onto a held one, and lie there.
TEST_P(FaceMethods, ThicknessIsHeld) {
  Description description;
  SheetSpec table = sheet_around("table", Vec3::Zero(), Eigen::Matrix3d::Identity(), 2.0, 1, 0.02);
  table.pinned = {"top", "bottom"};
  const Eigen::Matrix3d crosswise = Eigen::AngleAxisd(0.6, Vec3::UnitY()).toRotationMatrix();
  description.sheets = {table,
                        sheet_around("one", {0.0, 0.1, 0.0}, Eigen::Matrix3d::Identity(), 0.5, 6, 0.02),
                        sheet_around("other", {0.1, 0.2, 0.05}, crosswise, 0.5, 6, 0.02)};
  description.drag = 1.0;
  const Built built = built_for(GetParam(), description);
  taut::Run moving(built.model, built.start, settings(GetParam(), 600.0, 2));
  double deepest = 0.0;
  while (moving.steps() < 1200) {
    ASSERT_TRUE(moving.step()) << moving.failure();
    deepest = std::max(deepest, deepest_face(built.model, moving.state()));
  }
  EXPECT_EQ(exact_tangles(built.model, moving.state()), 0U);
  EXPECT_LT(deepest, 0.3 * 0.02);
  EXPECT_LT(deepest_face(built.model, moving.state()), 0.02 * 0.02);
  EXPECT_LT(fastest_speed(moving.state()), 0.05);
}

// A cloth that falls crumpled onto a box and the ground, and tears.
Description crumpled_cloth() {
  Description description;
  const Eigen::Matrix3d frame =
      (Eigen::AngleAxisd(1.2, Vec3::UnitX()) * Eigen::AngleAxisd(0.3, Vec3::UnitZ())).toRotationMatrix();
  description.sheets = {sheet_around("cloth", {0.05, 1.0, 0.0}, frame, 0.8, 16, 0.015)};
  description.sheets[0].properties.break_tension = 0.5;
  description.sheets[0].diagonals = description.sheets[0].properties;
  BoxSpec box;
  box.centre = {0.0, 0.25, 0.0};
  box.size = {0.3, 0.5, 0.2};
  box.turn = {0.0, 20.0, 0.0};
  description.boxes = {box};
  description.planes = {PlaneSpec{}};
  return description;
}

std::string hash_after(const Built& built, const std::string& method, int steps, int threads) {
  taut::Run moving(built.model, built.start, settings(method, 600.0, 2), {},
                   {std::make_shared<Workers>(threads)});
  while (moving.steps() < steps && moving.step()) {
  }
  return fmt::format("{:016x} {} steps, {} broken {}", state_hash(moving.state()), moving.steps(),
                     broken_links(moving.state()), moving.failure());
}

TEST_P(FaceMethods, TheSameBitsOnAnyNumberOfThreads) {
  const Built built = built_for(GetParam(), crumpled_cloth());
  const std::string alone = hash_after(built, GetParam(), 500, 1);
  for (const int threads : {2, 3, 4})
    EXPECT_EQ(hash_after(built, GetParam(), 500, threads), alone) << threads;
}

// Another process knows nothing of what near faces this one has found, or when.
TEST_P(FaceMethods, GoOnFromACheckpointWithTheSameBits) {
  const Built built = built_for(GetParam(), crumpled_cloth());
  const Settings how = settings(GetParam(), 600.0, 2);
  taut::Run moving(built.model, built.start, how);
  std::vector<std::string> saved;
  while (moving.steps() < 500 && moving.step())
    if (moving.steps() % 50 == 13) saved.push_back(to_bytes(moving.save()));
  EXPECT_EQ(moving.failure(), "");
  for (const std::string& bytes : saved)
    EXPECT_EQ(in_other_process([&] {
                taut::Run resumed(built.model, built.start, how, run_state_from(bytes, built.model));
                while (resumed.steps() < 500 && resumed.step()) {
                }
                return fmt::format("{:016x}", state_hash(resumed.state()));
              }),
              fmt::format("{:016x}", state_hash(moving.state())));
}

// On its way, nothing is through anything, and what is torn no longer counts.
TEST_P(FaceMethods, ACrumpledClothIsNeverTangled) {
  const Built built = built_for(GetParam(), crumpled_cloth());
  taut::Run moving(built.model, built.start, settings(GetParam(), 600.0, 2));
  while (moving.steps() < 500) {
    ASSERT_TRUE(moving.step()) << moving.failure();
    if (moving.steps() % 5 != 0) continue;
    ASSERT_EQ(exact_tangles(built.model, moving.state()), 0U) << moving.steps();
    for (const Collider& solid : built.model.colliders)
      ASSERT_EQ(exact_solid_passes(solid, built.model, moving.state()), 0U) << moving.steps();
  }
  if (find_method(GetParam())->can.stiffness) {
    EXPECT_GT(broken_links(moving.state()), 0U);
  }
}

// Pins that press a sheet through itself: an error that says so, not a tangle.
TEST_P(FaceMethods, PinsThatPressFacesThroughEachOtherAreAnError) {
  Description description;
  description.sheets = {sheet_around("still", Vec3::Zero(), Eigen::Matrix3d::Identity(), 1.0, 2, 0.02),
                        sheet_around("driven", {0.0, 0.3, 0.0}, Eigen::Matrix3d::Identity(), 0.5, 4, 0.02)};
  description.sheets[0].pinned = {"top", "bottom", "left", "right"};
  Built built = built_for(GetParam(), description);
  // The middle of the still one too, and all of the other one is driven down through it.
  const Sheet& driven = built.model.sheets[1];
  built.model.masses.inverse_mass[4] = 0.0;
  for (Index i = driven.first_mass; i < built.model.masses.size(); ++i) {
    built.model.masses.inverse_mass[i] = i % 2 == 0 ? 0.0 : built.model.masses.inverse_mass[i];
    if (i % 2 != 0) continue;
    const Vec3 at = built.start.position.at(i);
    built.model.driven_pins.push_back({i, make_path({{0.0, at}, {1.0, at - Vec3(0.0, 1.0, 0.0)}})});
  }
  taut::Run moving(built.model, built.start, settings(GetParam(), 600.0, 2));
  while (moving.steps() < 600 && moving.step()) {
  }
  EXPECT_NE(moving.failure().find("pins or solids press its faces through each other"), std::string::npos)
      << moving.failure();
  EXPECT_EQ(exact_tangles(built.model, moving.state()), 0U);
}

// Every method does it, or refuses it before the run and names those that do.
TEST(Faces, AreKnownOrRefusedByEveryMethod) {
  Description description;
  description.sheets = {sheet_around("cloth", Vec3::Zero(), Eigen::Matrix3d::Identity(), 1.0, 4, 0.02)};
  for (const Method& method : all_methods()) {
    const Built built = built_for(std::string(method.name), description);
    const std::vector<std::string> problems = capability_problems(built.model, method);
    if (method.can.faces) {
      EXPECT_TRUE(problems.empty()) << method.name;
      continue;
    }
    ASSERT_FALSE(problems.empty()) << method.name;
    EXPECT_NE(problems.back().find("has no faces that touch; these have: verlet, xpbd"), std::string::npos)
        << problems.back();
  }
}

// So many pairs that threads share them: two sheets that lie on each other, one of them pushed down and
// aside.
TEST(Faces, ManyHaveTheSameBitsOnAnyNumberOfThreads) {
  Description description;
  SheetSpec lower = sheet_around("lower", {0.0, 0.0016, 0.0}, Eigen::Matrix3d::Identity(), 0.3, 30, 0.003);
  SheetSpec upper = lower;
  upper.name = "upper";
  upper.from += Vec3(0.003, 0.0031, 0.004);
  upper.to += Vec3(0.003, 0.0031, 0.004);
  description.sheets = {lower, upper};
  description.planes = {PlaneSpec{}};
  Built built = build_valid(description);
  for (Index i = 0; i < built.model.sheets[1].mass_count; ++i)
    built.start.velocity.set(built.model.sheets[1].first_mass + i, {0.3, -0.5, 0.01 * (i % 7)});
  const FaceMesh mesh(built.model);
  std::vector<Vec3> places;
  mesh.places(built.start.position, 0.0, places);
  std::vector<FacePair> pairs;
  find_face_pairs(mesh, whole_faces(mesh, built.model, built.start.broken_at), places,
                  std::vector<double>(mesh.size(), 0.001), 1'000'000, pairs);
  ASSERT_GT(pairs.size(), 8000U);
  const std::string alone = hash_after(built, "xpbd", 60, 1);
  for (const int threads : {2, 3, 5}) EXPECT_EQ(hash_after(built, "xpbd", 60, threads), alone) << threads;
}

TEST(Faces, AreRefusedInSinglePrecision) {
  Description description;
  description.sheets = {sheet_around("cloth", Vec3::Zero(), Eigen::Matrix3d::Identity(), 1.0, 4, 0.02)};
  const Built built = build_valid(description);
  Settings how = settings("xpbd", 600.0, 2);
  how.values["precision"] = std::string("single");
  const std::vector<std::string> problems = refusals(built.model, built.start, complete_settings(how));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems[0].find("no faces"), std::string::npos) << problems[0];
}

INSTANTIATE_TEST_SUITE_P(All, FaceMethods, ::testing::ValuesIn(face_methods()),
                         [](const auto& name) { return name.param; });

}  // namespace
}  // namespace taut::test
