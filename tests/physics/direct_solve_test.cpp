// Link lengths to machine precision, on chains of every length, trees, nets, and the cases that are hard.

#include <fmt/format.h>

#include "fixtures.h"
#include "measure/exact.h"
#include "methods/registry.h"
#include "model/measures.h"

namespace taut::test {
namespace {

struct Watched {
  State state;
  StepReport report;
  double largest_strain = 0.0;  // over all steps
};

Watched run_watched(const Built& built, const Settings& how, int steps) {
  Watched run{built.start, {}, 0.0};
  for (int step = 0; step < steps; ++step) {
    run.report.add(simulate(built.model, run.state, how, 1).counts);
    EXPECT_EQ(run.report.status, StepStatus::done);
    if (run.report.status != StepStatus::done) break;
    run.largest_strain = std::max(run.largest_strain, link_strain(built.model, run.state).largest);
  }
  return run;
}

class DirectMethods : public ::testing::TestWithParam<std::string> {};

TEST_P(DirectMethods, ChainsHoldTheirLengths) {
  for (const int links : {10, 100, 1000, 10000}) {
    const Built built = build_valid(level_chain(links, 0.1));
    State state = built.start;
    const RunReport report = simulate(built.model, state, settings(GetParam(), 2400.0), 200);
    ASSERT_EQ(report.end, RunEnd::none) << links << " links";
    EXPECT_LE(link_strain(built.model, state).largest, 1e-10) << links << " links";
  }
}

TEST_P(DirectMethods, HeavyTipsHoldTheirLengths) {
  for (const double ratio : {1.0, 100.0, 10000.0}) {
    Description description = level_chain(99, 1.0 / 99.0);
    description.chains[0].last_mass = ratio;
    const Watched watched = run_watched(build_valid(description), settings(GetParam(), 2400.0), 200);
    EXPECT_LE(watched.largest_strain, 1e-10)
        << "ratio " << ratio << ", " << watched.report.halvings << " halvings";
  }
}

// A hub with three arms of unequal links and masses, hung from one arm: a tree, not a path.
Description mobile() {
  Description description;
  const auto add_mass = [&](std::string name, Vec3 position, double mass, bool pinned = false) {
    MassSpec spec;
    spec.name = std::move(name);
    spec.position = position;
    spec.mass = mass;
    spec.pinned = pinned;
    description.masses.push_back(spec);
  };
  add_mass("hook", {0.0, 0.0, 0.0}, 1.0, true);
  add_mass("hub", {0.6, -0.2, 0.1}, 0.7);
  add_mass("left", {0.5, -0.9, 0.4}, 1.3);
  add_mass("right", {1.4, -0.3, -0.2}, 0.4);
  add_mass("lower", {1.6, -0.9, -0.5}, 2.0);
  add_mass("back", {0.7, -0.5, -0.6}, 0.9);
  for (const auto& [a, b] :
       {std::pair{"hook", "hub"}, {"hub", "left"}, {"right", "hub"}, {"right", "lower"}, {"back", "hub"}})
    description.links.push_back(LinkSpec{a, b, std::nullopt, {}});
  return description;
}

TEST_P(DirectMethods, TreesHoldTheirLengthsHungAndFree) {
  for (const bool hung : {true, false}) {
    Description description = mobile();
    description.masses[0].pinned = hung;
    if (!hung) description.masses[2].velocity = {1.0, 2.0, 3.0};
    const Watched watched = run_watched(build_valid(description), settings(GetParam(), 1000.0), 1000);
    EXPECT_LE(watched.largest_strain, 1e-10) << (hung ? "hung" : "free");
  }
}

// How far a tree's masses are, after half a second, from those of the same tree with a net beside it that
// does not touch it: links in nets are solved in another way.
double tree_net_difference(std::string_view method, double steps_per_second) {
  const Built tree = build_valid(mobile());
  Description ringed = mobile();
  // A second tree hung from two pins counts as a net.
  for (const auto& [name, x, pinned] :
       {std::tuple{"p", 5.0, true}, {"q", 5.5, false}, {"r", 6.0, true}, {"s", 5.5, false}}) {
    MassSpec spec;
    spec.name = name;
    spec.position = {x, name[0] == 'q' ? -0.5 : name[0] == 's' ? -1.5 : 0.0, 0.0};
    spec.pinned = pinned;
    ringed.masses.push_back(spec);
  }
  for (const auto& [a, b] : {std::pair{"p", "q"}, {"q", "r"}, {"q", "s"}})
    ringed.links.push_back(LinkSpec{a, b, std::nullopt, {}});
  const Built net = build_valid(ringed);
  const Settings how = settings(std::string(method), steps_per_second);
  const State in_tree = run(tree, how, 0.5), in_net = run(net, how, 0.5);
  double largest = 0.0;
  for (std::size_t i = 0; i < in_tree.position.size(); ++i)
    largest = std::max(largest, (in_tree.position.at(i) - in_net.position.at(i)).norm());
  return largest;
}

TEST(Rattle, TreesAndNetsAgree) {
  EXPECT_LT(tree_net_difference("rattle", 1000.0), 1e-9);
}

// newton balances forces in nets and nearly does in trees: what is left there makes a difference of second
// order, below the method's own error.
TEST(Newton, TreesAndNetsAgreeToSecondOrder) {
  const double coarse = tree_net_difference("newton", 1000.0), fine = tree_net_difference("newton", 4000.0);
  EXPECT_LT(coarse, 1e-4);
  EXPECT_NEAR(coarse / fine, 16.0, 3.0);
}

// Rigid diagonals make a sheet's links redundant: the system is singular and must be solved all the same.
TEST_P(DirectMethods, RedundantRigidDiagonalsAreSolved) {
  Description description;
  SheetSpec sheet;
  sheet.name = "plate";
  sheet.rows = sheet.columns = 4;
  sheet.to = {0.3, 0.0, 0.0};
  sheet.down = {0.0, -0.3, 0.0};
  sheet.pinned = {"top-left"};
  sheet.diagonals = LinkProperties{};
  description.sheets = {sheet};
  const Watched watched = run_watched(build_valid(description), settings(GetParam(), 1000.0), 300);
  EXPECT_LE(watched.largest_strain, 1e-9);
}

// A straight row pulled taut between two pins has one link more than its directions can tell apart.
TEST_P(DirectMethods, TautRowBetweenTwoPinsIsSolvedOrRefused) {
  Description description = level_chain(6, 0.2);
  description.chains[0].pinned = {"first", "last"};
  description.gravity = Vec3::Zero();
  const Built built = build_valid(description);
  const Watched watched = run_watched(built, settings(GetParam(), 600.0), 60);
  EXPECT_LT(position_error(watched.state, built.start), 1e-9);
}

// At rest under drag the chain between two pins has its exact shape and tensions. (newton's rest differs from
// it by h²: its corrections follow the directions of the masses before they are put back, 8e-6 m at 600
// steps/s.)
TEST_P(DirectMethods, ChainBetweenTwoPinsRestsInItsExactShape) {
  Description description = level_chain(20, 0.1);
  description.chains[0].to = {1.2, 0.0, 0.0};
  description.chains[0].length = 2.0;
  description.chains[0].pinned = {"first", "last"};
  description.drag = 6.0;
  const Built built = build_valid(description);
  const State end = run(built, settings(GetParam(), 2400.0), 12.0);
  const HangingChain exact = hanging_chain_at_rest(Vec3::Zero(), {1.2, 0.0, 0.0}, 20, 0.1, 0.0, 9.81);
  for (std::size_t i = 0; i < exact.positions.size(); ++i)
    EXPECT_LT((end.position.at(i) - exact.positions[i]).norm(), 1e-6) << "mass " << i;
  for (std::size_t i = 0; i < exact.tensions.size(); ++i)
    EXPECT_NEAR(end.tension[i], exact.tensions[i], 1e-3 * exact.tensions[i]) << "link " << i;
}

INSTANTIATE_TEST_SUITE_P(Methods, DirectMethods, ::testing::Values("rattle", "newton"), case_name);

// 1000 masses over 1 m, the last one 100 times heavier than the others, released level, for 5 s.
TEST(Newton, ThousandLightMassesWithAHeavyTipHold) {
  Description description = level_chain(999, 1.0 / 999.0);
  description.chains[0].last_mass = 100.0;
  const Watched watched = run_watched(build_valid(description), settings("newton", 960.0), 4800);
  EXPECT_LE(watched.largest_strain, 1e-8) << watched.report.halvings << " halvings";
}

// Springs too stiff for the step are refused before the run, with the method that takes them.
TEST(Rattle, RefusesSpringsTooStiffForTheStep) {
  Description description = level_chain(10, 0.1);
  description.chains[0].properties.stiffness = 1e6;  // 2√(k/m) = 2000 rad/s
  const Built built = build_valid(description);
  State state = built.start;
  for (const char* method : {"rattle", "shake"}) {
    try {
      simulate(built.model, state, settings(method, 600.0), 1);
      ADD_FAILURE() << method << " took it";
    } catch (const std::exception& error) {
      EXPECT_NE(std::string(error.what()).find("method newton"), std::string::npos) << error.what();
    }
    EXPECT_EQ(simulate(built.model, state, settings(method, 2400.0), 1).end, RunEnd::none);
  }
}

struct Moved {
  State state;
  StepReport counts;
};

Moved moved_by(const Model& model, const State& start, const Settings& how, std::int64_t steps) {
  taut::Run run(model, start, how);
  while (run.steps() < steps && run.step()) {
  }
  return {run.state(), run.report().counts};
}

// A chain in an arc across all axes.
Description arc(int links, const std::vector<std::string>& pinned) {
  Description description = level_chain(links, 0.1);
  description.chains[0].to = {0.06 * links, 0.02 * links, 0.03 * links};
  description.chains[0].length = 0.1 * links;
  description.chains[0].pinned = pinned;
  return description;
}

// Chains that only fall are taken block by block from both ends, so what holds where blocks meet is asked of
// lengths about those of blocks. A load of no force changes nothing but that they are taken all at once.
void expect_same_in_blocks(const Built& built, const Settings& how, std::int64_t steps) {
  Model loaded = built.model;
  loaded.loads.push_back({{0}, Vec3::Zero(), 0.0, 0.0});
  const Moved in_blocks = moved_by(built.model, built.start, how, steps),
              at_once = moved_by(loaded, built.start, how, steps);
  EXPECT_EQ(in_blocks.state.position, at_once.state.position);
  EXPECT_EQ(in_blocks.state.velocity, at_once.state.velocity);
  EXPECT_EQ(in_blocks.state.tension, at_once.state.tension);
  EXPECT_EQ(in_blocks.state.time, at_once.state.time);
  EXPECT_EQ(in_blocks.counts.status, at_once.counts.status);
  EXPECT_EQ(in_blocks.counts.worst_link, at_once.counts.worst_link);
  EXPECT_EQ(in_blocks.counts.rounds, at_once.counts.rounds);
  EXPECT_EQ(in_blocks.counts.factorisations, at_once.counts.factorisations);
  EXPECT_EQ(in_blocks.counts.halvings, at_once.counts.halvings);
}

TEST_P(DirectMethods, ChainsInBlocksAreThoseAllAtOnce) {
  const std::vector<std::vector<std::string>> pins{{"first"}, {"last"}, {"first", "last"}, {}};
  const std::vector<int> lengths{1,   2,   7,   8,   9,   15,  16,  17,  33,   40,   255,  256,
                                 257, 511, 512, 513, 514, 515, 544, 545, 1023, 1025, 1026, 1600};
  for (const int links : lengths)
    for (std::size_t i = 0; i < pins.size(); ++i) {
      SCOPED_TRACE(fmt::format("{} links, pins {}", links, i));
      if (links == 1 && i == 2) continue;  // nothing moves
      expect_same_in_blocks(build_valid(arc(links, pins[i])), settings(GetParam(), 2400.0), 4);
    }
}

TEST_P(DirectMethods, ChainsInBlocksAreThoseAllAtOnceWithDragAndHeavyTips) {
  for (const int links : {100, 600, 1100}) {
    Description description = arc(links, {"first"});
    description.drag = 0.7;
    description.chains[0].last_mass = 300.0;
    expect_same_in_blocks(build_valid(description), settings(GetParam(), 2400.0), 6);
  }
}

// Steps that fail and are halved, and some that fail at every length.
TEST_P(DirectMethods, ChainsInBlocksFailLikeThoseAllAtOnce) {
  for (const double rate : {5.0, 30.0, 60.0, 120.0}) {
    SCOPED_TRACE(rate);
    Description description = arc(700, {"first"});
    description.chains[0].last_mass = 1000.0;
    expect_same_in_blocks(build_valid(description), settings(GetParam(), rate), 4);
  }
}

TEST_P(DirectMethods, ChainsWithABrokenLinkGoOn) {
  Built built = build_valid(arc(700, {"first"}));
  for (const std::size_t broken : {0U, 1U, 256U, 350U, 699U}) {
    State state = built.start;
    state.broken_at[broken] = 0.0;
    expect_same_in_blocks({built.model, state, {}}, settings(GetParam(), 2400.0), 4);
  }
}

// What a stepper keeps of its last step must not outlive the state that the step came to.
TEST_P(DirectMethods, StepsKnowNothingOfStepsThatDoNotCount) {
  Description net;
  SheetSpec sheet;
  sheet.name = "net";
  sheet.rows = sheet.columns = 4;
  sheet.to = {0.3, 0.0, 0.1};
  sheet.down = {0.0, -0.3, 0.1};
  sheet.pinned = {"top-left"};
  net.sheets = {sheet};
  for (const Description& description : {arc(40, {"first"}), arc(5, {"first"}), net}) {
    const Built built = build_valid(description);
    const Method& method = method_called(GetParam());
    const auto loaded = [&](const State& state) {
      std::unique_ptr<Stepper> stepper =
          method.make(built.model, complete_settings(settings(GetParam(), 1000.0)), {});
      stepper->load(state);
      return stepper;
    };
    const auto step = [](Stepper& stepper, double h) {
      return stepper.step(h, stepper.store().time + h).status;
    };
    const double h = 1e-3, little = 1e-9;
    const auto step_from = [&](const State& state, double length) {
      const std::unique_ptr<Stepper> stepper = loaded(state);
      EXPECT_EQ(step(*stepper, length), StepStatus::done);
      return stepper->store();
    };
    const auto expect_step_to = [&](Stepper& stepper, const State& next, double length, const char* after) {
      EXPECT_EQ(step(stepper, length), StepStatus::done) << after;
      EXPECT_EQ(state_hash(stepper.store()), state_hash(next)) << after;
      EXPECT_EQ(stepper.store().tension, next.tension) << after;
    };
    const State first = step_from(built.start, h), second = step_from(first, h);
    const std::unique_ptr<Stepper> going = loaded(built.start);
    expect_step_to(*going, first, h, "being made");
    expect_step_to(*going, second, h, "a step");
    going->undo();
    expect_step_to(*going, second, h, "a step taken back");
    going->load(built.start);
    expect_step_to(*going, first, h, "another state");
    State flung = first;
    for (std::size_t i = 1; i < flung.velocity.size(); i += 2) flung.velocity.set(i, {1e4, -1e4, 1e4});
    going->load(flung);
    EXPECT_NE(step(*going, 1.0), StepStatus::done);
    EXPECT_EQ(state_hash(going->store()), state_hash(flung)) << "a step that failed leaves the state";
    expect_step_to(*going, step_from(flung, little), little, "a step that failed");
  }
}

TEST(Rattle, OfOrderFourTakesChainsInBlocksToo) {
  Settings how = settings("rattle", 2400.0);
  how.values["order"] = std::string("4");
  for (const int links : {20, 513, 800}) expect_same_in_blocks(build_valid(arc(links, {"first"})), how, 4);
}

// The third part of a step of order 4 ends when the step does, not where the sum of its parts comes to.
TEST(Rattle, OfOrderFourHasDrivenPinsWhereTheStepEnds) {
  Description description = level_chain(4, 0.1);
  description.chains[0].first_motion.sinusoid = SinusoidSpec{{0.0, 0.1, 0.0}, 12.0, 0.3};
  const Built built = build_valid(description);
  Settings how = settings("rattle", 700.0);
  how.values["order"] = std::string("4");
  taut::Run run(built.model, built.start, how);
  const DrivenPin& pin = built.model.driven_pins.at(0);
  while (run.steps() < 200 && run.step())
    EXPECT_EQ(run.state().position.at(pin.mass), position_at(pin.motion, run.state().time)) << run.steps();
  EXPECT_EQ(run.failure(), "");
}

// A step that can't be solved leaves the state as it was and names the link.
TEST(Guard, FailureKeepsTheStateAndNamesTheLink) {
  Description description = level_chain(4, 0.1);
  description.chains[0].pinned = {"first", "last"};
  description.chains[0].last_motion.path = {{0.0, {0.4, 0.0, 0.0}}, {1.0, {0.8, 0.0, 0.0}}};
  const Built built = build_valid(description);
  for (const char* method : {"rattle", "newton"}) {
    taut::Run run(built.model, built.start, settings(method, 100.0));
    while (run.steps() < 100 && run.step()) {
    }
    EXPECT_EQ(run.report().end, RunEnd::step_failed) << "no chain reaches pins farther apart than it is long";
    EXPECT_TRUE(all_finite(run.state()));
    const std::string sentence = run.failure();
    EXPECT_NE(sentence.find("rope."), std::string::npos) << sentence;
  }
}

}  // namespace
}  // namespace taut::test
