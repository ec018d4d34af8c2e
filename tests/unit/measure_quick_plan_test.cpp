#include <gtest/gtest.h>

#include <cmath>

#include "base/failure.h"
#include "measure/quick_plan.h"
#include "measure/rounding.h"
#include "measure/time_scales.h"
#include "methods/frequency.h"
#include "methods/registry.h"
#include "model/measures.h"
#include "scenes_of_the_program.h"

namespace taut::test {
namespace {

Scene chain_scene(const std::string& more, int links = 20) {
  return parse_scene("[[chain]]\nname = \"rope\"\nfrom = [0, 2, 0]\nto = [2, 2, 0]\nlinks = " +
                         std::to_string(links) + "\nmass = 0.21\npinned = [\"first\"]\n" + more,
                     "chain.toml");
}

TEST(TimeScales, AreThoseOfTheory) {
  const Scene scene = chain_scene("first_motion = { amplitude = [0.1, 0, 0], angular_frequency = 10 }\n");
  const TimeScales scales = time_scales(scene.model, scene.start, 5.0);
  EXPECT_NEAR(scales.fall, std::sqrt(0.1 / 9.81), 1e-12);
  // 20 free masses of 0.01 kg hang on one link; trebled for the swing.
  EXPECT_NEAR(scales.sideways, std::sqrt(0.01 * 0.1 / (3.0 * 0.2 * 9.81)), 1e-9);
  EXPECT_EQ(scales.spring, infinity);
  EXPECT_NEAR(scales.motion, 0.1 / (0.1 * 10.0), 1e-3);
  EXPECT_EQ(scales.impact, infinity);
}

TEST(TimeScales, OfSomethingThatFallsOntoTheGroundKnowTheImpact) {
  const Scene scene = parse_scene(
      "[[mass]]\nname = \"ball\"\nposition = [0, 2, 0]\nvelocity = [0, -3, 0]\nradius = 0.05\n[[plane]]\n",
      "ball.toml");
  const TimeScales scales = time_scales(scene.model, scene.start, 5.0);
  EXPECT_NEAR(scales.impact, 0.05 / (3.0 + std::sqrt(2.0 * 9.81 * 0.1)), 1e-9);
  EXPECT_EQ(scene_size(scene.model, scene.start), 0.1) << "one mass is as large as its ball";
}

TEST(SpringFrequencyBound, IsAboveTheFrequencyAndNearIt) {
  for (const char* more : {"", "diagonals = { stiffness = 300.0 }\n", "diagonals = true\n"}) {
    const Scene sheet = parse_scene(std::string("[[sheet]]\nname = \"c\"\nrows = 7\ncolumns = 9\nfrom = [0, "
                                                "1, 0]\nto = [1, 1, 0]\ndown = [0, -1, "
                                                "0]\nmass = 0.5\npinned = [\"top\"]\nstiffness = 200.0\n") +
                                        more,
                                    "sheet.toml");
    const double frequency = highest_spring_frequency(sheet.model, sheet.start),
                 bound = spring_frequency_bound(sheet.model, sheet.start);
    EXPECT_GE(bound, frequency);
    EXPECT_LE(bound, 1.7 * frequency);
  }
  const Scene chain = chain_scene("stiffness = 1000.0\n", 200);
  EXPECT_NEAR(spring_frequency_bound(chain.model, chain.start),
              highest_spring_frequency(chain.model, chain.start),
              1e-3 * highest_spring_frequency(chain.model, chain.start));
  const Scene rigid = chain_scene("");
  EXPECT_EQ(spring_frequency_bound(rigid.model, rigid.start), 0.0);
}

TEST(LongestReach, IsTheWayAlongLinksFromTheNearestPin) {
  EXPECT_NEAR(longest_reach(chain_scene("").model), 2.0, 1e-12);
  const Scene two_pins = parse_scene(
      "[[chain]]\nname = \"rope\"\nfrom = [0, 2, 0]\nto = [2, 2, 0]\nlinks = 20\nlength = 3\npinned = "
      "[\"first\", "
      "\"last\"]\n",
      "two.toml");
  EXPECT_NEAR(longest_reach(two_pins.model), 1.5, 1e-12);
  EXPECT_EQ(longest_reach(parse_scene("[[mass]]\nname = \"a\"\nposition = [0, 0, 0]\n", "one.toml").model),
            0.0);
}

// √(ε X/2g) is where a step's fall is as large as what positions can't hold (README).
TEST(RoundingError, IsThatOfTheFallInASingleStep) {
  const Scene scene = parse_scene(
      "[[chain]]\nname = \"rope\"\nfrom = [0, 100, 0]\nto = [100, 100, 0]\nlinks = 100\npinned = "
      "[\"first\"]\n",
      "long.toml");
  const auto single = [](double rate) {
    return complete_settings({"xpbd", {{"steps_per_second", rate}, {"precision", std::string("single")}}});
  };
  EXPECT_GT(rounding_error(scene.model, scene.start, single(600.0)), 0.2) << "such a chain fell 28 % short";
  EXPECT_LT(rounding_error(scene.model, scene.start, single(60.0)), 0.01);
  EXPECT_EQ(rounding_error(scene.model, scene.start, complete_settings({"xpbd", {}})), 0.0);
  const Scene small = chain_scene("");
  EXPECT_LT(rounding_error(small.model, small.start, single(600.0)), 0.01);
}

TEST(QuickPlan, IsTheSameTwiceAndSaysWhy) {
  const Scene scene = scene_called("bridge");
  const AccuracyTarget target{ErrorKind::trajectory, 0.1, false};
  const Plan plan = quick_plan(scene.model, scene.start, scene.duration, target);
  EXPECT_EQ(plan.settings.values,
            quick_plan(scene.model, scene.start, scene.duration, target).settings.values);
  EXPECT_TRUE(plan.reached);
  EXPECT_TRUE(plan.judged_to_the_end());
  EXPECT_EQ(plan.judged_share(), 1.0);
  EXPECT_FALSE(plan.searched);
  EXPECT_TRUE(plan.why.starts_with(settings_text(plan.settings))) << plan.why;
  EXPECT_GE(plan.reasons.size(), 4U);
  const std::string sentence = accuracy_sentence(plan);
  EXPECT_NE(sentence.find("of the size"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("over all of its 8 s"), std::string::npos) << sentence;
}

TEST(QuickPlan, KeepsToTheMethodThatIsAskedFor) {
  const Scene scene = chain_scene("");
  const AccuracyTarget target{ErrorKind::trajectory, 0.1, false};
  for (const char* method : {"euler", "verlet", "xpbd", "shake", "rattle", "newton"})
    EXPECT_EQ(quick_plan(scene.model, scene.start, 1.0, target, method).settings.method, method);
  EXPECT_THROW(quick_plan(scene.model, scene.start, 1.0, target, "spring-explicit"), BadRequest);
  EXPECT_THROW(quick_plan(scene.model, scene.start, 1.0, target, "warp"), BadRequest);
}

TEST(QuickPlan, AFinerTargetIsRunMoreFinely) {
  const Scene scene = scene_called("chain-20");
  double before = 0.0;
  for (const double wanted : {0.3, 0.01, 0.001}) {
    const Plan plan =
        quick_plan(scene.model, scene.start, scene.duration, {ErrorKind::trajectory, wanted, false});
    EXPECT_GT(plan.predicted_seconds, before) << plan.why;
    EXPECT_LE(plan.estimated_error.value_or(1.0), wanted);
    before = plan.predicted_seconds;
  }
}

// What can't be judged to the end is never run more coarsely than usual, and no more is promised than was
// judged.
TEST(QuickPlan, OfAMotionThatCantBeFollowedSaysHowFarItHolds) {
  const Scene scene = scene_called("ragdoll-pile");
  const Plan plan = quick_plan(scene.model, scene.start, scene.duration, {ErrorKind::trajectory, 0.1, false});
  EXPECT_FALSE(plan.judged_to_the_end());
  EXPECT_LT(plan.judged_share(), 0.5);
  EXPECT_GE(plan.settings.steps_per_second(), 600.0);
  EXPECT_NE(accuracy_sentence(plan).find("beyond that nothing is promised"), std::string::npos);
}

TEST(QuickPlan, StopsWhenToldTo) {
  const Scene scene = scene_called("bridge");
  EXPECT_THROW(quick_plan(scene.model, scene.start, scene.duration, {ErrorKind::trajectory, 0.1, false}, {},
                          [] { return true; }),
               Interrupted);
}

TEST(AccuracySentence, SaysWhereNothingCanBeJudged) {
  Plan plan;
  plan.duration = 4.0;
  EXPECT_NE(accuracy_sentence(plan).find("can't be judged"), std::string::npos);
  EXPECT_EQ(plan.judged_share(), 0.0);
  EXPECT_FALSE(plan.judged_to_the_end());
}

}  // namespace
}  // namespace taut::test
