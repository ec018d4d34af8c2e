// Order of convergence and error against exact solutions and finer runs of a better method.

#include "fixtures.h"
#include "measure/exact.h"
#include "model/measures.h"

namespace taut::test {
namespace {

struct Case {
  std::string label;
  Settings settings;  // but for steps_per_second
  std::vector<double> rates;
  double order, tolerance;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.label;
}

std::string case_label(const ::testing::TestParamInfo<Case>& info) {
  return info.param.label;
}

Settings with(Settings settings, const char* name, std::variant<double, std::string> value) {
  settings.values[name] = std::move(value);
  return settings;
}

Settings at_rate(Settings settings, double rate) {
  return with(std::move(settings), "steps_per_second", rate);
}

double order_of(const Case& c, const Built& built, double duration, const State& reference) {
  std::vector<double> steps, errors;
  for (const double rate : c.rates) {
    steps.push_back(1.0 / rate);
    errors.push_back(position_error(run(built, at_rate(c.settings, rate), duration), reference));
  }
  for (std::size_t i = 0; i < steps.size(); ++i)
    std::printf("  %s %7.0f steps/s: %.3g m\n", c.label.c_str(), 1.0 / steps[i], errors[i]);
  return observed_order(steps, errors);
}

class RigidConvergence : public ::testing::TestWithParam<Case> {};

TEST_P(RigidConvergence, OnThePendulum) {
  const Case& c = GetParam();
  const Built built = build_valid(pendulum());
  State exact = built.start;
  const double angle = pendulum_angle_below_level(1.0, 9.81, 1.0);
  exact.position.set(1, {std::cos(angle), -std::sin(angle), 0.0});
  EXPECT_NEAR(order_of(c, built, 1.0, exact), c.order, c.tolerance);
}

// The reference is a fourth-order run with an error far below any judged here (its own halving changes it by
// 1e-11 m).
TEST_P(RigidConvergence, OnAChainOfTwentyLinks) {
  const Case& c = GetParam();
  const Built built = build_valid(level_chain(20, 0.1));
  const Settings fine = with(settings("rattle", 0.0), "order", std::string("4"));
  const State reference = run(built, at_rate(fine, 9600.0), 0.5);
  EXPECT_LT(position_error(reference, run(built, at_rate(fine, 19200.0), 0.5)), 2e-10);
  EXPECT_NEAR(order_of(c, built, 0.5, reference), c.order, c.tolerance);
}

std::vector<Case> rigid_cases() {
  const std::vector<double> coarse{200, 300, 600, 1200}, fine{2400, 4800, 9600, 19200};
  return {
      {"rattle_2", settings("rattle", 0), {600, 1200, 2400, 4800}, 2.0, 0.1},
      {"rattle_4", with(settings("rattle", 0), "order", std::string("4")), coarse, 4.0, 0.3},
      {"shake_converged", with(with(settings("shake", 0), "passes", 1e5), "tolerance", 1e-12), fine, 2.0,
       0.15},
      {"verlet", settings("verlet", 0, 1), fine, 1.0, 0.15},
      {"xpbd", settings("xpbd", 0, 1), fine, 1.0, 0.15},
      {"newton", settings("newton", 0), fine, 1.0, 0.15},
  };
}

INSTANTIATE_TEST_SUITE_P(Methods, RigidConvergence, ::testing::ValuesIn(rigid_cases()), case_label);

class ElasticConvergence : public ::testing::TestWithParam<Case> {};

// A chain of 20 springs of 4000 N/m that swings and stretches; the reference is rattle, whose springs are
// forces in half kicks of second order, ten times finer than the finest run judged.
TEST_P(ElasticConvergence, OnAChainOfTwentySprings) {
  const Case& c = GetParam();
  Description description = level_chain(20, 0.1);
  description.chains[0].properties.stiffness = 4000.0;
  const Built built = build_valid(description);
  const State reference = run(built, settings("rattle", 153600.0), 0.5);
  EXPECT_NEAR(order_of(c, built, 0.5, reference), c.order, c.tolerance);
}

std::vector<Case> elastic_cases() {
  const std::vector<double> rates{2400, 4800, 9600, 19200};
  return {
      {"spring_explicit", settings("spring-explicit", 0), rates, 1.0, 0.15},
      {"spring_implicit", settings("spring-implicit", 0), rates, 1.0, 0.15},
      {"rattle", settings("rattle", 0), rates, 2.0, 0.15},
      {"shake", settings("shake", 0), rates, 2.0, 0.15},
      {"newton", settings("newton", 0), rates, 1.0, 0.15},
  };
}

INSTANTIATE_TEST_SUITE_P(Methods, ElasticConvergence, ::testing::ValuesIn(elastic_cases()), case_label);

class MixedConvergence : public ::testing::TestWithParam<Case> {};

// A net of rigid links with damped diagonals, in air and wind: forces that ask for the velocity at the end of
// a step, and links that have a say in it. The reference is the integration at acceleration level, its
// tolerance far below any error judged.
TEST_P(MixedConvergence, OnADampedNetInTheWind) {
  const Case& c = GetParam();
  Description description;
  description.drag = 0.8;
  SheetSpec sheet;
  sheet.name = "net";
  sheet.rows = 4;
  sheet.columns = 5;
  sheet.to = {0.8, 0.0, 0.0};
  sheet.down = {0.0, -0.45, 0.4};
  sheet.mass = 0.5;
  sheet.pinned = {"left"};
  sheet.diagonals = LinkProperties{40.0, 0.8, {}, {}};
  description.sheets = {sheet};
  description.wind.emplace().velocity = {1.0, 0.0, 4.0};
  description.wind->gust = 0.4;
  const Built built = build_valid(description);
  const auto reference = accurately(built.model, built.start, {0.3}, 1e-11);
  ASSERT_EQ(reference.size(), 1U);
  EXPECT_NEAR(order_of(c, built, 0.3, reference.back()), c.order, c.tolerance);
}

std::vector<Case> mixed_cases() {
  const std::vector<double> rates{2400, 4800, 9600, 19200};
  return {
      {"rattle", settings("rattle", 0), {600, 1200, 2400, 4800}, 2.0, 0.15},
      {"shake_converged",
       with(with(settings("shake", 0), "passes", 1e5), "tolerance", 1e-12),
       {600, 1200, 2400, 4800},
       2.0,
       0.15},
      {"xpbd", settings("xpbd", 0, 100), rates, 1.0, 0.15},
      {"newton", settings("newton", 0), rates, 1.0, 0.15},
  };
}

INSTANTIATE_TEST_SUITE_P(Methods, MixedConvergence, ::testing::ValuesIn(mixed_cases()), case_label);

// 20 links of 0.1 m released level, after 1 s.
TEST(RigidChain, ErrorsAfterOneSecondAreThoseOfTheMethod) {
  const Built built = build_valid(level_chain(20, 0.1));
  const Settings fourth = with(settings("rattle", 0.0), "order", std::string("4"));
  const State reference = run(built, at_rate(fourth, 9600.0), 1.0);
  const auto error = [&](const Settings& how) { return position_error(run(built, how, 1.0), reference); };
  EXPECT_LE(error(settings("shake", 6000.0, 1.0)), 5e-4);
  EXPECT_LE(error(settings("rattle", 600.0)), 4e-4);
  EXPECT_LE(error(at_rate(fourth, 600.0)), 2e-5);
}

// IFToMM benchmark library A01: the energy error stays below 5e-5 J over 10 s.
TEST(RigidPendulum, KeepsItsEnergyWithinThePublishedBound) {
  const Built built = build_valid(pendulum());
  const double at_start = energy(built.model, built.start).total();
  State state = built.start;
  double worst = 0.0;
  const Settings how = settings("rattle", 1000.0);
  for (int part = 0; part < 1000; ++part) {
    ASSERT_EQ(simulate(built.model, state, how, 10).end, RunEnd::none);
    worst = std::max(worst, std::abs(energy(built.model, state).total() - at_start));
  }
  EXPECT_LT(worst, 5e-5);
}

}  // namespace
}  // namespace taut::test
