#include "scene_errors.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace taut {
namespace {

TEST(SceneErrors, ARightSceneHasNone) {
  EXPECT_EQ(errors_of(chain_with("")), "");
  EXPECT_EQ(errors_of(masses_with("")), "");
}

TEST(SceneErrors, UnknownKeyNamesTheNearestWithItsUnit) {
  EXPECT_EQ(errors_of(chain_with("last_mas = 1\n")),
            "f.toml:5:1: unknown key \"last_mas\" in [[chain]]\n"
            "    last_mas = 1\n"
            "    ^\n"
            "    did you mean \"last_mass\" (kg)?");
}

TEST(SceneErrors, UnknownKeyThatNothingIsNear) {
  EXPECT_EQ(errors_of(chain_with("  wobble = 1\n")),
            "f.toml:5:3: unknown key \"wobble\" in [[chain]]\n      wobble = 1\n      ^");
}

TEST(SceneErrors, KeyOfAnotherSectionSaysWhichOne) {
  EXPECT_EQ(errors_of(chain_with("fullness = 1\n")),
            "f.toml:5:1: unknown key \"fullness\" in [[chain]]\n    fullness = 1\n    ^\n"
            "    \"fullness\" is a key of [[sheet]]");
  EXPECT_EQ(errors_of("gravity = [0, 0, 0]\n" + chain_with("")),
            "f.toml:1:1: unknown key \"gravity\"\n    gravity = [0, 0, 0]\n    ^\n"
            "    \"gravity\" is a key of [world]");
}

TEST(SceneErrors, UnknownSection) {
  EXPECT_EQ(errors_of(chain_with("[wrld]\ndrag = 1\n")),
            "f.toml:5:2: unknown section \"wrld\"\n    [wrld]\n     ^\n    did you mean [world]?");
  EXPECT_EQ(errors_of(chain_with("[[sheets]]\n")),
            "f.toml:5:3: unknown section \"sheets\"\n    [[sheets]]\n      ^\n    did you mean [[sheet]]?");
  EXPECT_EQ(errors_of(chain_with("[\"\"]\n")), "f.toml:5:2: unknown section \"\"\n    [\"\"]\n     ^");
}

TEST(SceneErrors, OneBracketForTwo) {
  EXPECT_EQ(errors_of(chain_with("[plane]\n")),
            "f.toml:5:1: write [[plane]] in place of [plane]\n    [plane]\n    ^");
  EXPECT_EQ(errors_of(chain_with("[[world]]\n")),
            "f.toml:5:1: [world] must be a table, not a list of 1\n    [[world]]\n    ^");
}

TEST(SceneErrors, MissingKeyPointsAtTheEntry) {
  EXPECT_EQ(errors_of("\n [[chain]]\nname = \"rope\"\nfrom = [0, 2, 0]\n"),
            "f.toml:2:2: [[chain]] needs the key \"to\", or \"points\" or \"wound\" in its place\n     "
            "[[chain]]\n     ^");
}

TEST(SceneErrors, WrongTypes) {
  EXPECT_EQ(errors_of(chain_with("mass = \"heavy\"\n")),
            "f.toml:5:8: \"mass\" must be a number in kg, not \"heavy\"\n    mass = \"heavy\"\n           ^");
  EXPECT_EQ(errors_of(chain_with("links = 2.5\n")),
            "f.toml:5:9: \"links\" must be a whole number, not 2.5\n    links = 2.5\n            ^");
  EXPECT_EQ(errors_of(chain_with("pinned = \"first\"\n")),
            "f.toml:5:10: \"pinned\" must be a list of texts, not \"first\"\n    pinned = \"first\"\n"
            "             ^");
  EXPECT_EQ(errors_of(chain_with("pinned = [1]\n")),
            "f.toml:5:11: \"pinned\" must be text, not 1\n    pinned = [1]\n              ^");
  EXPECT_EQ(errors_of(chain_with("[look]\nmasses = 1\n")),
            "f.toml:6:10: \"masses\" must be true or false, not 1\n    masses = 1\n             ^");
  EXPECT_EQ(errors_of(chain_with("[world]\ngravity = [0, 1]\n")),
            "f.toml:6:11: \"gravity\" must be a list of 3 numbers in m/s², not a list of 2\n"
            "    gravity = [0, 1]\n              ^");
  EXPECT_EQ(errors_of(chain_with("[world]\nduration = 1979-05-27\n")),
            "f.toml:6:12: \"duration\" must be a number in s, not a date or time\n"
            "    duration = 1979-05-27\n               ^");
  EXPECT_EQ(errors_of("title = 3\n" + chain_with("")),
            "f.toml:1:9: \"title\" must be text, not 3\n    title = 3\n            ^");
  EXPECT_EQ(errors_of("solve = 3\n" + chain_with("")),
            "f.toml:1:9: [solve] must be a table, not 3\n    solve = 3\n            ^");
  EXPECT_EQ(errors_of("mass = [3]\n"),
            "f.toml:1:9: [[mass]] must be a table, not 3\n    mass = [3]\n            ^");
}

TEST(SceneErrors, NotFinite) {
  EXPECT_EQ(errors_of(chain_with("mass = nan\n")),
            "f.toml:5:8: \"mass\" must be finite, not nan\n    mass = nan\n           ^");
  EXPECT_EQ(errors_of(chain_with("[world]\ngravity = [0, -inf,\n\tnan]\n")),
            "f.toml:6:15: \"gravity\" must be finite, not -inf\n    gravity = [0, -inf,\n"
            "                  ^");
  EXPECT_EQ(errors_of(chain_with("links = inf\n")),
            "f.toml:5:9: \"links\" must be finite, not inf\n    links = inf\n            ^");
}

TEST(SceneErrors, OutOfRange) {
  EXPECT_EQ(errors_of(chain_with("mass = -1\n")),
            "f.toml:5:8: \"mass\" must be above 0 and at most 1e12 kg, not -1\n    mass = -1\n           ^");
  EXPECT_EQ(errors_of(chain_with("break_stretch = 1.0\n")),
            "f.toml:5:17: \"break_stretch\" must be above 1 and at most 1e6 × length, not 1\n"
            "    break_stretch = 1.0\n                    ^");
  EXPECT_EQ(errors_of(chain_with("[world]\nduration = 3601\n")),
            "f.toml:6:12: \"duration\" must be above 0 and at most 3600 s, not 3601\n"
            "    duration = 3601\n               ^");
  EXPECT_EQ(errors_of(chain_with("links = 0\n")),
            "f.toml:5:9: \"links\" must be between 1 and 1e8, not 0\n    links = 0\n            ^");
  EXPECT_EQ(errors_of(chain_with("links = 99999999999\n")),
            "f.toml:5:9: \"links\" must be between 1 and 1e8, not 99999999999\n    links = 99999999999\n"
            "            ^");
}

TEST(SceneErrors, WordsThatAreNoChoice) {
  EXPECT_EQ(errors_of(chain_with("[look]\ntheme = \"drak\"\n")),
            "f.toml:6:9: \"theme\" must be \"light\" or \"dark\", not \"drak\"\n    theme = \"drak\"\n"
            "            ^\n    did you mean \"dark\"?");
  EXPECT_EQ(errors_of(chain_with("pinned = [\"first\", \"lst\"]\n")),
            "f.toml:5:20: \"pinned\" must be \"first\" or \"last\", not \"lst\"\n"
            "    pinned = [\"first\", \"lst\"]\n                       ^\n    did you mean \"last\"?");
}

TEST(SceneErrors, Accuracy) {
  for (const char* bad : {"\"0%\"", "\"101%\"", "\"1\"", "\"-1%\"", "\"nan%\"", "\"%\"", "\"1e%\"", "0.01"})
    EXPECT_TRUE(
        errors_of(chain_with(std::string("[world]\naccuracy = ") + bad))
            .starts_with("f.toml:6:12: \"accuracy\" must be a text from above \"0%\" to \"100%\", not "))
        << bad;
  EXPECT_EQ(errors_of(chain_with("[world]\naccuracy = \"0.01%\"")), "");
}

TEST(SceneErrors, Colours) {
  EXPECT_EQ(errors_of(chain_with("[look]\nlink_colour = \"#12345\"\n")),
            "f.toml:6:15: \"link_colour\" must have six digits from 0 to f after #, as \"#cc8c33\" has, not "
            "\"#12345\"\n"
            "    link_colour = \"#12345\"\n                  ^");
  EXPECT_EQ(errors_of(chain_with("[look]\nlink_colour = [0, 2, 0]\n")),
            "f.toml:6:19: \"link_colour\" must be between 0 and 1, not 2\n    link_colour = [0, 2, 0]\n"
            "                      ^");
}

TEST(SceneErrors, Motions) {
  const std::string needs = "\"first_motion\" needs ";
  EXPECT_EQ(
      errors_of(chain_with("pinned = [\"first\"]\nfirst_motion = {}\n")),
      "f.toml:6:16: " + needs +
          "either \"amplitude\" and \"angular_frequency\", or \"path\", or \"with\"\n    first_motion = {}\n"
          "                   ^");
  const auto with_motion = [](const std::string& motion) {
    const std::string errors = errors_of(chain_with("pinned = [\"first\"]\nfirst_motion = " + motion));
    return errors.substr(0, errors.find('\n'));
  };
  EXPECT_EQ(with_motion("{ phase = 1, amplitude = [0, 0, 0] }"),
            "f.toml:6:16: " + needs + "the key \"angular_frequency\"");
  EXPECT_EQ(with_motion("{ angular_frequency = 1 }"), "f.toml:6:16: " + needs + "the key \"amplitude\"");
  EXPECT_EQ(
      with_motion("{ phase = 1, path = [[0, 0, 0, 0]] }"),
      "f.toml:6:16: " + needs + "either \"amplitude\" and \"angular_frequency\", or \"path\", or \"with\"");
  EXPECT_EQ(with_motion("{ path = [] }"), "f.toml:6:16: " + needs + "a path of at least one place");
  EXPECT_EQ(with_motion("{ path = [[0, 0, 0]] }"),
            "f.toml:6:26: \"path\" must be a list of [t, x, y, z] in s, m, m, m, not a list of 3");
  EXPECT_EQ(with_motion("{ amplitud = [0, 0, 0] }"),
            "f.toml:6:18: unknown key \"amplitud\" in \"first_motion\"");
}

TEST(SceneErrors, ExtraLinksAreTrueFalseOrATable) {
  const std::string sheet = "[[sheet]]\nname = \"s\"\nfrom = [0, 0, 0]\nto = [1, 0, 0]\ndown = [0, -1, 0]\n";
  EXPECT_EQ(errors_of(sheet + "diagonals = 3\n"),
            "f.toml:6:13: \"diagonals\" must be true, false or a table, not 3\n    diagonals = 3\n"
            "                ^");
  EXPECT_EQ(errors_of(sheet + "skip_one = { stifness = 3 }\n"),
            "f.toml:6:14: unknown key \"stifness\" in \"skip_one\"\n    skip_one = { stifness = 3 }\n"
            "                 ^\n    did you mean \"stiffness\" (N/m)?");
}

TEST(SceneErrors, ProblemsOfTheModelPointAtTheKey) {
  EXPECT_EQ(errors_of(masses_with("[[link]]\na = \"hand\"\nb = \"bop\"\n")),
            "f.toml:10:1: no mass is named \"bop\"\n    b = \"bop\"\n    ^\n    did you mean \"bob\"?");
  EXPECT_EQ(errors_of(masses_with("[[link]]\na = \"bob\"\n  b = \"bob\"\n")),
            "f.toml:10:3: a link can't join \"bob\" to itself\n      b = \"bob\"\n      ^");
  EXPECT_EQ(errors_of(masses_with("[[mass]]\nname = \"bob\"\nposition = [3, 0, 0]\n")).substr(0, 12),
            "f.toml:9:1: ");
}

TEST(SceneErrors, ProblemsOfTheModelWithoutTheirKeyPointAtTheEntry) {
  EXPECT_EQ(errors_of(masses_with("[[capsule]]\nfrom = [0, 0, 0]\nto = [0, 0, 0]\n")),
            "f.toml:10:1: from and to are the same point: write a [[sphere]]\n    to = [0, 0, 0]\n    ^");
  EXPECT_EQ(
      errors_of(masses_with("[[ragdoll]]\nname = \"doll\"\nposition = [0, 5, 0]\nranges.knee = [-90, -20]\n"))
          .substr(0, 76),
      "f.toml:8:1: left_knee starts 12 degrees outside the range of knee, -90 to -2");
}

std::string third_mass_with(const std::string& lines) {
  return masses_with("[[mass]]\nname = \"tip\"\nposition = [1, 1, 0]\n" + lines);  // starts on line 11
}

TEST(SceneErrors, OfLimitsNameTheirLineAndColumn) {
  const std::string angle = "[[angle]]\nmasses = [\"hand\", \"bob\", \"tip\"]\n";
  EXPECT_EQ(errors_of(third_mass_with(angle + "min = 90\nmax = 10\n")),
            "f.toml:13:1: min = 90 degrees is above max = 10 degrees\n    min = 90\n    ^");
  EXPECT_EQ(errors_of(third_mass_with(angle + "max = 200\n")),
            "f.toml:13:7: \"max\" must be between 0 and 180 degrees, not 200\n    max = 200\n          ^");
  EXPECT_EQ(
      errors_of(third_mass_with(angle + "max = 45\n")),
      "f.toml:13:1: at the start the angle is 90 degrees, outside its range of 0 to 45\n    max = 45\n    ^");
  EXPECT_EQ(errors_of(third_mass_with("[[angle]]\nmasses = [\"hand\", \"bob\", \"hand\", \"tip\"]\n")),
            "f.toml:12:1: masses must name 3 masses, not 4\n"
            "    masses = [\"hand\", \"bob\", \"hand\", \"tip\"]\n    ^");
  EXPECT_EQ(errors_of(third_mass_with("[[angle]]\nmasses = [\"hand\", \"bob\", \"bob\"]\n")),
            "f.toml:12:1: \"bob\" and \"bob\" are at the same point, so there is no direction\n"
            "    masses = [\"hand\", \"bob\", \"bob\"]\n    ^");
  EXPECT_EQ(errors_of(third_mass_with(
                "[[hinge]]\nmasses = [\"hand\", \"bob\", \"tip\"]\naxis = [\"bob\", \"tap\"]\n")),
            "f.toml:13:1: no mass is named \"tap\"\n    axis = [\"bob\", \"tap\"]\n    ^\n"
            "    did you mean \"tip\"?");
  EXPECT_EQ(errors_of(third_mass_with(
                "[[cone]]\nframe = [\"hand\", \"bob\", \"hand\"]\nlimb = [\"bob\", \"tip\"]\n")),
            "f.toml:12:1: the masses of the frame lie on one line, so it has no directions\n"
            "    frame = [\"hand\", \"bob\", \"hand\"]\n    ^");
}

TEST(SceneErrors, JointsThatDoNotExist) {
  EXPECT_EQ(errors_of("[[ragdoll]]\nname = \"doll\"\nposition = [0, 1, 0]\nranges = { kne = [-90, -4] }\n"),
            "f.toml:4:12: unknown key \"kne\" in \"ranges\"\n    ranges = { kne = [-90, -4] }\n"
            "               ^\n    did you mean \"knee\" (degrees)?");
}

TEST(SceneErrors, AMethodWithoutLimitsSaysWhichHaveThem) {
  const std::string scene = third_mass_with(
      "[[angle]]\nmasses = [\"hand\", \"bob\", \"tip\"]\n"
      "[solve]\nmethod = \"euler\"\n");
  EXPECT_EQ(errors_of(scene).substr(0, 108),
            "f.toml:14:1: method \"euler\" has no limits on angles; these have: verlet, xpbd, shake, rattle, "
            "dop853, newton");
}

TEST(SceneErrors, SheetsThatMemoryCannotHoldAreRefused) {
  const std::string errors = errors_of(
      "[[sheet]]\nname = \"s\"\nfrom = [0, 0, 0]\nto = [1, 0, 0]\ndown = [0, -1, 0]\nrows = "
      "9_000_000\ncolumns = "
      "9_000_000\n");
  EXPECT_TRUE(errors.starts_with("f.toml:6:1: ")) << errors;
  EXPECT_NE(errors.find("8.1e+13 masses"), std::string::npos) << errors;
}

TEST(SceneErrors, UnknownMethodNamesTheNearest) {
  EXPECT_EQ(errors_of(chain_with("[solve]\nmethod = \"xpdb\"\n")),
            "f.toml:6:10: unknown method \"xpdb\"\n    method = \"xpdb\"\n             ^\n"
            "    did you mean \"xpbd\"?");
  EXPECT_TRUE(errors_of(chain_with("[solve]\nmethod = \"simulated-annealing\"\n"))
                  .find("there are euler, verlet, ") != std::string::npos);
}

TEST(SceneErrors, ParameterOfAnotherMethodNamesItsOwner) {
  EXPECT_EQ(errors_of(chain_with("[solve]\nmethod = \"xpbd\"\nvelocities = \"kept\"\n")),
            "f.toml:7:1: \"velocities\" is a key of the method \"euler\", not of \"xpbd\"\n"
            "    velocities = \"kept\"\n    ^");
}

TEST(SceneErrors, ParameterOutOfRange) {
  EXPECT_EQ(errors_of(chain_with("[solve]\nmethod = \"xpbd\"\npasses = 0\n")),
            "f.toml:7:10: \"passes\" must be between 1 and 1e6, not 0\n    passes = 0\n             ^");
  EXPECT_EQ(errors_of(chain_with("[solve]\nmethod = \"euler\"\nvelocities = \"derivd\"\n")),
            "f.toml:7:14: \"velocities\" must be \"kept\" or \"derived\", not \"derivd\"\n"
            "    velocities = \"derivd\"\n                 ^\n    did you mean \"derived\"?");
}

TEST(SceneErrors, WhatTheMethodCannotDoPointsAtTheMethod) {
  const std::string errors = errors_of(chain_with("stiffness = 3\n[solve]\nmethod = \"euler\"\n"));
  EXPECT_TRUE(errors.starts_with("f.toml:7:1: method \"euler\" has no links with stiffness")) << errors;
  EXPECT_NE(errors.find("xpbd"), std::string::npos) << errors;
}

TEST(SceneErrors, CameraThatLooksNowhereOrFollowsNobody) {
  EXPECT_EQ(errors_of(chain_with("[camera]\neye = [0, 1, 0]\ntarget = [0, 1, 0]\n")),
            "f.toml:6:1: \"eye\" and \"target\" of [camera] are the same point\n    eye = [0, 1, 0]\n    ^");
  EXPECT_EQ(errors_of(chain_with("[camera]\ndirection = [0, 0, 0]\n")),
            "f.toml:6:1: \"direction\" of [camera] must not be zero\n    direction = [0, 0, 0]\n    ^");
  EXPECT_EQ(errors_of(chain_with("[look]\nspeed = [[1, 0.5], [1, 2]]\n")),
            "f.toml:6:1: times in \"speed\" of [look] must rise: 1.0 s comes after 1.0 s\n    speed = [[1, "
            "0.5], [1, "
            "2]]\n    ^");
  EXPECT_EQ(errors_of(chain_with("[look]\nspeed = [[1, 0]]\n")),
            "f.toml:6:1: a speed in \"speed\" of [look] must be from 0.001 to 1000, not 0.0\n    speed = "
            "[[1, 0]]\n    "
            "^");
  EXPECT_EQ(errors_of(chain_with("[camera]\nup = [0, 0, 0]\n")),
            "f.toml:6:1: \"up\" of [camera] must not be zero\n    up = [0, 0, 0]\n    ^");
  EXPECT_EQ(errors_of(chain_with("[camera]\nfollow = \"rop.0\"\n")),
            "f.toml:6:1: \"follow\" names no mass: \"rop.0\"\n    follow = \"rop.0\"\n    ^\n"
            "    did you mean \"rope.0\"?");
}

TEST(SceneErrors, AreReportedAllAtOnceInTheOrderOfTheFile) {
  EXPECT_EQ(
      errors_of("[look]\n"
                "them = \"dark\"\n"
                "[solve]\n"
                "method = \"xpbd\"\n"
                "complance = 0.1\n"
                "[[chain]]\n"
                "name = \"rope\"\n"
                "from = [0, 2, 0]\n"
                "to = [2, 2, 0]\n"
                "damping = 1\n"
                "mass = -1\n"),
      "f.toml:2:1: unknown key \"them\" in [look]\n    them = \"dark\"\n    ^\n"
      "    did you mean \"theme\"?\n"
      "f.toml:5:1: unknown key \"complance\" in [solve]\n    complance = 0.1\n    ^\n"
      "f.toml:10:1: damping needs a stiffness: a rigid link has no speed to damp\n    damping = 1\n    ^\n"
      "f.toml:11:8: \"mass\" must be above 0 and at most 1e12 kg, not -1\n    mass = -1\n           ^");
}

TEST(SceneErrors, WhatFollowsFromAnErrorIsNotReported) {
  // "bob" has no usable name, so that the link finds none says nothing new.
  EXPECT_EQ(errors_of("[[mass]]\nname = \"hand\"\nposition = [0, 0, 0]\n"
                      "[[mass]]\nname = 3\nposition = [1, 0, 0]\n"
                      "[[link]]\na = \"hand\"\nb = \"bob\"\n"),
            "f.toml:5:8: \"name\" must be text, not 3\n    name = 3\n           ^");
}

// How many masses there are, and what they are called, is known all the same.
TEST(SceneErrors, BadNamesAreReportedBesideWhatCantBeRead) {
  const std::string masses = "[[mass]]\nname = \"hand\"\nposition = [0, 0, 0]\n";
  const std::string names =
      "[[link]]\na = \"hand\"\nb = \"rop.1\"\n[[load]]\nmasses = [\"hnd\"]\nforce = [0, 1, 0]\n"
      "[camera]\nfollow = \"rope.9\"\n[look]\ntrails = [\"rope.x\"]\n";
  for (const std::string broken :
       {"[[chain]]\nname = \"rope\"\nfrom = [0, 2, 0]\nto = [2, 2, 0]\nlinks = 5\nsofness = 1\n",
        "[[chain]]\nname = \"rope\"\nfrom = \"here\"\nto = [2, 2, 0]\nlinks = 5\n",
        "[[chain]]\nname = \"rope\"\nto = [2, 2, 0]\nlinks = 5\n", "[[mass]]\nname = \"rope\"\n",
        "[[mass]]\nname = \"rope\"\nposition = [0, 0]\n"}) {
    const std::string errors = errors_of(broken + masses + names);
    EXPECT_EQ(std::count(errors.begin(), errors.end(), '^'), 5) << errors;
    for (const std::string name :
         {"mass is named \"rop.1\"", "mass is named \"hnd\"", "no mass: \"rope.9\"", "no mass: \"rope.x\""})
      EXPECT_NE(errors.find(name), std::string::npos) << name << " in\n" << errors;
  }
}

// Neither how many there are of them, nor what they are called, where that itself can't be read.
TEST(SceneErrors, NamesAreNotLookedForWhereTheyAreWhatCantBeRead) {
  for (const std::string key : {"links = \"five\"", "lnks = 5", "nmae = \"rope\""})
    EXPECT_EQ(errors_of("[[chain]]\nname = \"rope\"\nfrom = [0, 2, 0]\nto = [2, 2, 0]\n" + key +
                        "\n[camera]\nfollow = \"rope.9\"\n")
                  .find("follow"),
              std::string::npos)
        << key;
}

TEST(SceneErrors, VeryManyAreCounted) {
  std::string text = chain_with("");
  for (int i = 0; i < 12'000; ++i) text += fmt::format("x{} = 1\n", i);
  const std::string errors = errors_of(text);
  EXPECT_EQ(std::count(errors.begin(), errors.end(), '^'), 50);
  EXPECT_TRUE(errors.ends_with("… and 11950 more errors")) << errors.substr(errors.size() - 100);
}

}  // namespace
}  // namespace taut
