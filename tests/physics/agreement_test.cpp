#include "measure/agreement.h"

#include "fixtures.h"
#include "measure/exact.h"
#include "measure/planner.h"
#include "measure/quick_plan.h"
#include "model/measures.h"

namespace taut::test {
namespace {

constexpr double most_seconds = 0.02;  // of one run, predicted
constexpr double bound = 1e-2;         // of the scene's size

const std::vector<double> quarters{0.25, 0.5, 0.75, 1.0};

TEST(AgreedMotion, OfAPendulumIsAsTrueAsItSays) {
  const Built built = build_valid(pendulum());
  const auto truth = agreed_motion(built.model, built.start,
                                   opinions_of(built.model, built.start, quarters, most_seconds), bound);
  ASSERT_TRUE(truth);
  EXPECT_FALSE(truth->certified);
  ASSERT_EQ(truth->times, quarters);
  ASSERT_TRUE(truth->smallest[ErrorKind::trajectory]);
  EXPECT_LT(*truth->smallest[ErrorKind::trajectory], 1e-2);
  for (const State& state : truth->states)
    EXPECT_LT((state.position.at(1) - exact_bob(state.time)).norm(), *truth->smallest[ErrorKind::trajectory])
        << state.time;
}

// The link bears less than the largest pull, 3 m g: the motion ends before it breaks.
TEST(AgreedMotion, EndsBeforeALinkBreaks) {
  Description description = pendulum();
  description.links[0].properties.break_tension = 2.0 * 9.81;  // where 3 sin θ = 2, at 0.38 s
  const Built built = build_valid(description);
  const auto truth = agreed_motion(built.model, built.start,
                                   opinions_of(built.model, built.start, quarters, most_seconds), bound);
  ASSERT_TRUE(truth);
  EXPECT_EQ(truth->horizon(), 0.25);
}

// Without rigid links shake and rattle make the very same steps: that they agree says nothing.
TEST(Opinions, OfSpringsHoldShakeAndRattleOnce) {
  Description description = pendulum();
  description.links[0].properties.stiffness = 500.0;
  const Built built = build_valid(description);
  std::vector<std::string> names;
  for (const Opinion& opinion : opinions_of(built.model, built.start, quarters, most_seconds))
    names.push_back(opinion.name);
  EXPECT_NE(std::ranges::find(names, "shake"), names.end());
  EXPECT_EQ(std::ranges::find(names, "rattle order 2"), names.end());
}

// Two balls linked by a rod fall on the ground, one after the other. Of a pass a step and of sixty-four the
// limits of short steps are different motions, and an opinion knows by how much.
TEST(Opinions, OfImpactsAreOfManyPasses) {
  Description description = level_chain(6, 0.1);
  description.chains[0].pinned.clear();
  description.chains[0].to = {0.6, 0.05, 0.0};
  description.planes = {PlaneSpec{{0.0, -0.05, 0.0}, Vec3::UnitY(), 0.4}};
  const Built built = build_valid(description);
  const std::vector<double> times{0.05, 0.1, 0.15, 0.2};
  const auto opinions = opinions_of(built.model, built.start, times, 0.05);
  const auto verlet = std::ranges::find(opinions, "verlet", &Opinion::name);
  ASSERT_NE(verlet, opinions.end());
  const State many = run(built, settings("verlet", verlet->rate, 64.0), 0.2);
  EXPECT_EQ(state_hash(verlet->fine.back()), state_hash(many));
}

// Without two opinions that are close to one another there is no truth.
TEST(AgreedMotion, IsNoneWhereRunsAreTooCoarse) {
  const Built built = build_valid(level_chain(20, 0.1));
  EXPECT_FALSE(
      agreed_motion(built.model, built.start, opinions_of(built.model, built.start, {2.0}, 1e-4), bound));
}

TEST(AgreedSummaries, OfAPendulumAreItsSagAndEnergy) {
  const Built built = build_valid(pendulum());
  const Truth truth =
      agreed_summaries(built.model, built.start,
                       opinions_of(built.model, built.start, quarters, most_seconds), quarters, "why");
  EXPECT_TRUE(truth.states.empty());
  EXPECT_EQ(truth.remark, "why");
  ASSERT_EQ(truth.summaries.size(), quarters.size());
  ASSERT_TRUE(truth.smallest[ErrorKind::sag] && truth.smallest[ErrorKind::energy]);
  for (std::size_t i = 0; i < quarters.size(); ++i) {
    EXPECT_NEAR(truth.summaries[i].sag, -exact_bob(quarters[i]).y(), *truth.smallest[ErrorKind::sag]);
    EXPECT_NEAR(truth.summaries[i].energy, 0.0, *truth.smallest[ErrorKind::energy] * 9.81);
  }
}

// A method that is left alone is its own second opinion, and says so.
TEST(AgreedMotion, OfOneMethodAloneSaysSo) {
  Description description = pendulum();
  LinkProperties soft;
  soft.stiffness = 500.0;
  description.links[0].properties = soft;
  const Built built = build_valid(description);
  std::vector<Opinion> opinions = opinions_of(built.model, built.start, quarters, most_seconds);
  std::erase_if(opinions, [](const Opinion& opinion) { return opinion.name != "xpbd double"; });
  ASSERT_EQ(opinions.size(), 1U);
  const auto truth = agreed_motion(built.model, built.start, opinions, bound);
  ASSERT_TRUE(truth);
  EXPECT_NE(truth->how.find("no other method"), std::string::npos) << truth->how;
}

TEST(JudgingKind, IsTheSagWhereTheMotionIsNotKnownFinelyEnough) {
  Truth truth;
  EXPECT_EQ(judging_kind(truth, ErrorKind::trajectory, 0.01), ErrorKind::sag);
  truth.smallest[ErrorKind::trajectory] = 0.05;
  EXPECT_EQ(judging_kind(truth, ErrorKind::trajectory, 0.1), ErrorKind::trajectory);
  EXPECT_EQ(judging_kind(truth, ErrorKind::trajectory, 0.01), ErrorKind::trajectory);
  truth.smallest[ErrorKind::sag] = 0.001;
  EXPECT_EQ(judging_kind(truth, ErrorKind::trajectory, 0.1), ErrorKind::trajectory);
  EXPECT_EQ(judging_kind(truth, ErrorKind::trajectory, 0.01), ErrorKind::sag);
}

// What is finer than the truth can't be told from it: such a plan is never said to be reached.
TEST(Plan, IsNotReachedBelowWhatCanBeJudged) {
  const Built built = build_valid(pendulum());
  auto truth = agreed_motion(built.model, built.start,
                             opinions_of(built.model, built.start, quarters, most_seconds), bound);
  ASSERT_TRUE(truth);
  for (const ErrorKind kind : {ErrorKind::trajectory, ErrorKind::sag}) truth->smallest[kind] = 0.02;
  const auto searched = [&](double wanted) {
    const AccuracyTarget target{ErrorKind::trajectory, wanted, false};
    return make_plan(built.model, built.start, *truth, target,
                     quick_plan(built.model, built.start, 1.0, target));
  };
  const Plan within = searched(0.05);
  EXPECT_TRUE(within.reached) << within.why;
  const Plan below = searched(0.01);
  EXPECT_FALSE(below.reached) << below.why;
  EXPECT_EQ(below.estimated_error, 0.02);
}

}  // namespace
}  // namespace taut::test
