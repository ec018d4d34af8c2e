#include <gtest/gtest.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>

#include "program.h"

// Every scene that can't be read ends with exit status 2, a message that says what is wrong, and nothing
// written.

namespace taut::testing {
namespace {

struct BadScene {
  std::string name;
  std::string text;
  std::string said;      ///< part of the message
  std::size_t more = 0;  ///< letters behind the text, written when it is tried: this program starts often
};

void PrintTo(const BadScene& scene, std::ostream* out) {
  *out << scene.name;
}

class BadSceneTest : public ::testing::TestWithParam<BadScene> {};

std::string replaced(const std::string& from, const std::string& to) {
  std::string text = small_scene();
  return text.replace(text.find(from), from.size(), to);
}

std::string deep_key() {
  std::string key = "a";
  for (int i = 1; i < 60'000; ++i) key += ".a";
  return key + " = 1\n";
}

// A level sheet of four cells with faces, and what else there is.
std::string faces_scene(const std::string& faces, const std::string& more = "") {
  return "[[sheet]]\nname = \"cloth\"\nrows = 3\ncolumns = 3\nfrom = [0, 1, 0]\nto = [1, 1, 0]\n"
         "down = [0, 0, 1]\nfaces = " +
         faces + "\n" + more;
}

TEST_P(BadSceneTest, EndsWithStatus2AndNothingWritten) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("bad.toml", GetParam().text + std::string(GetParam().more, 'x'));
  for (const std::string verb : {"render", "check"}) {
    std::vector<std::string> words{verb, scene};
    if (verb == "render") words.insert(words.end(), {"-o", folder / "frames", "--film", folder / "film.mp4"});
    const Ran ran = taut(words);
    EXPECT_EQ(ran.status, 2) << verb << ": " << ran.err;
    EXPECT_NE(ran.err.find(GetParam().said), std::string::npos) << verb << ": " << ran.err;
    EXPECT_EQ(ran.out, "") << verb;
    EXPECT_LT(ran.err.size(), 4000U) << verb << ": one clear message";
    EXPECT_EQ(folder.entries(), 1U) << verb << ": nothing but the scene itself";
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, BadSceneTest,
    ::testing::Values(
        BadScene{"Empty", "", "bad.toml"}, BadScene{"SyntaxError", "[world\nduration = 1\n", "bad.toml:1:"},
        BadScene{"UnknownKey", replaced("duration", "duratoin"), "did you mean \"duration\""},
        BadScene{"UnknownSection", replaced("[world]", "[wordl]"), "world"},
        BadScene{"DeepKey", deep_key(), "bad.toml"},
        BadScene{"TooLarge", small_scene() + "#", "8 MiB", 9 << 20},
        BadScene{"WrongType", replaced("1.0\n[solve]", "\"long\"\n[solve]"), "duration"},
        BadScene{"NotANumber", replaced("mass = 1.0", "mass = nan"), "mass"},
        BadScene{"Infinite", replaced("mass = 1.0", "mass = inf"), "mass"},
        BadScene{"NegativeMass", replaced("mass = 1.0", "mass = -1.0"), "mass"},
        BadScene{"BreakStretchOfOne", small_scene() + "break_stretch = 1.0\n", "break_stretch"},
        BadScene{"LinkToMissingMass", replaced("b = \"bob\"", "b = \"bib\""), "did you mean \"bob\""},
        BadScene{"LinkToItself", replaced("b = \"bob\"", "b = \"nail\""), "nail"},
        BadScene{"HugeSheet",
                 "[[sheet]]\nname = \"cloth\"\nrows = 9000000\ncolumns = 9000000\nfrom = [0, 1, 0]\n"
                 "to = [1, 1, 0]\ndown = [0, -1, 0]\n",
                 "this machine has"},
        BadScene{"UnknownMethod", replaced("\"xpbd\"", "\"xbpd\""), "did you mean \"xpbd\""},
        BadScene{"ParameterOutOfRange", replaced("passes = 1", "passes = -3"), "passes"},
        BadScene{"KeyOfAnotherMethod", replaced("passes = 1", "velocities = \"kept\""), "velocities"},
        BadScene{"FacesWithoutThickness", faces_scene("{ friction = 0.5 }"), "needs the key \"thickness\""},
        BadScene{"FacesOfNoThickness", faces_scene("{ thickness = 0 }"), "bad.toml:8:"},
        BadScene{"FacesTooThick", faces_scene("{ thickness = 0.3 }"), "at most half as thick"},
        BadScene{"FacesAndRadius", faces_scene("{ thickness = 0.01 }", "radius = 0.1\n"),
                 "thickness in place of a radius"},
        BadScene{
            "FacesThroughABox",
            faces_scene("{ thickness = 0.01 }", "[[box]]\ncentre = [0.4, 1, 0.3]\nsize = [0.1, 1, 0.1]\n"),
            "bad.toml:8:1: faces must not start through each other or through a solid: the [[box]] number 1 "
            "goes through the face of \"cloth."},
        BadScene{"FacesWithAMethodThatKnowsNone",
                 faces_scene("{ thickness = 0.01 }", "[solve]\nmethod = \"rattle\"\n"),
                 "has no faces that touch; these have: verlet, xpbd"},
        BadScene{"NoFrames", replaced("duration = 1.0", "duration = 0.0"), "duration"}),
    [](const auto& test) { return test.param.name; });

TEST(MissingScene, NamesTheFile) {
  const Ran ran = taut({"check", "nowhere/at-all.toml"});
  EXPECT_EQ(ran.status, 2);
  EXPECT_NE(ran.err.find("there is no scene file nowhere/at-all.toml"), std::string::npos) << ran.err;
}

TEST(MissingScene, OffersTheNearestName) {
  const Ran ran = taut({"check", "hanging-chian"});
  EXPECT_EQ(ran.status, 2);
  EXPECT_NE(ran.err.find("did you mean \"hanging-chain\"?"), std::string::npos) << ran.err;
}

TEST(MissingScene, AFolderIsNoScene) {
  const TemporaryFolder folder;
  const Ran ran = taut({"check", folder.path().string() + "/"});
  EXPECT_EQ(ran.status, 2);
  EXPECT_NE(ran.err.find("is a folder"), std::string::npos) << ran.err;
}

// As data, on standard output, with every verb that has --json; the words still go to standard error.
TEST(BadScenes, AreTellableAsJson) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("bad.toml", replaced("duration", "duratoin"));
  for (const std::string verb : {"check", "render", "sag"}) {
    const Ran ran = taut({verb, scene, "--json"}, {}, folder.path());
    EXPECT_EQ(ran.status, 2) << verb;
    const nlohmann::json json = nlohmann::json::parse(ran.out);
    const nlohmann::json errors = (verb == "check" ? json[0] : json)["errors"];
    ASSERT_EQ(errors.size(), 1U) << verb;
    EXPECT_EQ(errors[0]["file"], scene);
    EXPECT_EQ(errors[0]["line"], 3);
    EXPECT_EQ(errors[0]["column"], 1);
    EXPECT_EQ(errors[0]["key"], "world.duratoin");
    EXPECT_EQ(errors[0]["message"], "unknown key \"duratoin\" in [world]");
    EXPECT_EQ(errors[0]["hint"], "did you mean \"duration\" (s)?");
    EXPECT_NE(ran.err.find("did you mean"), std::string::npos) << ran.err;
    EXPECT_EQ(folder.entries(), 1U) << verb << ": nothing but the scene itself";
  }
  const Ran ran = taut({"render", "nowhere.toml", "--json"}, {}, folder.path());
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(nlohmann::json::parse(ran.out)["errors"][0]["message"], "there is no scene file nowhere.toml");
}

// What stands in the way of its pictures and of its run, beside each other.
TEST(BadScenes, ToldAtOnceByCheck) {
  const TemporaryFolder folder;
  const std::string scene = folder.write(
      "bad.toml", replaced("method = \"xpbd\"\nsteps_per_second = 240\npasses = 1", "method = \"euler\"") +
                      "[look]\ncolour_by = \"tension\"\nexact = true\n[wind]\nvelocity = [1, 0, 0]\n");
  const Ran ran = taut({"check", scene});
  EXPECT_EQ(ran.status, 2);
  EXPECT_NE(ran.err.find("knows no tensions to colour by"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace taut::testing
