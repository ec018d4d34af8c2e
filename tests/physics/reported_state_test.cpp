#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "fixtures.h"
#include "methods/breaking.h"
#include "methods/projected_velocities.h"
#include "motion/run_measures.h"

namespace taut::test {
namespace {

Description hung_up(int rows) {
  Description description;
  SheetSpec sheet;
  sheet.name = "cloth";
  sheet.rows = sheet.columns = rows;
  sheet.from = {0.0, 2.0, 0.0};
  sheet.to = {2.0, 2.0, 0.0};
  sheet.down = {0.0, 0.0, 2.0};
  sheet.pinned = {"top"};
  description.sheets = {sheet};
  return description;
}

double largest_difference(const Vectors& a, const Vectors& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a.at(i) - b.at(i)).norm());
  return largest;
}

// What answering a kick with the state's tensions leaves, against solving for what links take of it.
double left_by_answering(const Built& built, double rate) {
  const State state = run(built, settings("shake", rate, 400.0), 0.25);
  Vectors answered = state.velocity;
  answer_kick(built.model, state, answered);
  return largest_difference(answered, projected_velocities(built.model, state));
}

TEST(ReportedState, TensionsAnswerAKickNearlyAsASolutionDoes) {
  const Built built = build_valid(hung_up(4));
  std::vector<double> steps, left;
  for (const double rate : {1000.0, 2000.0, 4000.0}) {
    steps.push_back(1.0 / rate);
    left.push_back(left_by_answering(built, rate));
  }
  const double kick = 9.81 * 0.5 * steps.back();
  EXPECT_LT(left.back(), 0.01 * kick);
  EXPECT_GT(observed_order(steps, left), 1.9);
}

// A system of that size would take a second and hundreds of megabytes.
TEST(ReportedState, LargeNetsAnswerWithTheirTensions) {
  const Built built = build_valid(hung_up(360));
  ASSERT_GT(built.model.links.size(), 250'000U);
  const Capabilities& can = find_method("shake")->can;
  State state = built.start;
  state.unanswered_kick = 0.001;
  std::ranges::fill(state.tension, 2.0);
  for (std::size_t i = 0; i < state.velocity.size(); ++i) state.velocity.set(i, {0.0, -0.01, 0.0});
  Vectors answered = state.velocity;
  answer_kick(built.model, state, answered);
  ASSERT_GT(largest_difference(answered, state.velocity), 0.0);
  EXPECT_EQ(largest_difference(reported_state(built.model, can, state).velocity, answered), 0.0);
}

}  // namespace
}  // namespace taut::test
