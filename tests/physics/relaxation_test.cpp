// verlet, xpbd and euler against exact solutions.

#include <array>
#include <numbers>

#include "fixtures.h"
#include "measure/exact.h"
#include "model/measures.h"

namespace taut::test {
namespace {

TEST(Exact, PendulumMatchesThePublishedValues) {
  EXPECT_NEAR(pendulum_period(1.0, 9.81), 2.3678419475762, 1e-12);
  EXPECT_NEAR(exact_bob(1.0).x(), -0.9862917511319, 1e-12);
  EXPECT_NEAR(exact_bob(1.0).y(), -0.1650108531255, 1e-12);
  EXPECT_NEAR(exact_bob(10.0).x(), 0.2750874625761, 1e-12);
  EXPECT_NEAR(exact_bob(10.0).y(), -0.9614192050991, 1e-12);
}

// Two links: a mass in the middle of a chain of two 1 m links between pins 1 m apart hangs √(1 − 1/4) m down.
TEST(Exact, HangingChainOfTwoLinksIsATriangle) {
  const HangingChain chain = hanging_chain_at_rest(Vec3::Zero(), {1.0, 0.0, 0.0}, 2, 1.0, 0.0, 9.81);
  EXPECT_NEAR(chain.positions[1].x(), 0.5, 1e-12);
  EXPECT_NEAR(chain.positions[1].y(), -std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(chain.tensions[0], 0.5 * 9.81 / std::sqrt(0.75), 1e-11);
}

class RelaxationOrder : public ::testing::TestWithParam<std::string> {};

TEST_P(RelaxationOrder, PendulumConvergesAtFirstOrder) {
  const Built built = build_valid(pendulum());
  std::vector<double> steps, errors;
  for (const double rate : {2400.0, 4800.0, 9600.0, 19200.0}) {
    const State end = run(built, settings(GetParam(), rate), 1.0);
    steps.push_back(1.0 / rate);
    errors.push_back((end.position.at(1) - exact_bob(1.0)).norm());
  }
  EXPECT_NEAR(observed_order(steps, errors), 1.0, 0.15)
      << "errors " << errors.front() << " … " << errors.back();
  EXPECT_LT(errors.back(), 5e-3);
}

INSTANTIATE_TEST_SUITE_P(Methods, RelaxationOrder, ::testing::Values("verlet", "xpbd"), case_name);

// Refining steps and passes together brings nothing: as the text leaves them, velocities go on growing.
TEST(Euler, DoesNotConverge) {
  const Built built = build_valid(level_chain(20, 0.05));
  Settings reference_settings = settings("xpbd", 60000.0);
  const State reference = run(built, reference_settings, 0.5);
  std::vector<double> errors;
  for (const double refinement : {1.0, 4.0, 16.0}) {
    const State end = run(built, settings("euler", 240.0 * refinement, 8.0 * refinement), 0.5);
    errors.push_back(position_error(end, reference));
  }
  EXPECT_GT(errors[2], 0.1);
  EXPECT_GT(errors[2], 0.8 * errors[1]) << "a first-order method would have quartered it";
}

// With v = Δx/h the same corrections do come to the pendulum's motion.
TEST(Euler, DerivedVelocitiesConverge) {
  const Built built = build_valid(pendulum());
  std::vector<double> steps, errors;
  for (const double rate : {2400.0, 4800.0, 9600.0, 19200.0}) {
    Settings how = settings("euler", rate);
    how.values["velocities"] = std::string("derived");
    const State end = run(built, how, 1.0);
    steps.push_back(1.0 / rate);
    errors.push_back((end.position.at(1) - exact_bob(1.0)).norm());
  }
  EXPECT_NEAR(observed_order(steps, errors), 1.0, 0.15);
}

TEST(Euler, KeptVelocitiesOfAHangingMassGrow) {
  Description description = pendulum();
  description.masses[1].position = {0.0, -1.0, 0.0};
  const State end = run(build_valid(description), settings("euler", 60.0), 2.0);
  EXPECT_NEAR(end.position.y[1], -1.0, 1e-12);
  EXPECT_NEAR(end.velocity.y[1], -9.81 * 2.0, 1e-9);
}

// Both masses move by the same half whatever they weigh, so their centre is not kept.
TEST(Euler, MovesTheCentreOfUnequalMasses) {
  Description description = spinning_dumbbell();
  description.masses[0].velocity = description.masses[1].velocity = Vec3::Zero();
  description.links[0].length = 0.5;
  const Built built = build_valid(description);
  const State end = run(built, settings("euler", 60.0, 1.0), 1.0 / 60.0);
  EXPECT_NEAR(centre_of_mass(built.model, built.start).x(), 0.0, 1e-15);
  EXPECT_NEAR(centre_of_mass(built.model, end).x(), (0.5 * 1.0 + 0.0 * 3.0) / 4.0, 1e-12);
}

// At rest link i of a vertical elastic chain is stretched by α × the weight below it.
TEST(Xpbd, ElasticChainStretchesByTheWeightBelow) {
  Description description = level_chain(10, 0.1);
  description.chains[0].to = {0.0, -1.0, 0.0};
  description.chains[0].properties.stiffness = 2000.0;
  description.drag = 8.0;
  const Built built = build_valid(description);
  const State end = run(built, settings("xpbd", 600.0, 60.0), 6.0);
  for (std::size_t link = 0; link < 10; ++link) {
    const double weight_below = 9.81 * static_cast<double>(10 - link);
    const double stretch = link_distance(built.model, end.position, link) - 0.1;
    EXPECT_NEAR(stretch, weight_below / 2000.0, 1e-6 * weight_below / 2000.0 + 1e-9) << "link " << link;
    EXPECT_NEAR(end.tension[link], weight_below, 1e-5 * weight_below) << "link " << link;
  }
}

// XPBD §6.1: rest 1 m, released at 1.5 m, α = 1e-3 m/N, 1 kg, no gravity: x = 1 + 0.5 cos(√1000 t).
TEST(Xpbd, OscillatorConvergesToItsExactMotion) {
  Description description = pendulum();
  description.gravity = Vec3::Zero();
  description.masses[1].position = {1.5, 0.0, 0.0};
  description.links[0].properties.stiffness = 1000.0;
  const Built built = build_valid(description);
  std::vector<double> steps, errors;
  for (const double rate : {4e4, 8e4, 16e4, 32e4}) {
    const State end = run(built, settings("xpbd", rate), 0.5);
    steps.push_back(1.0 / rate);
    errors.push_back(std::abs(end.position.x[1] - (1.0 + 0.5 * std::cos(std::sqrt(1000.0) * 0.5))));
  }
  EXPECT_NEAR(observed_order(steps, errors), 1.0, 0.1);
}

// A damped oscillator's amplitude falls as e^{−ct/2m}: 0.5·e^{−1} after t = 2m/c.
TEST(Xpbd, DampingFollowsItsCoefficient) {
  Description description = pendulum();
  description.gravity = Vec3::Zero();
  description.masses[1].position = {1.1, 0.0, 0.0};
  description.links[0].properties.stiffness = 100.0;
  description.links[0].properties.damping = 4.0;
  const Built built = build_valid(description);
  const State end = run(built, settings("xpbd", 1e5), 0.5);
  const double omega = std::sqrt(100.0 - 4.0);
  const double exact = 0.1 * std::exp(-1.0) * (std::cos(omega * 0.5) + 2.0 / omega * std::sin(omega * 0.5));
  EXPECT_NEAR(end.position.x[1] - 1.0, exact, 3e-4);
}

// Coloured order keeps a sheet with diagonals finite with one undamped pass per small step.
TEST(Xpbd, SheetStaysFiniteInColouredOrder) {
  Description description;
  SheetSpec sheet;
  sheet.name = "cloth";
  sheet.rows = sheet.columns = 32;
  sheet.to = {1.0, 0.0, 0.0};
  sheet.down = {0.0, 0.0, 1.0};
  sheet.pinned = {"top-left", "top-right"};
  sheet.diagonals = LinkProperties{};
  description.sheets = {sheet};
  const Built built = build_valid(description);
  const State end = run(built, settings("xpbd", 2400.0), 1.0);
  EXPECT_LT(link_strain(built.model, end).largest, 0.05);
}

}  // namespace
}  // namespace taut::test
