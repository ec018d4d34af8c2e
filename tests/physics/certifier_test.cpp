// What --certify says of a run, beside what is true of it.

#include "frames/certifier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "fixtures.h"
#include "measure/reference.h"
#include "model/measures.h"
#include "motion/simulate.h"
#include "scenes_of_the_program.h"

namespace taut::test {
namespace {

std::vector<double> sixtieths_until(double end) {
  std::vector<double> times;
  for (int i = 1; i / 60.0 <= end + 1e-9; ++i) times.push_back(std::min(i / 60.0, end));
  return times;
}

double true_error(const Scene& scene, const std::function<State(std::size_t, double)>& truth) {
  const std::vector<double> times = sixtieths_until(scene.duration);
  const SampledRun run = sampled_run(scene.model, scene.start, scene.settings, times);
  double largest = 0.0;
  for (std::size_t i = 0; i < times.size(); ++i)
    largest = std::max(largest, position_error(run.states.at(i), truth(i, times[i])));
  return largest;
}

void expect_within_a_factor_of_two(const Scene& scene, double error) {
  const Certificate certificate = certify(scene);
  SCOPED_TRACE(certificate_text(certificate));
  EXPECT_GE(certificate.largest, 0.5 * error);
  EXPECT_LE(certificate.largest, 2.0 * error);
  EXPECT_FALSE(certificate.chaotic_from);
  EXPECT_NEAR(certificate.until, scene.duration, 1e-9);
}

Scene run_by(Scene scene, const Settings& given) {
  scene.settings = complete_settings(given);
  return scene;
}

// A pendulum, against Jacobi's elliptic functions.
TEST(Certifier, IsWithinAFactorOfTwoOfAPendulumsTrueError) {
  for (const Settings& given :
       {settings("xpbd", 600.0), settings("verlet", 2400.0), settings("newton", 600.0),
        settings("shake", 240.0), settings("rattle", 120.0)}) {
    SCOPED_TRACE(given.method);
    Scene scene = run_by(scene_called("pendulum"), given);
    scene.duration = 2.0;
    const double error = true_error(scene, [&](std::size_t, double time) {
      State state = scene.start;
      state.position.set(1, scene.start.position.at(0) + exact_bob(time));
      return state;
    });
    expect_within_a_factor_of_two(scene, error);
  }
}

// Chains, against motions certified by two means.
TEST(Certifier, IsWithinAFactorOfTwoOfAChainsTrueError) {
  for (const auto& [name, given] :
       {std::pair("chain-20", settings("xpbd", 1200.0)), std::pair("chain-20", settings("rattle", 240.0)),
        std::pair("level-chain", settings("newton", 2400.0)), std::pair("bola", settings("xpbd", 960.0))}) {
    SCOPED_TRACE(name);
    Scene scene = run_by(scene_called(name), given);
    scene.duration = 1.0;
    const Reference reference = make_reference(scene.model, scene.start, sixtieths_until(scene.duration),
                                               1e-6 * scene_size(scene.model, scene.start));
    ASSERT_TRUE(reference.certified()) << reference.refusal;
    scene.duration = reference.certified_until;
    expect_within_a_factor_of_two(
        scene, true_error(scene, [&](std::size_t i, double) { return reference.states.at(i); }));
  }
}

// A ball that bounces, against parabolas.
TEST(Certifier, IsWithinAFactorOfTwoOfABouncingBallsTrueError) {
  constexpr double radius = 0.1, height = 1.5, restitution = 0.6, gravity = 9.81;
  for (const double rate : {240.0, 960.0}) {
    SCOPED_TRACE(rate);
    Scene scene = parse_scene(
        "[world]\nduration = 1.2\n[[mass]]\nname = \"ball\"\nposition = [0, 1.5, 0]\nmass = 1.0\nradius = "
        "0.1\n"
        "[[plane]]\nrestitution = 0.6\n",
        "ball.toml");
    scene.settings = settings("xpbd", rate);
    const double error = true_error(scene, [&](std::size_t, double time) {
      const double landing = std::sqrt(2.0 * (height - radius) / gravity);
      double y = height - 0.5 * gravity * time * time;
      double begin = landing, speed = restitution * gravity * landing;
      for (; time >= begin; begin += 2.0 * speed / gravity, speed *= restitution) {
        const double since = time - begin;
        y = radius + speed * since - 0.5 * gravity * since * since;
        if (since <= 2.0 * speed / gravity) break;
      }
      State state = scene.start;
      state.position.set(0, Vec3(0.0, y, 0.0));
      return state;
    });
    expect_within_a_factor_of_two(scene, error);
  }
}

TEST(Certifier, SaysFromWhenAMotionIsChaotic) {
  Scene double_pendulum = parse_scene(
      "[world]\nduration = 12\n[[chain]]\nname = \"arm\"\nfrom = [0, 0, 0]\nto = [0.1, 2, 0]\nlinks = "
      "2\npinned = "
      "[\"first\"]\n",
      "double.toml");
  double_pendulum.settings = settings("rattle", 2400.0);
  for (const Scene& scene : {double_pendulum, scene_called("hanging-chain")}) {
    SCOPED_TRACE(scene.name);
    const Certificate certificate = certify(scene);
    ASSERT_TRUE(certificate.chaotic_from) << certificate_text(certificate);
    EXPECT_GT(*certificate.chaotic_from, 1.0);
    EXPECT_LT(*certificate.chaotic_from, scene.duration);
    EXPECT_NE(certificate_text(certificate).find("chaotic from t = "), std::string::npos);
  }
}

// What a certificate is asked for never changes the run.
TEST(Certifier, LeavesTheRunAsItIs) {
  const Scene scene = scene_called("chain-20");
  Simulation watched(scene), alone(scene);
  Certifier certifier(scene);
  certifier.see_until(watched, scene.duration);
  certifier.finish();
  EXPECT_EQ(state_hash(*watched.at(scene.duration)), state_hash(*alone.at(scene.duration)));
}

TEST(Certifier, EndsWhenToldTo) {
  const Scene scene = scene_called("chain-20");
  Certifier certifier(scene, [] { return true; });
  EXPECT_THROW(certifier.finish(), Interrupted);
}

}  // namespace
}  // namespace taut::test
