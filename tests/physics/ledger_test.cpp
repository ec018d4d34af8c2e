#include <array>
#include <numbers>

#include "bat.h"
#include "face_scenes.h"
#include "fixtures.h"
#include "model/measures.h"
#include "motion/run.h"
#include "motion/work_ledger.h"

namespace taut::test {
namespace {

// Total energy gained over a run, and what the ledger says it should be.
std::pair<double, double> gain_and_ledger(const Built& built, const Settings& given, int steps) {
  taut::Run run(built.model, built.start, given);
  while (run.steps() < steps && run.step()) {
  }
  EXPECT_EQ(run.failure(), "");
  return {energy(built.model, run.state()).total() - energy(built.model, built.start).total(),
          run.work().expected_gain()};
}

TEST(WorkLedger, DrivenPinPaysForTheEnergyItPutsIn) {
  Description description = level_chain(5, 0.2);
  description.chains[0].first_motion.sinusoid = SinusoidSpec{{0.0, 0.1, 0.0}, 12.0, 0.0};
  const auto [gain, expected] = gain_and_ledger(build_valid(description), settings("rattle", 8000.0), 8000);
  EXPECT_GT(std::abs(gain), 1.0);
  EXPECT_NEAR(gain, expected, 2e-3 * std::abs(gain));
}

TEST(WorkLedger, LoadPaysForTheEnergyItPutsIn) {
  Description description = pendulum();
  description.loads = {LoadSpec{{"bob"}, {30.0, 5.0, 0.0}, 0.0, 1.0}};
  const auto [gain, expected] = gain_and_ledger(build_valid(description), settings("rattle", 4000.0), 4000);
  EXPECT_GT(gain, 1.0);
  EXPECT_NEAR(gain, expected, 1e-4 * gain);
}

TEST(WorkLedger, BrokenSpringTakesItsEnergyAlong) {
  Description description = pendulum();
  description.gravity = Vec3::Zero();
  description.masses[1].velocity = {3.0, 0.0, 0.0};
  description.links[0].properties.stiffness = 100.0;
  description.links[0].properties.break_tension = 20.0;  // stretched by 0.2 m: 2 J
  const auto [gain, expected] = gain_and_ledger(build_valid(description), settings("rattle", 20000.0), 20000);
  EXPECT_NEAR(expected, -2.0, 0.01);
  EXPECT_NEAR(gain, expected, 1e-4);
}

// Of long steps, too.
TEST(WorkLedger, LongStepsOfHighOrderAreAddedUpAsWell) {
  Description description = level_chain(5, 0.2);
  description.chains[0].first_motion.sinusoid = SinusoidSpec{{0.0, 0.1, 0.0}, 12.0, 0.0};
  description.loads = {LoadSpec{{"rope.5"}, {8.0, 3.0, 0.0}, 0.1, 0.6}};
  const Built built = build_valid(description);
  taut::Run run(built.model, built.start, settings("dop853", 240.0));
  ASSERT_TRUE(run.at(1.0)) << run.failure();
  const double gain = energy(built.model, run.state()).total() - energy(built.model, built.start).total();
  EXPECT_LT(run.steps(), 300);
  EXPECT_GT(std::abs(run.work().pins), 1.0);
  EXPECT_GT(std::abs(run.work().loads), 1.0);
  EXPECT_NEAR(gain, run.work().expected_gain(), 1e-6 * run.work().throughput);
}

// Solids that move, and pins that push with what is around them.

constexpr std::array<const char*, 2> pushers{"xpbd", "verlet"};

WaySpec rise(const Vec3& from, double height) {
  WaySpec way;
  way.path = {{0.2, from}, {1.2, from + Vec3(0.0, height, 0.0)}};
  return way;
}

MassSpec ball_of(double mass, const Vec3& place) {
  MassSpec ball;
  ball.name = "ball";
  ball.mass = mass;
  ball.position = place;
  ball.radius = 0.1;
  return ball;
}

// What pushes is all that changes the energy.
void expect_work(const Built& built, const std::string& method, double rate, int steps, double expected) {
  taut::Run run(built.model, built.start, settings(method, rate, 2.0));
  while (run.steps() < steps && run.step()) {
  }
  EXPECT_EQ(run.failure(), "");
  const double gain =
      energy(built.model, run.reported(run.state())).total() - energy(built.model, built.start).total();
  EXPECT_NEAR(run.work().contacts, expected, 0.01 * expected) << method;
  EXPECT_NEAR(gain, expected, 0.01 * expected) << method;
  EXPECT_NEAR(run.measures(run.state()).energy_error, 0.0, 0.01) << method;
}

TEST(WorkLedger, APlaneThatRisesPaysForTheBallThatItLifts) {
  Description description;
  PlaneSpec plane;
  plane.moves.motion = rise(Vec3::Zero(), 0.5);
  description.planes = {plane};
  description.masses = {ball_of(2.0, {0.0, 0.1, 0.0})};
  for (const std::string method : pushers)
    expect_work(build_valid(description), method, 1000.0, 1600, 2.0 * 9.81 * 0.5);
}

TEST(WorkLedger, ABatPaysForWhatItThrowsOff) {
  Description description = flying_bat();
  description.masses = {ball_of(2.0, {0.5, 0.0, 0.0})};
  const Built built = build_valid(description);
  for (const std::string method : pushers) {
    taut::Run run(built.model, built.start, settings(method, 2000.0));
    ASSERT_TRUE(run.at(2.5)) << run.failure();
    // An impulse of m (1 + e) w at w; of that the ball has (1 + e)/2, and the blow takes the rest.
    EXPECT_NEAR(run.work().contacts, 2.0 * 1.6, 0.02 * 3.2) << method;
  }
}

// A cloth with faces on a box, which meets its corners and its edges.
TEST(WorkLedger, ABoxPaysForTheClothThatItLifts) {
  for (const std::string method : pushers) {
    Description description;
    SheetSpec cloth = sheet_around("cloth", {0.03, 0.01, 0.04}, Eigen::Matrix3d::Identity(), 0.6, 4, 0.02);
    cloth.collides = false;
    if (!find_method(method)->can.stiffness) {
      cloth.properties = {};
      cloth.diagonals.reset();
    }
    description.sheets = {cloth};
    BoxSpec box;
    box.size = {0.5, 0.2, 0.5};
    box.centre = {0.0, -0.1, 0.0};
    box.moves.motion = rise(box.centre, 0.5);
    description.boxes = {box};
    description.drag = 4.0;
    const Built built = build_valid(description);
    taut::Run run(built.model, built.start, settings(method, 1000.0, 4.0));
    while (run.steps() < 3000 && run.step()) {
    }
    EXPECT_EQ(run.failure(), "");
    const double gain =
        energy(built.model, run.state()).potential - energy(built.model, built.start).potential;
    // Drag takes m b v · way: 4/s · 0.5 m/s · 0.072 kg · 0.5 m at most.
    EXPECT_GT(run.work().contacts, gain) << method;
    EXPECT_LT(run.work().contacts, 1.15 * gain + 0.072 * 4.0 * 0.75 * 0.5) << method;
  }
}

// A sheet of pins under another one with faces.
TEST(WorkLedger, PinsPayForTheClothThatTheirFacesLift) {
  Description description;
  SheetSpec tray = sheet_around("tray", Vec3::Zero(), Eigen::Matrix3d::Identity(), 1.0, 1, 0.02);
  tray.pinned = {"top", "bottom"};
  tray.top_motion.path = rise(tray.from, 0.5).path;
  tray.bottom_motion.path = rise(tray.from + tray.down, 0.5).path;
  description.sheets = {tray,
                        sheet_around("cloth", {0.03, 0.02, 0.04}, Eigen::Matrix3d::Identity(), 0.4, 3, 0.02)};
  for (const std::string method : pushers)
    expect_work(built_for(method, description), method, 1000.0, 1600, 0.2 * 0.4 * 0.4 * 9.81 * 0.5);
}

TEST(WorkLedger, APinPaysForTheBallThatItPushes) {
  Description description;
  description.gravity = Vec3::Zero();
  MassSpec fist = ball_of(1.0, Vec3::Zero());
  fist.name = "fist";
  fist.pinned = true;
  fist.motion.sinusoid = SinusoidSpec{{0.5, 0.0, 0.0}, 3.0, -0.5 * std::numbers::pi};  // from rest
  MassSpec ball = ball_of(2.0, {0.2, 0.0, 0.0});
  fist.collides = ball.collides = true;
  description.masses = {fist, ball};
  Built built = build_valid(description);
  built.start.position.set(1, built.start.position.at(0) + Vec3(0.2, 0.0, 0.0));
  for (const std::string method : pushers) {
    taut::Run run(built.model, built.start, settings(method, 2000.0));
    while (run.steps() < 4000 && run.step()) {
    }
    const double gain = energy(built.model, run.reported(run.state())).kinetic;
    EXPECT_GT(gain, 1.0) << method;
    EXPECT_NEAR(run.work().contacts, gain, 0.01 * gain) << method;
  }
}

}  // namespace
}  // namespace taut::test
