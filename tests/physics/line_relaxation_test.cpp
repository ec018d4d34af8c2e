// xpbd with lines of links solved at once.

#include "fixtures.h"
#include "model/measures.h"

namespace taut::test {
namespace {

Settings relaxing(const char* what, double steps_per_second, double passes = 1.0) {
  Settings how = settings("xpbd", steps_per_second, passes);
  how.values["relax"] = std::string(what);
  return how;
}

Description hung_sheet(int side, double width) {
  SheetSpec cloth;
  cloth.name = "cloth";
  cloth.rows = cloth.columns = side;
  cloth.to = {width, 0.0, 0.0};
  cloth.down = {0.0, 0.0, width};
  cloth.mass = 0.3;
  cloth.pinned = {"top"};
  Description description;
  description.sheets = {cloth};
  return description;
}

// What acts on a small sheet beside its weight.
struct LineCase {
  std::string name;
  Description description;
  bool unequal = false;  // masses

  Built built() const {
    Built sheet = build_valid(description);
    if (unequal)
      for (Index i = 0; i < sheet.model.masses.size(); ++i) {
        const double share = 0.5 + 0.25 * (i % 7);
        sheet.model.masses.mass[i] *= share;
        sheet.model.masses.inverse_mass[i] /= share;
      }
    return sheet;
  }
};

void PrintTo(const LineCase& one, std::ostream* out) {
  *out << one.name;
}

std::vector<LineCase> line_cases() {
  Description rigid = hung_sheet(6, 0.5);
  rigid.sheets[0].pinned = {"top-left"};
  std::vector<LineCase> cases{{"rigid", rigid}, {"unequal", rigid, true}};
  const auto add = [&](const char* name) -> Description& {
    cases.push_back({name, rigid});
    return cases.back().description;
  };
  Description& soft = add("soft");
  soft.sheets[0].properties.stiffness = 400.0;
  soft.sheets[0].diagonals = LinkProperties{};
  soft.sheets[0].diagonals->stiffness = 50.0;
  Description& damped = add("damped");
  damped.sheets[0].properties.stiffness = 400.0;
  damped.sheets[0].properties.damping = 0.5;
  Description& weft_alone = add("soft_weft");
  weft_alone.sheets[0].weft = LinkProperties{};
  weft_alone.sheets[0].weft->stiffness = 100.0;
  add("drag").drag = 5.0;
  Description& driven = add("driven");
  driven.sheets[0].pinned = {"top"};
  driven.sheets[0].top_motion.sinusoid = SinusoidSpec{{0.02, 0.01, 0.0}, 20.0, 0.3};
  return cases;
}

class LinesAtOnce : public ::testing::TestWithParam<LineCase> {};

// In a step that hardly turns links, by g h²/l = 1e-6, passes of either kind come to the same multipliers and
// places but for that share: those that solve all links at once.
TEST_P(LinesAtOnce, ComeToWhatLinksOneByOneComeTo) {
  Built built = GetParam().built();
  const double rate = 10000.0;
  built.start = run(built, relaxing("links", rate, 30.0), 0.2);
  const State by_links = run(built, relaxing("links", rate, 20000.0), 1.0 / rate),
              by_lines = run(built, relaxing("lines", rate, 2000.0), 1.0 / rate);
  double largest = 0.0, apart = 0.0, moved = 0.0, off = 0.0;
  for (std::size_t link = 0; link < built.model.links.size(); ++link) {
    largest = std::max(largest, std::abs(by_links.tension[link]));
    apart = std::max(apart, std::abs(by_lines.tension[link] - by_links.tension[link]));
  }
  for (Index i = 0; i < built.model.masses.size(); ++i) {
    moved = std::max(moved, (by_links.velocity.at(i) - built.start.velocity.at(i)).norm());
    off = std::max(off, (by_lines.velocity.at(i) - by_links.velocity.at(i)).norm());
  }
  EXPECT_GT(largest, 0.1);
  EXPECT_LT(apart, 1e-5 * largest);
  EXPECT_LT(off, 1e-4 * moved);
}

INSTANTIATE_TEST_SUITE_P(Cases, LinesAtOnce, ::testing::ValuesIn(line_cases()),
                         [](const auto& one) { return one.param.name; });

TEST(LineRelaxation, ChainBetweenTwoPinsRestsInItsExactShape) {
  Description description = level_chain(20, 0.1);
  description.chains[0].to = {1.2, 0.0, 0.0};
  description.chains[0].length = 2.0;
  description.chains[0].pinned = {"first", "last"};
  description.drag = 6.0;
  const Built built = build_valid(description);
  const State end = run(built, relaxing("lines", 600.0), 12.0);
  const HangingChain exact = hanging_chain_at_rest(Vec3::Zero(), {1.2, 0.0, 0.0}, 20, 0.1, 0.0, 9.81);
  double off = 0.0, wrong = 0.0;
  for (std::size_t i = 0; i < exact.positions.size(); ++i)
    off = std::max(off, (end.position.at(i) - exact.positions[i]).norm());
  for (std::size_t i = 0; i < exact.tensions.size(); ++i)
    wrong = std::max(wrong, std::abs(end.tension[i] / exact.tensions[i] - 1.0));
  EXPECT_LT(off, 1e-4);
  EXPECT_LT(wrong, 1e-3);
}

// Chains of rigid links, and of all kinds of links with drag, against the motion without any steps.
TEST(LineRelaxation, ConvergesAtFirstOrder) {
  for (const Description& description : {level_chain(20, 0.05), mixed_chain()}) {
    const Built built = build_valid(description);
    const State exact = accurately(built.model, built.start, {0.4}, 1e-10).front();
    std::vector<double> steps, errors;
    for (const double rate : {2400.0, 4800.0, 9600.0, 19200.0}) {
      steps.push_back(1.0 / rate);
      errors.push_back(position_error(run(built, relaxing("lines", rate), 0.4), exact));
    }
    EXPECT_NEAR(observed_order(steps, errors), 1.0, 0.1) << errors.front() << " … " << errors.back();
    EXPECT_LT(errors.back(), 2e-3);
  }
}

// Of a plumb chain at rest what is below a broken link falls, and what is above stays.
TEST(LineRelaxation, ABrokenLinkHoldsNothing) {
  Description description = level_chain(20, 0.05);
  description.chains[0].to = {0.0, -1.0, 0.0};
  Built built = build_valid(description);
  built.start.broken_at[10] = 0.0;
  const double time = 0.3;
  const State end = run(built, relaxing("lines", 600.0), time);
  for (Index mass = 0; mass < built.model.masses.size(); ++mass)
    EXPECT_NEAR(end.velocity.y[mass], mass > 10 ? -9.81 * time : 0.0, 1e-9) << "mass " << mass;
  EXPECT_EQ(end.tension[10], 0.0);
  EXPECT_NEAR(end.tension[9], 9.81, 1e-6) << "the weight of the last mass that still hangs";
}

// A line is solved exactly whatever its masses weigh, and from whichever end it begins. (Link by link the tip
// stretches this chain by two thirds.)
TEST(LineRelaxation, ATipTenThousandTimesAsHeavyHangsOnAChain) {
  for (const bool from_the_pin : {true, false}) {
    Description description = level_chain(50, 0.02);
    ChainSpec& chain = description.chains[0];
    chain.to = {0.2, -std::sqrt(0.96), 0.0};
    if (!from_the_pin) {
      std::swap(chain.from, chain.to);
      chain.pinned = {"last"};
    }
    Built built = build_valid(description);
    const Index tip = from_the_pin ? 50 : 0;
    built.model.masses.mass[tip] *= 1e4;
    built.model.masses.inverse_mass[tip] /= 1e4;
    taut::Run moving(built.model, built.start, relaxing("lines", 4800.0));
    double strain = 0.0;
    for (int step = 0; step < 4800; ++step) {
      ASSERT_TRUE(moving.step()) << moving.failure();
      strain = std::max(strain, link_strain(built.model, moving.state()).largest);
    }
    EXPECT_LT(strain, 1e-9) << (from_the_pin ? "from the pin" : "from the tip");
  }
}

// Links push along where they point to before masses are put back, so a mass m that vibrates sideways between
// two links of length l under a tension T, ω² = 2 T/(m l), moves by v ← v − h ω² (x + h v), x ← x + h v in a
// step of one pass. Both eigenvalues of that are within the unit circle until h² ω² = 4/3.
TEST(LineRelaxation, SidewaysVibrationsSetTheLongestStep) {
  Description description = level_chain(2, 0.5);
  description.chains[0].to = {0.0, -1.0, 0.0};
  Built built = build_valid(description);
  built.model.masses.mass[2] = 1e4;
  built.model.masses.inverse_mass[2] = 1e-4;
  built.start.position.x[1] = 1e-6;
  const double longest = std::sqrt(4.0 / 3.0 / (2.0 * 1e4 * 9.81 / 0.5));
  const auto sideways_after = [&](double share) {
    taut::Run moving(built.model, built.start, relaxing("lines", 1.0 / (share * longest)));
    for (int step = 0; step < 400; ++step) EXPECT_TRUE(moving.step()) << moving.failure();
    return std::abs(moving.state().position.x[1]);
  };
  EXPECT_LT(sideways_after(0.97), 1e-9);
  EXPECT_GT(sideways_after(1.03), 1e-5);
}

// The largest strain at the end of any frame of 1/60 s; infinite where the run ends early.
double largest_strain(const Built& built, const Settings& how, double seconds) {
  taut::Run moving(built.model, built.start, how);
  const auto steps_a_frame = std::llround(how.steps_per_second() / 60.0);
  double strain = 0.0;
  for (int frame = 0; frame < std::lround(60.0 * seconds); ++frame) {
    for (std::int64_t step = 0; step < steps_a_frame; ++step) moving.step();
    strain = std::max(strain, link_strain(built.model, moving.state()).largest);
  }
  EXPECT_FALSE(moving.ended()) << moving.failure();
  return moving.ended() ? infinity : strain;
}

TEST(LineRelaxation, HungSheetStaysShortInFewSteps) {
  EXPECT_LT(largest_strain(build_valid(hung_sheet(64, 1.0)), relaxing("lines", 480.0), 5.0), 0.003);
}

// In steps that are far too long links are torn to 155 times their lengths, but the run goes on. (Link
// by link to 44 times; at 240 steps/s to 20 and 4.5.)
TEST(LineRelaxation, HungSheetStaysFiniteInLongSteps) {
  EXPECT_LT(largest_strain(build_valid(hung_sheet(64, 1.0)), relaxing("lines", 60.0), 5.0), infinity);
}

// A straight row whose ends are driven 1 % apart can't be as long as it should: all of its links give way
// alike, but for what the last move of a pin adds.
TEST(LineRelaxation, StraightRowPulledApartStaysInLine) {
  Description description = level_chain(20, 0.1);
  description.gravity = Vec3::Zero();
  description.chains[0].pinned = {"first", "last"};
  description.chains[0].last_motion.path = {{0.5, {2.02, 0.0, 0.0}}};
  const Built built = build_valid(description);
  for (const double passes : {1.0, 10.0}) {
    const State end = run(built, relaxing("lines", 600.0, passes), 1.0);
    EXPECT_NEAR(link_strain(built.model, end).largest, 0.01, 0.005) << passes;
    for (Index i = 0; i < built.model.masses.size(); ++i) {
      EXPECT_EQ(end.position.y[i], 0.0);
      EXPECT_EQ(end.position.z[i], 0.0);
    }
  }
}

TEST(LineRelaxation, InSinglePrecisionIsRefused) {
  const Built built = build_valid(pendulum());
  Settings how = relaxing("lines", 600.0);
  how.values["precision"] = std::string("single");
  const std::vector<std::string> problems = refusals(built.model, built.start, complete_settings(how));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems[0].find("double precision"), std::string::npos) << problems[0];
}

}  // namespace
}  // namespace taut::test
