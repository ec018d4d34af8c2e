#include <gtest/gtest.h>

#include "methods/breaking.h"
#include "model/description.h"

namespace taut {
namespace {

// Three masses in a row, pinned – free – free, on links of 1 m.
Built row(LinkProperties first, LinkProperties second) {
  Description description;
  for (const double x : {0.0, 1.0, 2.0}) {
    MassSpec mass;
    mass.name = std::string(1, static_cast<char>('a' + static_cast<int>(x)));
    mass.position = {x, 0.0, 0.0};
    mass.pinned = x == 0.0;
    description.masses.push_back(mass);
  }
  description.links = {LinkSpec{"a", "b", 1.0, first}, LinkSpec{"b", "c", 1.0, second}};
  return build(description);
}

LinkProperties by_tension(double threshold) {
  LinkProperties properties;
  properties.break_tension = threshold;
  return properties;
}

TEST(FirstBreak, IsNothingBelowTheThresholds) {
  const Built built = row(by_tension(10.0), by_tension(10.0));
  State after = built.start;
  after.tension = {10.0, 9.0};
  EXPECT_FALSE(first_break(built.model, built.start, after).has_value());
}

TEST(FirstBreak, IsWhereTheTensionPasses) {
  const Built built = row(by_tension(10.0), by_tension(10.0));
  State before = built.start, after = built.start;
  before.tension = {8.0, 6.0};
  after.tension = {12.0, 11.0};  // they pass after a half and after four fifths
  const auto first = first_break(built.model, before, after);
  ASSERT_TRUE(first.has_value());
  EXPECT_DOUBLE_EQ(first->share, 0.5);
  EXPECT_EQ(first->links, std::vector<Index>{0});
}

TEST(FirstBreak, TakesAllThatPassAtOnce) {
  const Built built = row(by_tension(10.0), by_tension(20.0));
  State before = built.start, after = built.start;
  before.tension = {8.0, 16.0};
  after.tension = {12.0, 24.0 + 1e-12};
  const auto first = first_break(built.model, before, after);
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first->links, (std::vector<Index>{0, 1}));
}

TEST(FirstBreak, IsAtTheStartForWhatIsOverThere) {
  const Built built = row(by_tension(10.0), by_tension(10.0));
  State before = built.start, after = built.start;
  before.tension = {8.0, 15.0};
  after.tension = {12.0, 14.0};
  const auto first = first_break(built.model, before, after);
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first->share, 0.0);
  EXPECT_EQ(first->links, std::vector<Index>{1});
}

TEST(FirstBreak, IsWhereTheLengthPasses) {
  LinkProperties stretched;
  stretched.break_stretch = 1.2;
  const Built built = row({}, stretched);
  State before = built.start, after = built.start;
  before.position.x[2] = 2.1;
  after.position.x[2] = 2.5;
  const auto first = first_break(built.model, before, after);
  ASSERT_TRUE(first.has_value());
  EXPECT_NEAR(first->share, 0.25, 1e-12);
  after.broken_at[1] = 0.0;
  EXPECT_FALSE(first_break(built.model, before, after).has_value()) << "it is broken already";
}

// A kick of half a step under gravity that the links have not answered: of a mass that hangs at rest nothing
// is left once they have.
TEST(BreakAtOnce, LinksAnswerTheKickOnceMore) {
  const Built built = row(by_tension(10.0), by_tension(10.0));
  State state = built.start;
  state.time = 2.0;
  state.position.x = {0.0, 0.0, 0.0};
  state.position.y = {0.0, -1.0, -2.0};
  state.unanswered_kick = 0.05;
  state.velocity.y = {0.0, -0.05 * 9.81, -0.05 * 9.81};
  state.tension = {2.0 * 9.81, 9.81};
  state.tension_before = state.tension;
  break_at_once(built.model, state, {0});
  EXPECT_NEAR(state.velocity.y[1], 0.0, 1e-15);
  EXPECT_NEAR(state.velocity.y[2], 0.0, 1e-15);
  EXPECT_EQ(state.unanswered_kick, 0.0);
  EXPECT_TRUE(state.tension_before.empty());
  EXPECT_EQ(state.broken_at[0], 2.0);
  EXPECT_EQ(state.tension[0], 0.0);
  EXPECT_FALSE(state.broken(1));
}

}  // namespace
}  // namespace taut
