// The method of high order: its error by its tolerance against answers that are known or of another kind, and
// the moments of what happens.

#include <fmt/format.h>

#include <cstdlib>
#include <functional>
#include <numbers>

#include "base/failure.h"
#include "fixtures.h"
#include "measure/reference.h"
#include "model/measures.h"
#include "model/parts.h"
#include "scenes_of_the_program.h"
#include "stopped_pendulum.h"

namespace taut::test {
namespace {

Settings within(double tolerance) {
  return complete_settings({"dop853", {{"tolerance", tolerance}}});
}

// A scene, and how long it runs (s).
struct Subject {
  std::string name;
  std::function<Description()> description;
  double duration;
};

Description unequal_chain() {
  Description description = level_chain(6, 0.2);
  description.chains[0].last_mass = 8.0;
  MassSpec bob;
  bob.name = "bob";
  bob.position = {1.2, -0.3, 0.1};
  bob.mass = 0.3;
  description.masses = {bob};
  description.links = {LinkSpec{"rope.6", "bob", {}, {}}};
  return description;
}

Description spinning_ring() {
  Description description;
  description.gravity = Vec3::Zero();
  constexpr int count = 6;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count, radius = i % 2 == 0 ? 1.0 : 0.8;
    MassSpec mass;
    mass.name = fmt::format("m{}", i);
    mass.position = radius * Vec3(std::cos(angle), std::sin(angle), 0.0);
    mass.velocity = 3.0 * Vec3(-std::sin(angle), std::cos(angle), 0.1 * (i % 3));
    mass.mass = 1.0 + 0.3 * i;
    description.masses.push_back(mass);
    description.links.push_back(LinkSpec{fmt::format("m{}", i), fmt::format("m{}", (i + 1) % count), {}, {}});
  }
  return description;
}

Description driven_chain() {
  Description description = level_chain(5, 0.2);
  description.chains[0].first_motion.sinusoid = SinusoidSpec{{0.0, 0.05, 0.02}, 8.0, 0.0};
  return description;
}

Description heavy_tip() {
  Description description = level_chain(8, 0.1);
  description.chains[0].last_mass = 1000.0;
  return description;
}

Description rigid_net() {
  Description description;
  SheetSpec net = cloth(10, 10);
  net.down = {0.0, -0.5, 0.5};
  net.pinned = {"top-left"};
  net.to = {1.1, 0.0, 0.0};
  description.sheets = {net};
  return description;
}

std::vector<Subject> subjects() {
  return {{"unequal_chain", unequal_chain, 1.0},
          {"spinning_ring", spinning_ring, 1.0},
          {"mixed_chain", mixed_chain, 1.0},
          {"driven_pin", driven_chain, 1.0},
          {"heavy_tip", heavy_tip, 0.5},
          {"rigid_net", rigid_net, 0.3},
          {"angle_with_a_stop", stopped_pendulum, 1.0}};
}

class ErrorByTolerance : public ::testing::TestWithParam<Subject> {};

// Ten decades of tolerance, against the motion at the tightest: the error stays below ten times the tolerance
// × duration/1 s. That the limit is the true motion, rattle witnesses, which solves other equations.
TEST_P(ErrorByTolerance, FallsWithTheToleranceOverTenDecades) {
  const Subject& subject = GetParam();
  const Built built = build_valid(subject.description());
  const double end = subject.duration;
  const std::vector<double> times{0.5 * end, end};
  const std::vector<State> limit = accurately(built.model, built.start, times, 1e-14);
  ASSERT_EQ(limit.size(), 2U);
  const Reference reference = make_reference(built.model, built.start, times, 1e-7, 20.0);
  ASSERT_TRUE(reference.certified()) << reference.refusal;
  EXPECT_EQ(reference.certified_until, end);
  EXPECT_LT(position_error(reference.states.back(), limit.back()), 1e-7) << reference.how;
  std::string all;
  double coarsest = 0.0, finest = 0.0;
  for (int decade = 3; decade <= 13; ++decade) {
    const double tolerance = std::pow(10.0, -decade);
    const SampledRun run = sampled_run(built.model, built.start, within(tolerance), times);
    ASSERT_EQ(run.failure, "");
    const double error =
        std::max(position_error(run.states[0], limit[0]), position_error(run.states[1], limit[1]));
    all += fmt::format(" {:.0e}: {:.1e}", tolerance, error);
    EXPECT_LE(error, 10.0 * tolerance * std::max(1.0, end) + 2e-12) << all;
    if (has_rigid_links(built.model)) {
      double strain = 0.0;
      for (std::size_t link = 0; link < built.model.links.size(); ++link)
        if (built.model.links.rigid(link))
          strain = std::max(strain, std::abs(link_distance(built.model, run.states[1].position, link) /
                                                 built.model.links.length[link] -
                                             1.0));
      EXPECT_LE(strain, 1e-12) << tolerance;
    }
    (decade == 3 ? coarsest : finest) = error;
  }
  EXPECT_LT(finest, 1e-8 * coarsest + 2e-12) << all;
  if (std::getenv("TAUT_ERROR_TABLE") != nullptr) fmt::print("{}:{}\n", subject.name, all);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ErrorByTolerance, ::testing::ValuesIn(subjects()),
                         [](const auto& each) { return each.param.name; });

// IFToMM A01 over 1000 periods of 2.3678 s.
TEST(Dop853, KeepsThePendulumsEnergyOverAThousandPeriods) {
  const Built built = build_valid(pendulum());
  taut::Run run(built.model, built.start, within(1e-13));
  const std::optional<State> end = run.at(1000.0 * 2.3678419475762);
  ASSERT_TRUE(end) << run.failure();
  EXPECT_LT(std::abs(energy(built.model, *end).total()), 1e-9) << run.steps() << " steps";
  EXPECT_LT(std::abs(link_strain(built.model, *end).largest), 1e-12);
}

// 3 m g sin φ reaches 2 m g at sin φ = 2/3.
TEST(Dop853, BreaksAPendulumAtItsMoment) {
  Description description = pendulum();
  description.links[0].properties.break_tension = 2.0 * 9.81;
  const Built built = build_valid(description);
  double low = 0.0, high = 0.59;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (3.0 * std::sin(pendulum_angle_below_level(1.0, 9.81, middle)) < 2.0 ? low : high) = middle;
  }
  const State end = run(built, within(1e-12), 0.8);
  EXPECT_NEAR(end.broken_at[0], low, 1e-12);
  const State before = run(built, within(1e-12), low - 1e-6);
  EXPECT_EQ(broken_links(before), 0U);
  EXPECT_NEAR(before.tension[0], 2.0 * 9.81, 1e-3);
}

