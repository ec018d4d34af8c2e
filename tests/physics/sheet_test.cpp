// A curtain of rigid rows and columns in pleats on hooks.

#include "fixtures.h"
#include "model/measures.h"

namespace taut::test {
namespace {

constexpr double cloth_height = 2.2;  // m

Description curtain(int size, int hook_every, double drag) {
  SheetSpec cloth;
  cloth.name = "cloth";
  cloth.rows = cloth.columns = size;
  cloth.from = {-1.2, 2.5, 0.0};
  cloth.to = {1.2, 2.5, 0.0};
  cloth.down = {0.0, -cloth_height, 0.0};
  cloth.mass = 1.6;
  cloth.fullness = 1.67;
  cloth.hooks.every = hook_every;
  Description description;
  description.drag = drag;
  description.sheets = {cloth};
  return description;
}

Description drawn_curtain(int size, int hook_every) {
  Description description = curtain(size, hook_every, 0.8);
  description.sheets[0].hooks.draw = {{0.0, 1.0}, {2.0, 0.35}};
  return description;
}

double settled_sag(const Built& built, const Settings& how) {
  const State end = run(built, how, 6.0);
  EXPECT_LT(fastest_speed(end), 2e-3) << how.method;
  return sag(built.model, end);
}

// Three methods that share nothing but the kick come to rest at one sag, to 1e-4 of the cloth's height.
TEST(Curtain, SettledSagIsTheSameForEveryMethod) {
  const Built built = build_valid(curtain(16, 5, 4.0));
  const double with_newton = settled_sag(built, settings("newton", 240.0));
  const double with_xpbd = settled_sag(built, settings("xpbd", 600.0, 60.0));
  const double with_rattle = settled_sag(built, settings("rattle", 960.0));
  EXPECT_GT(with_newton, cloth_height) << "it hangs lower than its height: the rail's row sags too";
  EXPECT_NEAR(with_xpbd, with_newton, 1e-4 * cloth_height);
  EXPECT_NEAR(with_rattle, with_newton, 1e-4 * cloth_height);
}

void expect_hooks_on_their_rail(const Built& built, const State& state) {
  for (const DrivenPin& pin : built.model.driven_pins)
    EXPECT_EQ(state.position.at(pin.mass), position_at(pin.motion, state.time));
}

TEST(Curtain, NewtonHoldsALargeOneOnDrivenHooks) {
  const Built built = build_valid(drawn_curtain(64, 9));
  const State end = run(built, settings("newton", 240.0), 0.15);
  EXPECT_LE(link_strain(built.model, end).largest, 1e-10);
  expect_hooks_on_their_rail(built, end);
}

TEST(Curtain, XpbdHoldsALargeOneOnDrivenHooks) {
  const Built built = build_valid(drawn_curtain(64, 9));
  const State end = run(built, settings("xpbd", 1200.0), 0.75);
  EXPECT_LE(link_strain(built.model, end).largest, 0.1);
  expect_hooks_on_their_rail(built, end);
}

// When pleats snap, a step of 1/60 s is far too long for rattle: it is halved until it holds, and counted.
TEST(Curtain, RattleHoldsThroughHalvings) {
  const Built built = build_valid(drawn_curtain(16, 5));
  State state = built.start;
  const RunReport report = simulate(built.model, state, settings("rattle", 60.0), 180);
  ASSERT_EQ(report.end, RunEnd::none);
  EXPECT_GT(report.halved_steps, 10);
  EXPECT_GE(report.counts.halvings, report.halved_steps);
  EXPECT_LE(link_strain(built.model, state).largest, 1e-10);
  expect_hooks_on_their_rail(built, state);
}

// Without halving it stops there, with a sentence that names time, step and link.
TEST(Curtain, RattleWithoutHalvingStopsWithTheReason) {
  const Built built = build_valid(drawn_curtain(16, 5));
  taut::Run run(built.model, built.start, settings("rattle", 60.0), chart_policy);
  while (run.steps() < 180 && run.step()) {
  }
  ASSERT_EQ(run.report().end, RunEnd::step_failed);
  EXPECT_TRUE(all_finite(run.state()));
  EXPECT_LE(link_strain(built.model, run.state()).largest, 1e-10) << "the last good state is kept";
  const std::string sentence = run.failure();
  for (const char* part : {"t = ", "0.0167 s", "method rattle", "cloth."})
    EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
}

}  // namespace
}  // namespace taut::test
