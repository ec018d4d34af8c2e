// Every thing that can be wrong with a description, and how it is named.

#include <functional>
#include <limits>

#include "physics/fixtures.h"

namespace taut::test {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// One entry of everything, with nothing wrong.
Description everything() {
  Description description = pendulum();
  ChainSpec chain;
  chain.name = "rope";
  chain.to = {1.0, 0.0, 0.0};
  chain.links = 4;
  chain.pinned = {"first"};
  description.chains = {chain};
  SheetSpec sheet;
  sheet.name = "cloth";
  sheet.rows = 3;
  sheet.columns = 7;
  sheet.from = {0.0, 0.0, 2.0};
  sheet.to = {1.0, 0.0, 2.0};
  sheet.down = {0.0, -1.0, 0.0};
  sheet.hooks.every = 3;
  description.sheets = {sheet};
  description.loads = {LoadSpec{{"bob"}, {0.0, -1.0, 0.0}, 0.0, 1.0}};
  description.planes = {PlaneSpec{{0.0, -5.0, 0.0}, Vec3::UnitY(), 0.5}};
  return description;
}

struct Mistake {
  std::string label;
  std::function<void(Description&)> make;
  std::string section;
  std::string key;
  std::string message;  // part of it
};

void PrintTo(const Mistake& mistake, std::ostream* out) {
  *out << mistake.label;
}

class OneMistake : public ::testing::TestWithParam<Mistake> {};

TEST_P(OneMistake, IsTheOnlyProblemAndNamesItsPlace) {
  const Mistake& mistake = GetParam();
  Description description = everything();
  mistake.make(description);
  const std::vector<Problem> problems = build(description).problems;
  ASSERT_EQ(problems.size(), 1U) << (problems.empty() ? "" : problems.back().message);
  EXPECT_EQ(problems[0].section, mistake.section);
  EXPECT_EQ(problems[0].key, mistake.key);
  EXPECT_NE(problems[0].message.find(mistake.message), std::string::npos) << problems[0].message;
}

using D = Description;

std::vector<Mistake> mistakes_of_numbers() {
  return {
      {"gravity", [](D& d) { d.gravity.y() = not_a_number; }, "world", "gravity", "finite"},
      {"drag", [](D& d) { d.drag = -1.0; }, "world", "drag", "drag must be 0 1/s or more, not -1"},
      {"drag_nan", [](D& d) { d.drag = not_a_number; }, "world", "drag", "not nan"},
      {"mass_zero", [](D& d) { d.masses[1].mass = 0.0; }, "mass", "mass", "mass must be above 0 kg, not 0"},
      {"mass_negative", [](D& d) { d.masses[1].mass = -2.0; }, "mass", "mass", "not -2"},
      {"mass_infinite", [](D& d) { d.masses[1].mass = infinity; }, "mass", "mass", "not inf"},
      {"position", [](D& d) { d.masses[1].position.x() = not_a_number; }, "mass", "position", "finite"},
      {"velocity", [](D& d) { d.masses[1].velocity.z() = infinity; }, "mass", "velocity", "finite"},
      {"length", [](D& d) { d.links[0].length = 0.0; }, "link", "length", "length must be above 0 m"},
      {"chain_links", [](D& d) { d.chains[0].links = 0; }, "chain", "links",
       "links must be 1 or more, not 0"},
      {"chain_mass", [](D& d) { d.chains[0].mass = not_a_number; }, "chain", "mass",
       "mass must be above 0 kg"},
      {"chain_length", [](D& d) { d.chains[0].length = -1.0; }, "chain", "length", "0 m or more"},
      {"chain_last_mass", [](D& d) { d.chains[0].last_mass = -1.0; }, "chain", "last_mass", "0 kg or more"},
      {"chain_from", [](D& d) { d.chains[0].from.y() = infinity; }, "chain", "from", "finite"},
      {"chain_point", [](D& d) { d.chains[0].to = d.chains[0].from; }, "chain", "to", "same point"},
      {"sheet_rows", [](D& d) { d.sheets[0].rows = 1; }, "sheet", "rows", "2 or more, not 1"},
      {"sheet_mass", [](D& d) { d.sheets[0].mass = 0.0; }, "sheet", "mass", "above 0 kg"},
      {"sheet_line",
       [](D& d) {
         d.sheets[0].down = {2.0, 0.0, 0.0};
       },
       "sheet", "down", "not a line"},
      {"sheet_fullness", [](D& d) { d.sheets[0].fullness = 0.9; }, "sheet", "fullness", "1 or more, not 0.9"},
      {"sheet_fullness_nan", [](D& d) { d.sheets[0].fullness = infinity; }, "sheet", "fullness", "not inf"},
      {"load_force", [](D& d) { d.loads[0].force.x() = not_a_number; }, "load", "force", "finite"},
      {"load_from", [](D& d) { d.loads[0].from = -0.5; }, "load", "from", "0 s or more"},
      {"load_to",
       [](D& d) {
         d.loads[0] = {{"bob"}, {0, 1, 0}, 2.0, 1.0};
       },
       "load", "to", "before"},
      {"plane_normal", [](D& d) { d.planes[0].normal = Vec3::Zero(); }, "plane", "normal", "not be zero"},
      {"plane_friction", [](D& d) { d.planes[0].friction = -0.1; }, "plane", "friction", "0"},
      {"plane_point", [](D& d) { d.planes[0].point.x() = infinity; }, "plane", "point", "finite"},
      {"plane_restitution", [](D& d) { d.planes[0].restitution = 1.5; }, "plane", "restitution",
       "from 0 to 1"},
      {"sphere_radius",
       [](D& d) {
         d.spheres = {SphereSpec{Vec3::Zero(), 0.0, 0.5, 0.0}};
       },
       "sphere", "radius", "above 0 m"},
      {"capsule_point",
       [](D& d) {
         d.capsules = {CapsuleSpec{Vec3::Zero(), Vec3::Zero(), 1.0, 0.5, 0.0}};
       },
       "capsule", "to", "write a [[sphere]]"},
      {"box_size",
       [](D& d) {
         d.boxes = {BoxSpec{Vec3::Zero(), Vec3(1.0, -1.0, 1.0), Vec3::Zero(), 0.5, 0.0}};
       },
       "box", "size", "above 0 m"},
      {"wind_time", [](D& d) { d.wind.emplace().gust_time = 0.0; }, "wind", "gust_time", "above 0 s"},
      {"mass_radius", [](D& d) { d.masses[1].radius = -1.0; }, "mass", "radius", "0 m or more"},
  };
}

std::vector<Mistake> mistakes_of_link_properties() {
  const auto of_link = [](auto change) { return [change](D& d) { change(d.links[0].properties); }; };
  return {
      {"stiffness", of_link([](LinkProperties& p) { p.stiffness = -1.0; }), "link", "stiffness",
       "above 0 N/m"},
      {"damping_negative", of_link([](LinkProperties& p) {
         p = {10.0, -1.0, {}, {}};
       }),
       "link", "damping", "0 N s/m or more"},
      {"damping_rigid", of_link([](LinkProperties& p) { p.damping = 1.0; }), "link", "damping",
       "needs a stiffness"},
      {"break_stretch_one", of_link([](LinkProperties& p) { p.break_stretch = 1.0; }), "link",
       "break_stretch", "above 1, not 1"},
      {"break_stretch_nan", of_link([](LinkProperties& p) { p.break_stretch = not_a_number; }), "link",
       "break_stretch", "not nan"},
      {"break_tension", of_link([](LinkProperties& p) { p.break_tension = 0.0; }), "link", "break_tension",
       "above 0 N"},
      {"chain_stretch", [](D& d) { d.chains[0].properties.break_stretch = 0.5; }, "chain", "break_stretch",
       "not 0.5"},
      {"diagonals",
       [](D& d) {
         d.sheets[0].diagonals = LinkProperties{-5.0, 0.0, {}, {}};
       },
       "sheet", "diagonals.stiffness", "-5"},
      {"skip_one",
       [](D& d) {
         d.sheets[0].skip_one = LinkProperties{{}, 2.0, {}, {}};
       },
       "sheet", "skip_one.damping", "needs a stiffness"},
  };
}

std::vector<Mistake> mistakes_of_names() {
  const auto rename = [](std::string name) { return [name](D& d) { d.sheets[0].name = name; }; };
  return {
      {"empty", rename(""), "sheet", "name", "empty"},
      {"dot", rename("a.b"), "sheet", "name", "must not contain a dot"},
      {"star", rename("a*"), "sheet", "name", "must not contain"},
      {"space", rename("a b"), "sheet", "name", "must not contain"},
      {"taken", rename("rope"), "sheet", "name", "\"rope\" is taken by [[chain]] number 1"},
      {"missing_a", [](D& d) { d.links[0].a = "hok"; }, "link", "a", "no mass is named \"hok\""},
      {"missing_b", [](D& d) { d.links[0].b = "x"; }, "link", "b", "no mass is named \"x\""},
      {"to_itself", [](D& d) { d.links[0].b = "hook"; }, "link", "b", "\"hook\" to itself"},
      {"coincident", [](D& d) { d.masses[1].position = d.masses[0].position; }, "link", "b", "same point"},
      {"load_mass", [](D& d) { d.loads[0].masses = {"rope.9"}; }, "load", "masses",
       "no mass is named \"rope.9\""},
      {"load_pattern", [](D& d) { d.loads[0].masses = {"cloth.*"}; }, "load", "masses",
       "no mass is named \"cloth.*\""},
      {"chain_end", [](D& d) { d.chains[0].pinned = {"frist"}; }, "chain", "pinned", "not \"frist\""},
      {"sheet_edge", [](D& d) { d.sheets[0].pinned = {"upper"}; }, "sheet", "pinned", "not \"upper\""},
  };
}

std::vector<Mistake> mistakes_of_motions_and_hooks() {
  return {
      {"free_mass", [](D& d) { d.masses[1].motion.sinusoid = SinusoidSpec{}; }, "mass", "motion",
       "only for a pinned mass"},
      {"free_chain_end",
       [](D& d) {
         d.chains[0].last_motion.path = {{0.0, {1, 0, 0}}};
       },
       "chain", "last_motion", "only for a pinned"},
      {"path_and_sinusoid",
       [](D& d) {
         d.masses[0].motion = {SinusoidSpec{}, {{0.0, {0, 0, 0}}}, {}};
       },
       "mass", "motion", "only one of them"},
      {"frequency",
       [](D& d) {
         d.masses[0].motion.sinusoid = SinusoidSpec{{0, 1, 0}, not_a_number, 0.0};
       },
       "mass", "motion", "finite"},
      {"amplitude",
       [](D& d) {
         d.masses[0].motion.sinusoid = SinusoidSpec{{0, infinity, 0}, 1.0, 0.0};
       },
       "mass", "motion", "finite"},
      {"times",
       [](D& d) {
         d.masses[0].motion.path = {{0.0, {0, 0, 0}}, {0.0, {0, 1, 0}}};
       },
       "mass", "motion", "times must increase"},
      {"knot",
       [](D& d) {
         d.masses[0].motion.path = {{0.0, {0, not_a_number, 0}}};
       },
       "mass", "motion", "finite"},
      {"hooks_negative", [](D& d) { d.sheets[0].hooks.every = -1; }, "sheet", "hooks", "0 or more, not -1"},
      {"hooks_divide", [](D& d) { d.sheets[0].hooks.every = 4; }, "sheet", "hooks",
       "hooks.every = 4 does not divide columns − 1 = 6"},
      {"hooks_pleat",
       [](D& d) {
         d.sheets[0].hooks.every = 2;
         d.sheets[0].fullness = 1.5;
       },
       "sheet", "hooks", "at least 3 columns"},
      {"draw_alone",
       [](D& d) {
         d.sheets[0].hooks = {0, {{0.0, 1.0}}};
       },
       "sheet", "hooks", "needs hooks.every"},
      {"draw_times",
       [](D& d) {
         d.sheets[0].hooks.draw = {{1.0, 1.0}, {0.5, 1.0}};
       },
       "sheet", "hooks", "times must increase"},
      {"draw_zero",
       [](D& d) {
         d.sheets[0].hooks.draw = {{0.0, 0.0}};
       },
       "sheet", "hooks", "above 0"},
      {"draw_too_wide",
       [](D& d) {
         d.sheets[0].hooks.draw = {{0.0, 1.1}};
       },
       "sheet", "hooks", "at most the fullness 1"},
  };
}

// Limits between the pendulum's hook and bob and a third mass off their line.
void add_limits(D& d) {
  MassSpec side = d.masses[1];
  side.name = "side";
  side.position = {0.5, 1.0, 0.0};
  MassSpec tip = side;
  tip.name = "tip";
  tip.position = {1.0, 0.0, 1.0};
  d.masses.push_back(side);
  d.masses.push_back(tip);
  d.angles = {AngleSpec{{"hook", "bob", "side"}, 10.0, 170.0, 0.0}};
  d.hinges = {HingeSpec{{"hook", "bob", "side"}, {"bob", "tip"}, -150.0, 150.0, 0.0}};
  d.cones = {ConeSpec{{"hook", "bob", "side"}, {"bob", "tip"}, {0.0, 0.0, 1.0}, 30.0, 0.0}};
  RagdollSpec doll;
  doll.name = "doll";
  d.ragdolls = {doll};
}

std::vector<Mistake> mistakes_of_limits() {
  const auto with = [](auto change) {
    return [change](D& d) {
      add_limits(d);
      change(d);
    };
  };
  return {
      {"none_here", with([](D& d) { d.drag = -1.0; }), "world", "drag", "drag"},
      {"angle_count", with([](D& d) { d.angles[0].masses.pop_back(); }), "angle", "masses",
       "must name 3 masses, not 2"},
      {"angle_order", with([](D& d) { d.angles[0].max = 5.0; }), "angle", "min",
       "min = 10 degrees is above max = 5 degrees"},
      {"angle_range", with([](D& d) { d.angles[0].max = 190.0; }), "angle", "max", "from 0 to 180 degrees"},
      {"angle_name", with([](D& d) { d.angles[0].masses[2] = "sid"; }), "angle", "masses",
       "no mass is named \"sid\""},
      {"angle_twice", with([](D& d) { d.angles[0].masses[2] = "bob"; }), "angle", "masses",
       "at the same point"},
      {"angle_start", with([](D& d) { d.angles[0].max = 45.0; }), "angle", "max",
       "at the start the angle is 63.43 degrees, outside its range of 10 to 45"},
      {"angle_soft", with([](D& d) { d.angles[0].compliance = -1.0; }), "angle", "compliance", "or more"},
      {"hinge_range", with([](D& d) { d.hinges[0].min = -200.0; }), "hinge", "min",
       "from -180 to 180 degrees"},
      {"hinge_axis", with([](D& d) { d.hinges[0].axis[1] = "bob"; }), "hinge", "axis", "at the same point"},
      {"hinge_on_axis", with([](D& d) { d.hinges[0].masses[2] = "tip"; }), "hinge", "masses",
       "lies on the hinge's axis"},
      {"hinge_start", with([](D& d) { d.hinges[0].max = 90.0; }), "hinge", "max",
       "outside its range of -150 to 90"},
      {"cone_frame", with([](D& d) { d.cones[0].frame[2] = "hook"; }), "cone", "frame", "on one line"},
      {"cone_limb", with([](D& d) { d.cones[0].limb[1] = "bob"; }), "cone", "limb", "at the same point"},
      {"cone_axis", with([](D& d) { d.cones[0].axis = Vec3::Zero(); }), "cone", "axis", "must not be zero"},
      {"cone_start", with([](D& d) {
         d.cones[0].axis = {1.0, 0.0, 0.0};
       }),
       "cone", "half_angle", "at the start the angle is 90 degrees"},
      {"doll_height", with([](D& d) { d.ragdolls[0].height = 0.0; }), "ragdoll", "height", "above 0 m"},
      {"doll_range", with([](D& d) {
         d.ragdolls[0].ranges.knee = {-10.0, -20.0};
       }),
       "ragdoll", "ranges.knee", "begins above its end"},
      {"doll_handle", with([](D& d) { d.ragdolls[0].pinned = {"nose"}; }), "ragdoll", "pinned",
       "not \"nose\""},
      {"doll_name", with([](D& d) { d.ragdolls[0].name = "rope"; }), "ragdoll", "name", "is taken by"},
  };
}

std::string mistake_name(const ::testing::TestParamInfo<Mistake>& info) {
  return info.param.label;
}

INSTANTIATE_TEST_SUITE_P(Numbers, OneMistake, ::testing::ValuesIn(mistakes_of_numbers()), mistake_name);
INSTANTIATE_TEST_SUITE_P(Properties, OneMistake, ::testing::ValuesIn(mistakes_of_link_properties()),
                         mistake_name);
INSTANTIATE_TEST_SUITE_P(Names, OneMistake, ::testing::ValuesIn(mistakes_of_names()), mistake_name);
INSTANTIATE_TEST_SUITE_P(Limits, OneMistake, ::testing::ValuesIn(mistakes_of_limits()), mistake_name);
INSTANTIATE_TEST_SUITE_P(Motions, OneMistake, ::testing::ValuesIn(mistakes_of_motions_and_hooks()),
                         mistake_name);

TEST(Problems, NothingIsWrongWithEverything) {
  EXPECT_TRUE(build(everything()).problems.empty());
}

TEST(Problems, AllAreReportedAtOnceWithTheirIndices) {
  Description description = everything();
  description.drag = -1.0;
  description.masses[1].mass = -1.0;
  MassSpec third = description.masses[1];
  third.name = "third";
  third.mass = 1.0;
  third.position.x() = not_a_number;
  description.masses.push_back(third);
  const std::vector<Problem> problems = build(description).problems;
  ASSERT_EQ(problems.size(), 3U);
  EXPECT_EQ(problems[0].section, "world");
  EXPECT_EQ(problems[1].index, 1U);
  EXPECT_EQ(problems[2].index, 2U);
}

TEST(Problems, MissingMassSuggestsTheNearestName) {
  Description description = everything();
  description.links[0].a = "hok";
  EXPECT_EQ(build(description).problems.at(0).suggestion, "hook");
  description.links[0].a = "elephant";
  EXPECT_EQ(build(description).problems.at(0).suggestion, "");
  description = everything();
  description.loads[0].masses = {"rope.7"};
  EXPECT_EQ(build(description).problems.at(0).suggestion.substr(0, 5), "rope.");
}

TEST(Problems, SheetThatTheMachineCannotHoldIsRefusedWithTheEstimate) {
  Description description;
  SheetSpec sheet;
  sheet.name = "cloth";
  sheet.rows = sheet.columns = 9'000'000;
  sheet.to = {1.0, 0.0, 0.0};
  sheet.down = {0.0, -1.0, 0.0};
  description.sheets = {sheet};
  const std::vector<Problem> problems = build(description).problems;
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].section, "sheet");
  EXPECT_NE(problems[0].message.find("8.1e+13 masses and 1.62e+14 links need about"), std::string::npos)
      << problems[0].message;
  EXPECT_NE(problems[0].message.find("PB; this machine has"), std::string::npos) << problems[0].message;
}

TEST(Problems, ChainsTogetherMustFitTheMemory) {
  Description description;
  for (int i = 0; i < 6; ++i) {
    ChainSpec chain;
    chain.name = "rope" + std::to_string(i);
    chain.to = {1.0, 0.0, 0.0};
    chain.links = 2'000'000'000;
    description.chains.push_back(chain);
  }
  const std::vector<Problem> problems = build(description).problems;
  ASSERT_FALSE(problems.empty()) << "8 TB of chains";
  EXPECT_EQ(problems.back().section, "chain");
  EXPECT_EQ(problems.back().index, 5U);
  EXPECT_EQ(problems.back().key, "links");
}

}  // namespace
}  // namespace taut::test