// The elbow meets its stop on the way, and leaves it, with both links taking part in the impact.
TEST(Dop853, IsExactBeyondAPlasticStop) {
  const Built built = build_valid(stopped_pendulum());
  StoppedPendulum reference(2e-5);
  std::vector<double> times;
  std::vector<Vec3> hands;
  for (int i = 1; i <= 15; ++i) {
    times.push_back(0.1 * i);
    hands.push_back(reference.hand_at(0.1 * i));
  }
  ASSERT_EQ(reference.events(), 2) << "an impact and a release";
  const std::vector<State> states = accurately(built.model, built.start, times, 1e-12);
  ASSERT_EQ(states.size(), times.size());
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_LT((states[i].position.at(2) - hands[i]).norm(), 1e-9) << times[i];
}

// What is asked for between two steps, and how often, is nothing to the run.
TEST(Dop853, FramesChangeNothingAndFitTheMotion) {
  const Built built = build_valid(level_chain(8, 0.1));
  std::vector<double> times;
  for (int frame = 1; frame <= 80; ++frame) times.push_back(0.01 * frame);
  const std::vector<State> exact = accurately(built.model, built.start, times, 1e-13);
  taut::Run plain(built.model, built.start, within(1e-9)), looked_at(built.model, built.start, within(1e-9));
  plain.at(times.back());
  ASSERT_EQ(exact.size(), times.size());
  double largest = 0.0;
  for (std::size_t frame = 0; frame < times.size(); ++frame) {
    const std::optional<State> state = looked_at.at(times[frame]);
    ASSERT_TRUE(state);
    EXPECT_LT(link_strain(built.model, *state).largest, 1e-12);
    largest = std::max(largest, position_error(*state, exact[frame]));
  }
  EXPECT_LT(largest, 1.5e-9) << "three times that where the interpolant lacks its last term";
  EXPECT_EQ(state_hash(plain.state()), state_hash(looked_at.state()));
}

TEST(Dop853, RefusesWhatItCannotDoByName) {
  const auto refusal = [](const Description& description) {
    const Built built = build_valid(description);
    const auto problems = refusals(built.model, built.start, complete_settings({"dop853", {}}));
    return problems.empty() ? std::string() : problems.front();
  };
  EXPECT_EQ(refusal(pendulum()), "");
  Description taut = level_chain(4, 0.25);
  taut.chains[0].pinned = {"first", "last"};
  EXPECT_NE(refusal(taut).find("says nothing that other rigid links do not say already"), std::string::npos)
      << refusal(taut);
  Description braced;
  braced.sheets = {cloth(3, 3)};
  braced.sheets[0].diagonals.emplace();
  EXPECT_NE(refusal(braced).find("says nothing that other rigid links do not say already"),
            std::string::npos);
  Description ground = pendulum();
  ground.planes = {PlaneSpec{{0.0, -0.5, 0.0}, Vec3::UnitY(), 0.5}};
  EXPECT_NE(refusal(ground).find("has no ground plane"), std::string::npos) << refusal(ground);
}

// Two stops that push each other open end at rest, and the run goes on.
TEST(Dop853, StopsThatChatterComeToRest) {
  const Scene scene = scene_called("ragdoll-hang");
  taut::Run run(scene.model, scene.start, within(1e-5));
  const std::optional<State> state = run.at(1.0);
  ASSERT_TRUE(state) << run.failure();
  EXPECT_LT(largest_limit_excess(scene.model, *state), 1e-9);
}

}  // namespace
}  // namespace taut::test
