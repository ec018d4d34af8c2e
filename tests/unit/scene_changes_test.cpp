#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/failure.h"
#include "scene/scene.h"

namespace taut {
namespace {

const std::string scene_text = R"([world]
drag = 0.1
[solve]
method = "euler"
passes = 7
velocities = "derived"
[[chain]]
name = "rope"
from = [0, 2, 0]
to = [2, 2, 0]
links = 4
pinned = ["first"]
[[sheet]]
name = "cloth"
rows = 3
columns = 4
from = [0, 5, 0]
to = [1, 5, 0]
down = [0, -1, 0]
[[mass]]
name = "bob"
position = [3, 0, 0]
[[link]]
a = "bob"
b = "rope.4"
)";

Scene with(const std::vector<std::string>& sets, const std::optional<std::string>& method = {}) {
  return parse_scene(scene_text, "f.toml", {sets, method});
}

std::string errors_with(const std::vector<std::string>& sets, const std::optional<std::string>& method = {},
                        const std::string& scene = scene_text) {
  try {
    parse_scene(scene, "f.toml", {sets, method});
    return {};
  } catch (const BadRequest& failure) {
    return failure.what();
  }
}

TEST(SceneChanges, SetKeysByTheirPath) {
  EXPECT_EQ(with({"world.drag=0.5"}).model.drag, 0.5);
  EXPECT_EQ(with({"world.duration=2"}).duration, 2.0) << "a key the file leaves out";
  EXPECT_FALSE(with({"look.masses=false"}).look.masses) << "a section the file leaves out";
  EXPECT_EQ(with({"world.gravity=[0, 0, -1]"}).model.gravity, Vec3(0, 0, -1));
  EXPECT_EQ(with({"title=Another one"}).title, "Another one");
}

TEST(SceneChanges, SetEntriesByNameOrNumber) {
  EXPECT_EQ(with({"sheet.cloth.rows=5"}).description.sheets[0].rows, 5);
  EXPECT_EQ(with({"sheet.0.rows=5"}).description.sheets[0].rows, 5);
  EXPECT_EQ(with({"link.0.b=rope.2"}).model.links.b.back(), 2U);
  EXPECT_EQ(with({"chain.rope.pinned.0=last"}).description.chains[0].pinned,
            (std::vector<std::string>{"last"}));
}

TEST(SceneChanges, ABareNameMeansSolve) {
  EXPECT_EQ(with({"passes=9"}).settings.number("passes"), 9.0);
  EXPECT_EQ(with({"solve.passes=9"}).settings.number("passes"), 9.0);
}

TEST(SceneChanges, TextNeedsNoQuotesButMayHaveThem) {
  EXPECT_EQ(with({"look.theme=dark"}).look.theme, Theme::dark);
  EXPECT_EQ(with({"look.theme=\"dark\""}).look.theme, Theme::dark);
  EXPECT_EQ(with({"title=3 = three"}).title, "3 = three");
  EXPECT_EQ(with({"title=1\nmethod = 2"}).title, "1\nmethod = 2") << "a value is one value, never more keys";
  EXPECT_EQ(with({"title="}).title, "f") << "empty text";
}

TEST(SceneChanges, MakeTablesOnTheWay) {
  const Scene scene = with(
      {"mass.bob.pinned=true", "mass.bob.motion.amplitude=[0, 1, 0]", "mass.bob.motion.angular_frequency=2"});
  ASSERT_TRUE(scene.description.masses[0].motion.sinusoid.has_value());
  EXPECT_EQ(scene.description.masses[0].motion.sinusoid->amplitude, Vec3(0, 1, 0));
}

TEST(SceneChanges, TheLastOneHolds) {
  EXPECT_EQ(with({"world.drag=0.5", "world.drag=0.7"}).model.drag, 0.7);
}

TEST(SceneChanges, CanRepairAFile) {
  const std::string broken = "[world]\ndrag = \"x\"\n" + scene_text.substr(scene_text.find("[[chain]]"));
  EXPECT_NE(errors_with({}, {}, broken), "");
  EXPECT_EQ(errors_with({"world.drag=0"}, {}, broken), "");
}

TEST(SceneChanges, AreNamedInErrorsInPlaceOfALine) {
  EXPECT_EQ(errors_with({"world.dragg=0.5"}),
            "--set world.dragg=0.5: unknown key \"dragg\" in [world]\n    did you mean \"drag\" (1/s)?");
  EXPECT_EQ(errors_with({"wrld.drag=0.5"}),
            "--set wrld.drag=0.5: unknown section \"wrld\"\n    did you mean [world]?");
  EXPECT_EQ(errors_with({"sheet.clth.rows=3"}),
            "--set sheet.clth.rows=3: \"sheet\" has no entry named \"clth\"\n    did you mean \"cloth\"?");
  EXPECT_EQ(errors_with({"sheet.1.rows=3"}),
            "--set sheet.1.rows=3: \"sheet\" has 1 entries, counted from 0: there is no 1");
  EXPECT_EQ(errors_with({"world.drag=fast"}),
            "--set world.drag=fast: \"drag\" must be a number in 1/s, not \"fast\"");
  EXPECT_EQ(errors_with({"world.drag=nan"}), "--set world.drag=nan: \"drag\" must be finite, not nan");
  EXPECT_EQ(errors_with({"world.drag=-1"}),
            "--set world.drag=-1: \"drag\" must be between 0 and 1e6 1/s, not -1");
  EXPECT_EQ(errors_with({"link.0.b=bop"}),
            "--set link.0.b=bop: no mass is named \"bop\"\n    did you mean \"bob\"?");
  EXPECT_EQ(errors_with({"world.drag.x=1"}),
            "--set world.drag.x=1: \"drag\" has no keys of its own, and so no \"x\"");
  EXPECT_EQ(errors_with({"load.0.from=1"}), "--set load.0.from=1: the scene has no [[load]] to change");
  EXPECT_EQ(errors_with({"drag=1"}),
            "--set drag=1: unknown key \"drag\" in [solve]\n    \"drag\" is a key of [world]");
}

TEST(SceneChanges, ThatAreNoneAreErrors) {
  EXPECT_EQ(errors_with({"world.drag"}), "--set world.drag: must be key=value, such as world.drag=0.5");
  EXPECT_EQ(errors_with({"=3"}), "--set =3: must be key=value, such as world.drag=0.5");
  EXPECT_EQ(errors_with({""}), "--set : must be key=value, such as world.drag=0.5");
  EXPECT_EQ(errors_with({"world..drag=3"}),
            "--set world..drag=3: \"world..drag\" is no dotted path of a key");
}

TEST(SceneChanges, AndTheFilesErrorsComeTogether) {
  const std::string broken = "[look]\nthem = 1\n" + scene_text;
  EXPECT_EQ(errors_with({"passe=1", "passes"}, {}, broken),
            "f.toml:2:1: unknown key \"them\" in [look]\n    them = 1\n    ^\n    did you mean \"theme\"?\n"
            "--set passes: must be key=value, such as world.drag=0.5\n"
            "--set passe=1: unknown key \"passe\" in [solve]\n    did you mean \"passes\"?");
}

TEST(SceneMethod, OfTheFileWithItsOwnKeys) {
  const Scene scene = with({});
  EXPECT_TRUE(scene.solve_given);
  EXPECT_EQ(scene.settings.method, "euler");
  EXPECT_EQ(scene.settings.number("passes"), 7.0);
  EXPECT_EQ(scene.settings.choice("velocities"), "derived");
  EXPECT_EQ(scene.settings.steps_per_second(), 60.0) << "the method's default";
}

TEST(SceneMethod, OfTheCommandLineDropsKeysOfOthers) {
  const Scene scene = with({}, "xpbd");
  EXPECT_EQ(scene.settings.method, "xpbd");
  EXPECT_EQ(scene.settings.number("passes"), 7.0) << "a key both have stays";
  EXPECT_FALSE(scene.settings.values.contains("velocities"));
  EXPECT_EQ(with({"method=xpbd"}).settings.method, "xpbd");
}

TEST(SceneMethod, OfTheCommandLineDoesNotHideTypingErrors) {
  std::string typo = scene_text;
  typo.replace(typo.find("velocities"), 10, "velocitis");
  const std::string errors = errors_with({}, "xpbd", typo);
  EXPECT_TRUE(errors.starts_with("f.toml:6:1: unknown key \"velocitis\" in [solve]\n")) << errors;
}

TEST(SceneMethod, KeysSetOnTheCommandLineMustFitIt) {
  EXPECT_EQ(errors_with({"velocities=kept"}, "xpbd"),
            "--set velocities=kept: \"velocities\" is a key of the method \"euler\", not of \"xpbd\"");
}

TEST(SceneMethod, ChoicesThatAreNumbersNeedNoQuotes) {
  EXPECT_EQ(with({"method=rattle", "order=4"}).settings.choice("order"), "4");
  EXPECT_EQ(with({"method=rattle", "order=\"4\""}).settings.choice("order"), "4");
  EXPECT_EQ(errors_with({"method=rattle", "order=3"}),
            "--set order=3: \"order\" must be \"2\" or \"4\", not \"3\"");
}

TEST(SceneMethod, ThatDoesNotExist) {
  EXPECT_EQ(errors_with({}, "eulre"),
            "--method eulre: unknown method \"eulre\"\n    did you mean \"euler\"?");
}

TEST(SceneMethod, ThatCannotDoTheSceneIsNamedPlainly) {
  const std::string errors = errors_with({"chain.rope.stiffness=100"}, "verlet");
  EXPECT_TRUE(errors.starts_with("--method verlet: method \"verlet\" has no links with stiffness")) << errors;
}

TEST(SceneMethod, WithoutSolveIsXpbdInSmallSteps) {
  const std::string plain = scene_text.substr(scene_text.find("[[chain]]"));
  const Scene scene = parse_scene(plain, "f.toml");
  EXPECT_FALSE(scene.solve_given);
  EXPECT_EQ(scene.settings.method, "xpbd");
  EXPECT_EQ(scene.settings.steps_per_second(), 600.0);
  EXPECT_EQ(scene.settings.number("passes"), 1.0);
  EXPECT_TRUE(parse_scene(plain, "f.toml", {{}, "verlet"}).solve_given);
  EXPECT_TRUE(parse_scene(plain, "f.toml", {{"passes=2"}, {}}).solve_given);
}

TEST(SceneReading, AnIntegerCountsAsANumberAndAWholeNumberAsAnInteger) {
  const Scene scene = parse_scene(
      "[world]\nduration = 2\n[[chain]]\nname = \"r\"\nfrom = [0, 1, 0]\n"
      "to = [1, 1, 0]\nlinks = 3.0\nmass = 1\n",
      "f.toml");
  EXPECT_EQ(scene.duration, 2.0);
  EXPECT_EQ(scene.description.chains[0].links, 3);
}

TEST(SceneReading, TablesMayBeWrittenInAnyOfTomlsWays) {
  const std::string head =
      "[[chain]]\nname = \"r\"\nfrom = [0, 1, 0]\nto = [1, 1, 0]\npinned = [\"first\"]\n";
  for (const char* motion : {"first_motion = { amplitude = [0, 1, 0], angular_frequency = 2 }",
                             "first_motion.amplitude = [0, 1, 0]\nfirst_motion.angular_frequency = 2",
                             "[chain.first_motion]\namplitude = [0, 1, 0]\nangular_frequency = 2"}) {
    const Scene scene = parse_scene(head + motion + "\n", "f.toml");
    ASSERT_TRUE(scene.description.chains[0].first_motion.sinusoid.has_value()) << motion;
    EXPECT_EQ(scene.description.chains[0].first_motion.sinusoid->angular_frequency, 2.0) << motion;
  }
}

}  // namespace
}  // namespace taut
