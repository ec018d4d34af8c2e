#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "program.h"

// Whatever word of a command line is mistyped, the message has the nearest one there is.

namespace taut::testing {
namespace {

struct Mistyped {
  std::string name;
  std::vector<std::string> words;
  std::string meant;
};

void PrintTo(const Mistyped& mistyped, std::ostream* out) {
  *out << mistyped.name;
}

class MistypedTest : public ::testing::TestWithParam<Mistyped> {};

TEST_P(MistypedTest, HasTheNearestName) {
  const TemporaryFolder folder;
  folder.write("small.toml", small_scene());
  const Ran ran = taut(GetParam().words, {}, folder.path());
  EXPECT_EQ(ran.status, 2) << ran.err;
  EXPECT_EQ(ran.out, "");
  EXPECT_NE(ran.err.find("did you mean \"" + GetParam().meant + "\""), std::string::npos) << ran.err;
  EXPECT_EQ(folder.entries(), 1U) << "nothing but the scene itself";
}

INSTANTIATE_TEST_SUITE_P(
    Words, MistypedTest,
    ::testing::Values(
        Mistyped{"Verb", {"verfy", "out"}, "verify"}, Mistyped{"VerbAlone", {"nwe"}, "new"},
        Mistyped{"FlagOfTheProgram", {"--verison"}, "--version"},
        Mistyped{"FlagOfAVerb", {"check", "small.toml", "--expalin"}, "--explain"},
        Mistyped{"FlagOfNew", {"new", "rope", "--knid", "chain"}, "--kind"},
        Mistyped{"Scene", {"check", "curtian"}, "curtain"},
        Mistyped{"SceneFile", {"check", "smal.toml"}, "small.toml"},
        Mistyped{"SceneFileInAFolder", {"check", "./smlal.toml"}, "./small.toml"},
        Mistyped{"Method", {"render", "small.toml", "--method", "ratle"}, "rattle"},
        Mistyped{"MethodOfAComparison", {"compare", "small.toml", "--methods", "eulr,xpbd"}, "euler"},
        Mistyped{"MethodOfAChart", {"chart", "small.toml", "--methods", "ratle"}, "rattle"},
        Mistyped{"MethodOfAMap", {"stability", "--methods", "ratle"}, "rattle"},
        Mistyped{"Parameter", {"compare", "small.toml", "--methods", "xpbd:pases=4,euler"}, "passes"},
        Mistyped{"Key", {"render", "small.toml", "--set", "world.gravty=1"}, "gravity"},
        Mistyped{"ValueOfAKey", {"render", "small.toml", "--set", "look.theme=dakr"}, "dark"},
        Mistyped{"Quality", {"render", "small.toml", "--quality", "fien"}, "fine"},
        Mistyped{"Colouring", {"sag", "small.toml", "--colour", "tenson"}, "tension"},
        Mistyped{"BackEnd", {"render", "small.toml", "--gl", "osmea"}, "osmesa"},
        Mistyped{"VectorInstructions", {"render", "small.toml", "--simd", "saclar"}, "scalar"},
        Mistyped{"Table", {"export", "small.toml", "--table", "lniks"}, "links"},
        Mistyped{"Format", {"export", "small.toml", "--format", "cvs"}, "csv"},
        Mistyped{"Error", {"chart", "small.toml", "--errors", "trajectry"}, "trajectory"},
        Mistyped{"Axes", {"stability", "small.toml", "--axes", "step,stifness"}, "step,stiffness"},
        Mistyped{"List", {"list", "scnes"}, "scenes"},
        Mistyped{"Kind", {"new", "a", "--kind", "shet"}, "sheet"},
        Mistyped{"SceneToCopy", {"new", "a", "--like", "curtian"}, "curtain"},
        Mistyped{"WhatToGenerate", {"generate", "mna"}, "man"},
        Mistyped{"Shell", {"generate", "completions", "bsh"}, "bash"},
        Mistyped{"WordsOf", {"generate", "words", "sceens"}, "scenes"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace taut::testing
