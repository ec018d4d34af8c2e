// The same bits whatever vector instructions the kernels use, on any number of threads, and whichever of the
// steppers makes the step.

#include "methods/simd.h"

#include <gtest/gtest.h>

#include <bit>
#include <memory>
#include <string>

#include "base/failure.h"
#include "fixtures.h"
#include "methods/registry.h"
#include "motion/run.h"
#include "scenes_of_the_program.h"
#include "study/speed.h"

namespace taut::test {
namespace {

struct BestSimdAgain {
  ~BestSimdAgain() { force_simd(""); }
};

std::uint64_t hash_of(const Model& model, const State& start, const Settings& settings, std::int64_t steps,
                      const Execution& execution = {}) {
  taut::Run run(model, start, settings, {}, execution);
  while (run.steps() < steps && run.step()) {
  }
  EXPECT_FALSE(run.ended()) << run.failure();
  const State& state = run.state();
  // Tensions are no part of the hash.
  std::uint64_t sum = state_hash(state);
  for (const double tension : state.tension) sum = sum * 31 + std::bit_cast<std::uint64_t>(tension);
  return sum;
}

std::vector<Settings> relaxations(const Scene& scene) {
  std::vector<Settings> all;
  for (const char* method : {"xpbd", "verlet", "shake"})
    for (const double passes : {1.0, 3.0}) {
      Settings settings{method, {{"passes", passes}}};
      all.push_back(complete_settings(settings));
      if (method != std::string("xpbd")) continue;
      settings.values["relax"] = "lines";
      all.push_back(complete_settings(settings));
      settings.values["relax"] = "links";
      settings.values["precision"] = "single";
      all.push_back(complete_settings(settings));
    }
  std::erase_if(
      all, [&](const Settings& settings) { return !refusals(scene.model, scene.start, settings).empty(); });
  return all;
}

std::vector<Settings> direct_solves(const Scene& scene) {
  std::vector<Settings> all;
  for (const char* method : {"rattle", "newton"})
    if (const Settings settings = complete_settings({method, {}});
        refusals(scene.model, scene.start, settings).empty())
      all.push_back(settings);
  return all;
}

class Simd : public ::testing::TestWithParam<std::string> {};

TEST_P(Simd, EveryTargetGivesTheSameBits) {
  const BestSimdAgain again;
  const Scene scene = scene_called(GetParam());
  const std::vector<std::string> targets = simd_targets();
  if (targets.size() < 2) GTEST_SKIP() << "there is but one";
  std::vector<Settings> all = relaxations(scene);
  for (const Settings& settings : direct_solves(scene)) all.push_back(settings);
  for (const Settings& settings : all) {
    force_simd("");
    const std::uint64_t best = hash_of(scene.model, scene.start, settings, 5);
    for (const std::string& target : targets) {
      force_simd(target);
      ASSERT_EQ(simd_targets(), std::vector{target});
      EXPECT_EQ(hash_of(scene.model, scene.start, settings, 5), best) << target << ' ' << settings.method;
    }
  }
}

// Long enough for blocks of links, and of no even number of vectors.
TEST(LongChains, GiveTheSameBitsOnEveryTarget) {
  const BestSimdAgain again;
  const Built built = build_valid(level_chain(707, 0.1));
  for (const char* method : {"rattle", "newton"}) {
    const Settings how = settings(method, 600.0);
    force_simd("");
    const std::uint64_t best = hash_of(built.model, built.start, how, 5);
    for (const std::string& target : simd_targets()) {
      force_simd(target);
      EXPECT_EQ(hash_of(built.model, built.start, how, 5), best) << target << ' ' << method;
    }
  }
}

TEST_P(Simd, AnyNumberOfThreadsGivesTheSameBits) {
  const Scene scene = scene_called(GetParam());
  for (const Settings& settings : relaxations(scene)) {
    const std::uint64_t alone = hash_of(scene.model, scene.start, settings, 20);
    for (const int threads : {2, 3, 8})
      EXPECT_EQ(hash_of(scene.model, scene.start, settings, 20, {std::make_shared<Workers>(threads)}), alone)
          << threads << ' ' << settings.method;
  }
}

// A load of no force changes nothing but that the step in the order of the file has to make it.
TEST_P(Simd, PackedStepsAreThoseInTheOrderOfTheFile) {
  const Scene scene = scene_called(GetParam());
  Model loaded = scene.model;
  loaded.loads.push_back({{0}, Vec3::Zero(), 0.0, 0.0});
  for (const Settings& settings : relaxations(scene)) {
    if (settings.values.contains("precision") && settings.choice("precision") == "single") continue;
    EXPECT_EQ(hash_of(loaded, scene.start, settings, 20), hash_of(scene.model, scene.start, settings, 20))
        << settings.method;
  }
}

// Wind makes rattle take its kicks one by one, and has nothing to blow on where there are no triangles.
TEST_P(Simd, KicksInOnePassAreThoseOneByOne) {
  const Scene scene = scene_called(GetParam());
  if (!scene.model.triangles.empty()) GTEST_SKIP() << "there is cloth";
  const Settings settings = complete_settings({"rattle", {}});
  if (!refusals(scene.model, scene.start, settings).empty()) GTEST_SKIP() << "rattle can't do it";
  Model windy = scene.model;
  windy.wind = Wind{};
  EXPECT_EQ(hash_of(windy, scene.start, settings, 20), hash_of(scene.model, scene.start, settings, 20));
}

INSTANTIATE_TEST_SUITE_P(Scenes, Simd,
                         ::testing::Values("curtain", "chain-20", "heavy-tip", "bridge", "breaking-cloth",
                                           "pendulum"),
                         case_name);

// Of several blocks, whose masses move on while links of the block before are relaxed.
TEST(PackedStep, OfALargeSheetIsThatInTheOrderOfTheFileOnAnyThreadsAndTarget) {
  const BestSimdAgain again;
  const Built built = build(square_sheet(72));
  Model loaded = built.model;
  loaded.loads.push_back({{0}, Vec3::Zero(), 0.0, 0.0});
  for (const char* method : {"xpbd", "verlet", "shake"})
    for (const double passes : {1.0, 2.0}) {
      const Settings settings =
          complete_settings({method, {{"passes", passes}, {"steps_per_second", 2400.0}}});
      const std::uint64_t expected = hash_of(loaded, built.start, settings, 20);
      for (const int threads : {1, 2, 3})
        EXPECT_EQ(hash_of(built.model, built.start, settings, 20, {std::make_shared<Workers>(threads)}),
                  expected)
            << method << ' ' << threads;
      for (const std::string& target : simd_targets()) {
        force_simd(target);
        EXPECT_EQ(hash_of(built.model, built.start, settings, 20), expected) << method << ' ' << target;
        force_simd("");
      }
    }
}

// Positions, velocities and tensions, though none of them was asked for before the step that failed.
TEST(PackedStep, ThatFailsLeavesTheStateBeforeIt) {
  const Scene scene = scene_called("chain-20");
  for (const char* name : {"xpbd", "verlet"}) {
    const Settings settings = complete_settings({name, {}});
    const Method& method = *find_method(name);
    const auto failing = method.make(scene.model, settings, {}),
               twin = method.make(scene.model, settings, {});
    const double h = 1e-3, far_too_long = 1e300;
    for (Stepper* stepper : {failing.get(), twin.get()}) {
      stepper->load(scene.start);
      for (int step = 1; step <= 3; ++step) EXPECT_EQ(stepper->step(h, step * h).status, StepStatus::done);
    }
    EXPECT_EQ(failing->step(far_too_long, far_too_long).status, StepStatus::not_finite) << name;
    const State &left = failing->store(), &expected = twin->store();
    EXPECT_EQ(state_hash(left), state_hash(expected)) << name;
    EXPECT_EQ(left.tension, expected.tension) << name;
  }
}

// Steps of several lengths, some that fail, and a load now and then. What is not asked for need not be worked
// out: multipliers are kept of few steps, and those of the last one are to be there whenever they are wanted.
void expect_tensions_of_the_last_step(const Model& model, const State& start, const Settings& settings) {
  const Method& method = *find_method(settings.method);
  const auto seldom = method.make(model, settings, {}), always = method.make(model, settings, {});
  for (Stepper* stepper : {seldom.get(), always.get()}) stepper->load(start);
  double time = start.time;
  for (int i = 0; i < 60; ++i) {
    const double h = i % 13 == 9 ? 1e-4 : 2e-4;
    time += h;
    for (Stepper* stepper : {seldom.get(), always.get()})
      ASSERT_EQ(stepper->step(h, time).status, StepStatus::done) << i;
    const State expected = always->store();
    if (i % 17 == 5) {
      EXPECT_NE(seldom->step(1e300, 1e300).status, StepStatus::done);
    }
    if (i % 5 == 1) {
      ASSERT_EQ(state_hash(seldom->motion()), state_hash(expected)) << i;
    }
    const bool looked_at = i < 30 ? i % 4 == 2 : i % 7 == 3 || i % 7 == 4 || i % 17 == 5;
    if (!looked_at) continue;
    ASSERT_EQ(seldom->store().tension, expected.tension) << i;
    ASSERT_EQ(state_hash(seldom->store()), state_hash(expected)) << i;
    if (i % 19 == 7) seldom->load(State(seldom->store()));
  }
}

TEST_P(Simd, TensionsAreThoseOfTheLastStepWheneverTheyAreAskedFor) {
  const Scene scene = scene_called(GetParam());
  Model loaded = scene.model;
  loaded.loads.push_back({{0}, Vec3::Zero(), 0.0, 0.0});
  for (const Settings& settings : relaxations(scene)) {
    SCOPED_TRACE(settings.method);
    expect_tensions_of_the_last_step(scene.model, scene.start, settings);
    expect_tensions_of_the_last_step(loaded, scene.start, settings);
  }
}

// What a run does with a method whose steps can be taken back: steps of other lengths, back, loaded again,
// and one that can't be made. Looked at now and then, for what isn't may not be worked out.
class PackedShake : public ::testing::TestWithParam<bool> {};

TEST_P(PackedShake, GoesBackAndOnAsInTheOrderOfTheFile) {
  const bool sheet = GetParam();
  Built built;
  if (sheet) built = build(square_sheet(19));
  const Scene chain = scene_called("chain-20");
  const Model& model = sheet ? built.model : chain.model;
  const State& begun = sheet ? built.start : chain.start;
  Model loaded = model;
  loaded.loads.push_back({{0}, Vec3::Zero(), 0.0, 0.0});
  const Settings settings = complete_settings({"shake", {}});
  const auto packed = find_method("shake")->make(model, settings, {}),
             in_order = find_method("shake")->make(loaded, settings, {});
  packed->load(begun);
  in_order->load(begun);
  double time = begun.time;
  const double whole = 1.0 / 2400.0;
  for (int i = 0; i < 60; ++i) {
    const double h = i % 13 == 9 ? 0.5 * whole : whole;
    ASSERT_EQ(packed->step(h, time + h).status, StepStatus::done);
    ASSERT_EQ(in_order->step(h, time + h).status, StepStatus::done);
    if (i % 11 == 2 || i % 13 == 9) {
      packed->undo();
      in_order->undo();
    } else {
      time += h;
    }
    if (i % 17 == 5) {
      EXPECT_NE(packed->step(1e300, 1e300).status, StepStatus::done);
    }
    if (i % 19 == 7) packed->load(State(packed->store()));
    if (i % 5 == 1) {
      ASSERT_EQ(state_hash(packed->motion()), state_hash(in_order->store())) << i;
    }
    if (i % 3 != 0) continue;
    const State &left = packed->store(), &expected = in_order->store();
    ASSERT_EQ(state_hash(left), state_hash(expected)) << i;
    ASSERT_EQ(left.tension, expected.tension) << i;
    ASSERT_EQ(left.tension_before, expected.tension_before) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, PackedShake, ::testing::Bool(),
                         [](const auto& scene) { return scene.param ? "sheet" : "chain_20"; });

TEST(SimdByName, AnUnknownOneIsRefusedWithTheKnownOnes) {
  const BestSimdAgain again;
  try {
    force_simd("avx9");
    FAIL();
  } catch (const BadRequest& problem) {
    EXPECT_NE(std::string(problem.what()).find(simd_targets().front()), std::string::npos) << problem.what();
  }
}

}  // namespace
}  // namespace taut::test
