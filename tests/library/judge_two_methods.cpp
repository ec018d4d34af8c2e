// Reads a scene, runs it by two methods at the same step, and judges both by the exact motion of a pendulum.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "measure/exact.h"
#include "model/measures.h"
#include "motion/simulate.h"
#include "scene/scene.h"

namespace {

constexpr double length = 1.0;    // m
constexpr double gravity = 9.81;  // m/s²

const std::string pendulum = R"(
[[mass]]
name = "nail"
position = [0, 0, 0]
pinned = true

[[mass]]
name = "bob"
position = [1, 0, 0]

[[link]]
a = "nail"
b = "bob"
)";

// The largest distance (m) of the bob from where it should be.
double error_of(const taut::Scene& scene, const std::string& method, const std::vector<double>& times) {
  const taut::Settings settings{method, {{"steps_per_second", 1000.0}}};
  const taut::SampledRun run = taut::sampled_run(scene.model, scene.start, settings, times);
  double error = 0.0;
  for (std::size_t i = 0; i < run.states.size(); ++i) {
    const double angle = taut::pendulum_angle_below_level(length, gravity, times[i]);  // rad
    const taut::Vec3 exact(length * std::cos(angle), -length * std::sin(angle), 0.0);
    error = std::max(error, (run.states[i].position.at(1) - exact).norm());
  }
  return run.failed() ? HUGE_VAL : error;
}

int judge() {
  const taut::Scene scene = taut::parse_scene(pendulum, "pendulum");
  std::vector<double> times;
  times.reserve(20);
  for (int i = 1; i <= 20; ++i) times.push_back(0.1 * i);  // s
  const double rattle = error_of(scene, "rattle", times), xpbd = error_of(scene, "xpbd", times);
  std::printf("after 2 s at 1000 steps/s: rattle is within %.2e m, xpbd within %.2e m\n", rattle, xpbd);
  return rattle < xpbd ? 0 : 1;
}

}  // namespace

int main() {
  try {
    return judge();
  } catch (const std::exception& problem) {  // a scene's errors, each with its line
    std::fprintf(stderr, "%s\n", problem.what());
    return 2;
  }
}
