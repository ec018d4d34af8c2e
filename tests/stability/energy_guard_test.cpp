// What a run does about energy out of nothing: nothing to a run that is stable, whatever its energy's swing,
// and an error to one that isn't.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "methods/frequency.h"
#include "model/measures.h"
#include "motion/run.h"
#include "physics/fixtures.h"

namespace taut::test {
namespace {

// 1 kg on 1000 N/m: ω = 31.6 rad/s. Stretched by 0.5 m and let go, or at its length and thrown.
Description spring(bool thrown, double gravity) {
  Description description = pendulum();
  description.gravity = {0.0, -gravity, 0.0};
  description.masses[1].position = {0.0, thrown ? -1.0 : -1.5, 0.0};
  if (thrown) description.masses[1].velocity = {0.0, 0.15 * std::sqrt(1000.0), 0.0};
  description.links[0].length = 1.0;
  description.links[0].properties.stiffness = 1000.0;
  return description;
}

// Two masses of 20 g on 3000 N/m, a tenth too far apart, in no gravity.
Description free_spring() {
  Description description = spinning_dumbbell();
  for (MassSpec& mass : description.masses) {
    mass.mass = 0.02;
    mass.velocity = Vec3::Zero();
    mass.position *= 1.1;
  }
  description.links[0].length = 1.0;
  description.links[0].properties.stiffness = 3000.0;
  return description;
}

Description spring_chain() {
  Description description = level_chain(10, 0.1);
  description.chains[0].properties.stiffness = 1e4;
  return description;
}

std::vector<Description> springs() {
  return {spring(false, 9.81), spring(true, 9.81), spring(false, 0.0),
          spring(true, 0.0),   free_spring(),      spring_chain()};
}

std::vector<std::string> spring_methods() {
  return methods_that([](const Capabilities& can) { return can.stiffness; });
}

class SpringMethods : public ::testing::TestWithParam<std::string> {};

// ω·h up to nearly 2: the run with the guard is the run without, bit for bit.
TEST_P(SpringMethods, StableSpringsAreLeftAlone) {
  int scene = 0;
  for (const Description& description : springs()) {
    ++scene;
    const Built built = build_valid(description);
    const double frequency = highest_spring_frequency(built.model, built.start);
    for (const double frequency_times_step : {0.3, 0.5, 0.79, 1.05, 1.5, 1.8, 1.95}) {
      // A chain's highest frequency goes up and down as it moves: near the limit it is not stable for sure.
      if (scene == 6 && frequency_times_step > 1.6) continue;
      const Settings how = settings(GetParam(), frequency / frequency_times_step);
      State guarded = built.start, free = built.start;
      const RunReport report = simulate(built.model, guarded, how, 2000);
      simulate(built.model, free, how, 2000, unguarded);
      EXPECT_EQ(report.end, RunEnd::none) << scene << ", ω·h = " << frequency_times_step;
      EXPECT_EQ(state_hash(guarded), state_hash(free)) << scene << ", ω·h = " << frequency_times_step;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, SpringMethods, ::testing::ValuesIn(spring_methods()), case_name);

// At ω·h = 1.05 Störmer–Verlet keeps E between 1 − (ωh/2)² and 1 of what a stretched spring began with.
TEST(EnergyGuard, AStretchedSpringKeepsItsSwing) {
  const Built built = build_valid(free_spring());
  for (const char* method : {"rattle", "shake"}) {
    const double frequency = highest_spring_frequency(built.model, built.start);
    taut::Run run(built.model, built.start, settings(method, frequency / 1.05));
    const double at_start = energy(built.model, built.start).total();
    double least = infinity, most = 0.0;
    while (run.steps() < 10'000 && run.step()) {
      const double now = energy(built.model, run.state()).total() / at_start;
      least = std::min(least, now);
      most = std::max(most, now);
    }
    EXPECT_EQ(run.failure(), "");
    EXPECT_NEAR(least, 1.0 - 0.25 * 1.05 * 1.05, 5e-3) << method;
    EXPECT_LE(most, 1.0 + 1e-9) << method;
    EXPECT_GT(most, 0.9999) << method;
  }
}

TEST(EnergyGuard, AnUnstableSpringEndsInTheError) {
  for (const Description& description : springs()) {
    const Built built = build_valid(description);
    const double frequency = highest_spring_frequency(built.model, built.start);
    for (const double frequency_times_step : {2.05, 2.5, 4.0}) {
      taut::Run run(built.model, built.start, settings("spring-explicit", frequency / frequency_times_step));
      while (run.steps() < 2000 && run.step()) {
      }
      EXPECT_EQ(run.report().end, RunEnd::diverged) << frequency_times_step;
      EXPECT_NE(run.failure().find("diverges"), std::string::npos) << run.failure();
    }
  }
}

// Light links far beyond √(m l/T): what the guard lets pass stays within a tenth of the scene's energies.
TEST(EnergyGuard, RigidLinksNeverGainMoreThanATenth) {
  Description description = level_chain(20, 0.1);
  description.chains[0].last_mass = 1000.0;
  const Built built = build_valid(description);
  for (const char* method : {"rattle", "shake", "newton"})
    for (const double rate : {120.0, 600.0}) {
      taut::Run run(built.model, built.start, settings(method, rate));
      while (run.state().time < 1.0 && run.step()) {
      }
      EXPECT_LE(run.measures(run.state()).energy_error, 0.1 + 1e-9) << method << " at " << rate;
    }
}

// A pin that swings a mass about without gravity gives all the energy there is.
TEST(EnergyGuard, ADrivenPinWithoutGravityIsNoReasonToStop) {
  Description description = pendulum();
  description.gravity = Vec3::Zero();
  description.masses[0].motion.sinusoid = SinusoidSpec{{0.0, 0.3, 0.0}, 6.0, 0.0};
  const Built built = build_valid(description);
  for (const std::string& method : rigid_methods()) {
    taut::Run run(built.model, built.start, settings(method, 600.0));
    while (run.steps() < 6000 && run.step()) {
    }
    EXPECT_EQ(run.failure(), "") << method;
    EXPECT_EQ(run.report().halved_steps, 0) << method;
  }
}

// Two springs at a right angle that straighten vibrate faster than at the start, and once one of them has
// broken: the run goes on or ends with a report, but is not refused when it is half done.
TEST(EnergyGuard, NothingIsRefusedInTheMiddleOfARun) {
  Description description;
  description.gravity = {0.0, -9.81, 0.0};
  for (int i = 0; i < 4; ++i) {
    MassSpec mass;
    mass.name = "m" + std::to_string(i);
    mass.position = i < 2 ? Vec3(0.1 * i, 0.0, 0.0) : Vec3(0.1, -0.1 * (i - 1), 0.0);
    mass.mass = i == 3 ? 5.0 : 0.01;
    mass.pinned = i == 0;
    description.masses.push_back(mass);
  }
  for (int i = 0; i < 3; ++i) {
    LinkSpec link{"m" + std::to_string(i), "m" + std::to_string(i + 1), 0.1, {}};
    link.properties.stiffness = 1e4;
    if (i == 2) link.properties.break_tension = 60.0;
    description.links.push_back(link);
  }
  const Built built = build_valid(description);
  const double frequency = highest_spring_frequency(built.model, built.start);
  for (const char* method : {"rattle", "shake"}) {
    taut::Run run(built.model, built.start, settings(method, frequency / 1.98));
    EXPECT_NO_THROW({
      while (run.steps() < 2000 && run.step()) {
      }
    }) << method;
    EXPECT_GT(broken_links(run.state()) + (run.ended() ? 1 : 0), 0U) << method;
  }
}

}  // namespace
}  // namespace taut::test
