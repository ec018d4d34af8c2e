#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "measure/exact.h"
#include "methods/registry.h"
#include "model/description.h"
#include "motion/run.h"
#include "motion/simulate.h"

namespace taut::test {

/// Builds a description that must have no problems.
inline Built build_valid(const Description& description) {
  Built built = build(description);
  for (const Problem& problem : built.problems)
    ADD_FAILURE() << problem.section << " " << problem.index << " " << problem.key << ": " << problem.message;
  return built;
}

/// Settings of a method; passes are left out where it has none. For a method that chooses its steps, a
/// tolerance whose error falls by its order where the rate is doubled: 1e-6 m at 120 steps/s.
inline Settings settings(std::string method, double steps_per_second, double passes = 0.0) {
  if (find_method(method)->can.chooses_steps)
    return {std::move(method),
            {{"tolerance", std::clamp(1e-6 * std::pow(steps_per_second / 120.0, -8.0), 1e-13, 1e-2)}}};
  Settings settings{std::move(method), {{"steps_per_second", steps_per_second}}};
  if (passes > 0.0 && find_param(*find_method(settings.method), "passes")) settings.values["passes"] = passes;
  return settings;
}

/// Simulates for a duration that is a whole number of steps, if the method has a fixed one; every step must
/// be solved.
inline State run(const Built& built, const Settings& settings, double duration) {
  taut::Run run(built.model, built.start, settings);
  if (run.settings().chooses_steps()) {
    const std::optional<State> state = run.at(duration);
    EXPECT_EQ(run.failure(), "");
    return state.value_or(run.state());
  }
  const auto steps = std::llround(duration * run.settings().steps_per_second());
  while (run.steps() < steps && run.step()) {
  }
  EXPECT_EQ(run.failure(), "");
  return run.state();
}

/// The motion at rising times by dop853 within a tolerance (m).
inline std::vector<State> accurately(const Model& model, const State& start, const std::vector<double>& times,
                                     double tolerance) {
  const SampledRun run =
      sampled_run(model, start, complete_settings({"dop853", {{"tolerance", tolerance}}}), times);
  EXPECT_EQ(run.failure, "");
  return run.states;
}

/// The slope of log(error) over log(step size) by least squares: the observed order of convergence.
inline double observed_order(const std::vector<double>& steps, const std::vector<double>& errors) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  const auto n = static_cast<double>(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double x = std::log(steps[i]), y = std::log(errors[i]);
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// IFToMM A01: 1 kg on a rigid link of 1 m, released level at rest from x = +1 (here x = −1 turns clockwise
/// too).
inline Description pendulum() {
  Description description;
  MassSpec hook;
  hook.name = "hook";
  hook.pinned = true;
  MassSpec bob;
  bob.name = "bob";
  bob.position = {1.0, 0.0, 0.0};
  description.masses = {hook, bob};
  description.links = {LinkSpec{"hook", "bob", 1.0, {}}};
  return description;
}

/// Where its bob is after a time (s), to rounding.
inline Vec3 exact_bob(double time) {
  const double angle = pendulum_angle_below_level(1.0, 9.81, time);
  return {std::cos(angle), -std::sin(angle), 0.0};
}

/// A straight level chain, first mass pinned, released at rest.
inline Description level_chain(int links, double link_length) {
  Description description;
  ChainSpec chain;
  chain.name = "rope";
  chain.to = {links * link_length, 0.0, 0.0};
  chain.links = links;
  chain.mass = links + 1.0;  // 1 kg each
  chain.pinned = {"first"};
  description.chains = {chain};
  return description;
}

/// A chain, a damped spring at its end with a mass on it, and drag.
inline Description mixed_chain() {
  Description description = level_chain(4, 0.25);
  description.drag = 0.5;
  MassSpec bob;
  bob.name = "bob";
  bob.position = {1.0, -0.5, 0.0};
  description.masses = {bob};
  LinkProperties soft;
  soft.stiffness = 300.0;
  soft.damping = 1.0;
  description.links = {LinkSpec{"rope.4", "bob", 0.5, soft}};
  return description;
}

/// Two free masses, 1 kg and 3 kg, on a link of 1 m, spinning and drifting without gravity.
inline Description spinning_dumbbell() {
  Description description;
  description.gravity = Vec3::Zero();
  MassSpec light, heavy;
  light.name = "light";
  light.position = {0.75, 0.0, 0.0};
  light.velocity = {0.1, 0.75 * 6.0, 0.2};
  light.mass = 1.0;
  heavy.name = "heavy";
  heavy.position = {-0.25, 0.0, 0.0};
  heavy.velocity = {0.1, -0.25 * 6.0, 0.2};
  heavy.mass = 3.0;
  description.masses = {light, heavy};
  description.links = {LinkSpec{"light", "heavy", 1.0, {}}};
  return description;
}

/// A hanging cloth of 1.2 m by 0.8 m.
inline SheetSpec cloth(int rows, int columns) {
  SheetSpec spec;
  spec.name = "cloth";
  spec.rows = rows;
  spec.columns = columns;
  spec.to = {1.2, 0.0, 0.0};
  spec.down = {0.0, -0.8, 0.0};
  return spec;
}

/// The names of all methods that fulfil a condition on their capabilities.
template <typename Can>
std::vector<std::string> methods_that(Can can) {
  std::vector<std::string> names;
  for (const Method& method : all_methods())
    if (can(method.can)) names.emplace_back(method.name);
  return names;
}

inline std::vector<std::string> every_method() {
  return methods_that([](const Capabilities&) { return true; });
}

inline std::vector<std::string> rigid_methods() {
  return methods_that([](const Capabilities& can) { return can.rigid; });
}

inline std::vector<std::string> limit_methods() {
  return methods_that([](const Capabilities& can) { return can.limits; });
}

/// A name that GoogleTest accepts for a parameterised case.
inline std::string case_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  for (char& letter : name)
    if (letter == '-') letter = '_';
  return name;
}

}  // namespace taut::test
