#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scene_errors.h"

// All errors of a scene at once, whatever part of it they are in, and as data.

namespace taut {
namespace {

// What is wrong in every part of it, each in a line of its own.
std::string wrong_everywhere(const std::string& mass) {
  return "[world]\ndrga = 1.0\n"                                                       // 1
         "[camera]\neye = [0, 0, 0]\ntarget = [0, 0, 0]\nfollow = \"rope.11\"\n"       // 3
         "[look]\ntrails = [\"rope.3\", \"rpoe.3\"]\nspeed = [[1, 2], [1, 3]]\n"       // 7
         "[[chain]]\nname = \"rope\"\nfrom = [0, 1, 0]\nto = [1, 1, 0]\nlinks = 10\n"  // 10
         "mass = " +
         mass +
         "\n"                                                                                    // 15
         "[[link]]\na = \"rope.0\"\nb = \"rope.99\"\n"                                           // 16
         "[[load]]\nmasses = [\"rope.*\", \"sheet.*\"]\nforce = [0, 1, 0]\nfrom = 0\nto = 1\n";  // 19
}

std::vector<Diagnostic> diagnostics_of(const std::string& text, const SceneOverrides& overrides = {}) {
  try {
    parse_scene(text, "f.toml", overrides);
  } catch (const BadScene& problem) {
    return problem.errors();
  }
  return {};
}

std::vector<std::string> places_and_keys(const std::vector<Diagnostic>& diagnostics) {
  std::vector<std::string> all;
  for (const Diagnostic& diagnostic : diagnostics)
    all.push_back(fmt::format("{} {}", diagnostic.line, diagnostic.key));
  return all;
}

using Texts = std::vector<std::string>;

TEST(AllErrors, OfASceneWhoseMassesCanBeBuilt) {
  const std::vector<Diagnostic> errors = diagnostics_of(wrong_everywhere("1"));
  EXPECT_EQ(places_and_keys(errors),
            (Texts{"2 world.drga", "4 camera.eye", "6 camera.follow", "8 look.trails", "9 look.speed",
                   "18 link.0.b", "20 load.0.masses"}));
}

// That a mass is negative says nothing about names.
TEST(AllErrors, OfASceneWhoseMassesCanNot) {
  const std::vector<Diagnostic> errors = diagnostics_of(wrong_everywhere("-1"));
  EXPECT_EQ(places_and_keys(errors),
            (Texts{"2 world.drga", "4 camera.eye", "6 camera.follow", "8 look.trails", "9 look.speed",
                   "15 chain.0.mass", "18 link.0.b", "20 load.0.masses"}));
  EXPECT_EQ(errors[2].hint, "did you mean \"rope.1\"?");
  EXPECT_EQ(errors[5].message, "\"mass\" must be above 0 and at most 1e12 kg, not -1");
}

// But where the names themselves are wrong, or how many there are, nothing is said of who uses them.
TEST(AllErrors, ThatOnlyFollowAreLeftOut) {
  std::string text = wrong_everywhere("1");
  text.replace(text.find("links = 10"), 10, "links = -1");
  EXPECT_EQ(places_and_keys(diagnostics_of(text)),
            (Texts{"2 world.drga", "4 camera.eye", "9 look.speed", "14 chain.0.links"}));
  text = wrong_everywhere("1");
  text.replace(text.find("name = "), 4, "nmae");
  EXPECT_EQ(places_and_keys(diagnostics_of(text)),
            (Texts{"2 world.drga", "4 camera.eye", "9 look.speed", "10 chain.0", "11 chain.0.nmae"}));
}

TEST(AllErrors, ThatAMethodRefusesStandBesideThoseOfTheCamera) {
  const std::string text =
      "[camera]\nfolow = \"b\"\n[solve]\nmethod = \"spring-explicit\"\n" + chain_with("");
  EXPECT_EQ(places_and_keys(diagnostics_of(text)), (Texts{"2 camera.folow", "4 solve.method"}));
  EXPECT_EQ(
      places_and_keys(diagnostics_of(chain_with("stifness = 9\n[solve]\nmethod = \"spring-explicit\"\n"))),
      (Texts{"5 chain.0.stifness"}))
      << "the links were meant to be elastic";
}

// The key of a change is the one that it names.
TEST(AllErrors, OfTheCommandLineNameTheirKeys) {
  const std::vector<Diagnostic> errors =
      diagnostics_of(chain_with(""), {{"world.drag=-1", "pases=3", "chain.rope.mass=0"}, {}});
  ASSERT_EQ(errors.size(), 3U);
  EXPECT_EQ(places_and_keys(errors), (Texts{"0 world.drag", "0 solve.pases", "0 chain.rope.mass"}));
  EXPECT_EQ(errors[0].origin, "--set world.drag=-1");
}

TEST(AllErrors, OfValuesWithinValuesNameTheWholePath) {
  const std::vector<Diagnostic> errors = diagnostics_of(
      chain_with("first_motion = { path = [[0, 0, 2, 0], [1, 0, \"up\", 0]], wiht = \"a\" }\n"));
  ASSERT_GE(errors.size(), 2U);
  EXPECT_EQ(errors[0].key.rfind("chain.0.first_motion", 0), 0U) << errors[0].key;
  EXPECT_EQ(errors.back().key, "chain.0.first_motion.wiht");
}

TEST(AllErrors, OfSyntaxHaveAPlaceAndNoKey) {
  const std::vector<Diagnostic> errors = diagnostics_of("[world\nduration = 1\n");
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].line, 1U);
  EXPECT_EQ(errors[0].key, "");
}

}  // namespace
}  // namespace taut
