// What a scene asks for is bounded: by its size, by what numbers can be computed with, and by what its
// entries make of one another. What is too much is refused in words, and what is much is told before it is
// built.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "base/processor_time.h"
#include "model/size.h"
#include "scene/scene.h"
#include "scene_errors.h"

namespace taut {
namespace {

// Many texts as the elements of a list.
template <class Name>
std::string list_of(int count, Name name) {
  std::string list;
  for (int i = 0; i < count; ++i) list += fmt::format("\"{}\",", name(i));
  return "[" + list + "]";
}

std::string chain_of(int links) {
  return fmt::format("[[chain]]\nname = \"rope\"\nfrom = [0, 2, 0]\nto = [2, 2, 0]\nlinks = {}\n", links);
}

// Reads a load that names so many masses of a chain; the least processor time of three times (s).
double seconds_to_read_a_load_on(int count) {
  const std::string scene = chain_of(count) + "[[load]]\nforce = [0, 1, 0]\nmasses = " +
                            list_of(count, [](int i) { return fmt::format("rope.{}", i); }) + "\n";
  double least = std::numeric_limits<double>::infinity();
  for (int time = 0; time < 3; ++time) {
    const double start = processor_seconds();
    EXPECT_EQ(parse_scene(scene, "f.toml").model.loads.at(0).masses.size(), static_cast<std::size_t>(count));
    least = std::min(least, processor_seconds() - start);
  }
  return least;
}

// Four times as much takes four times as long where it is linear, and sixteen times where each name is looked
// for among all.
TEST(SceneBounds, ALoadThatNamesEveryMassIsReadInLinearTime) {
  EXPECT_LT(seconds_to_read_a_load_on(40'000), 8.0 * seconds_to_read_a_load_on(10'000));
}

TEST(SceneBounds, StarsFitPartsOfNames) {
  const std::string text =
      "[[sheet]]\nname = \"cloth\"\nrows = 3\ncolumns = 4\nfrom = [0, 1, 0]\nto = [1, 1, 0]\n"
      "down = [0, -1, 0]\n[[mass]]\nname = \"bob\"\nposition = [5, 0, 0]\n";
  const auto loaded = [&](const std::string& masses) {
    const Scene scene = parse_scene(text + "[[load]]\nforce = [0, 1, 0]\nmasses = " + masses + "\n", "f");
    return scene.model.loads.at(0).masses;
  };
  EXPECT_EQ(loaded("[\"cloth.1.*\"]"), (std::vector<Index>{4, 5, 6, 7}));
  EXPECT_EQ(loaded("[\"cloth.*.1\", \"cloth.1.*\"]"), (std::vector<Index>{1, 4, 5, 6, 7, 9}));
  EXPECT_EQ(loaded("[\"*.2.3\", \"*\", \"*\"]"), (std::vector<Index>{11, 12}));
  EXPECT_EQ(loaded("[\"*.*.*\", \"bob\"]").size(), 13U);
  for (const std::string pattern : {"cloth.*", "*.*", "cloth.1.*.*", "rag.*.*", "cloth.**.1", ""})
    EXPECT_NE(errors_of(text + "[[load]]\nforce = [0, 1, 0]\nmasses = [\"" + pattern + "\"]\n")
                  .find("no mass is named"),
              std::string::npos)
        << pattern;
}

TEST(SceneBounds, LoadsThatActOnMoreThanCanBeKeptAreRefused) {
  std::string text = chain_of(1'000'000);
  for (int i = 0; i < 101; ++i) text += "[[load]]\nforce = [0, 1, 0]\nmasses = [\"rope.*\"]\n";
  EXPECT_NE(errors_of(text).find("100000000 is the most they may"), std::string::npos);
}

// To tell of each took minutes.
TEST(SceneBounds, AListWhereTablesBelongIsOneError) {
  std::string list = "mass = [";
  for (int i = 0; i < 400'000; ++i) list += "1,";
  const std::string errors = errors_of(list + "1]\n");
  EXPECT_TRUE(errors.starts_with("f.toml:1:9: [[mass]] must be a table, not 1\n")) << errors.substr(0, 200);
  EXPECT_LT(errors.size(), 300U);
}

TEST(SceneBounds, MassesThatCollideMustNotAllStartInOnePlace) {
  std::string text;
  for (int i = 0; i < 7000; ++i)
    text += fmt::format("[[mass]]\nname = \"m{}\"\nposition = [0, 0, 0]\ncollides = true\n", i);
  const std::string errors = errors_of(text);
  EXPECT_TRUE(errors.starts_with("f.toml:4:1: more than 20 million pairs of masses that collide")) << errors;
}

TEST(SceneBounds, WhatIsDividedByMustNotBeNextToNothing) {
  EXPECT_EQ(errors_of(chain_with("mass = 1e-320\n")),
            "f.toml:5:8: \"mass\" must not be so near 0: 1e-320 is smaller than 1e-100\n"
            "    mass = 1e-320\n           ^");
  for (const std::string key : {"length", "last_mass", "stiffness", "break_tension"})
    EXPECT_NE(errors_of(chain_with(key + " = 1e-310\n")).find(key + "\" must not be so near 0"),
              std::string::npos)
        << key;
  EXPECT_NE(errors_of(masses_with("[[link]]\na = \"hand\"\nb = \"bob\"\nlength = 4e-323\n"))
                .find("\"length\" must not be so near 0"),
            std::string::npos);
  EXPECT_EQ(errors_of(chain_with("length = 0\nlast_mass = 0.0\n[world]\ndrag = 1e-320\n")), "")
      << "0 stands for something else, and nothing is divided by drag";
}

TEST(SceneBounds, DistancesNextToNothingHaveNoDirection) {
  EXPECT_NE(errors_of("[[chain]]\nname = \"a\"\nfrom = [0, 0, 0]\nto = [1e-200, 0, 0]\n").find("same point"),
            std::string::npos);
  EXPECT_NE(errors_of(chain_with("[[plane]]\npoint = [0, 0, 0]\nnormal = [0, 1e-170, 0]\n")).find("normal"),
            std::string::npos);
  EXPECT_NE(errors_of(chain_with("[[capsule]]\nfrom = [0, 0, 0]\nto = [0, 1e-200, 0]\nradius = 1\n"))
                .find("same point"),
            std::string::npos);
}

TEST(SceneBounds, TrailsMustFitTheMemory) {
  const auto with_trails = [](const std::string& more) {
    return chain_of(20'000) + "[world]\nduration = 3600\n[look]\ntrails = " +
           list_of(20'000, [](int i) { return fmt::format("rope.{}", i); }) + more;
  };
  const std::string errors = errors_of(with_trails("\n"));
  EXPECT_TRUE(errors.starts_with("f.toml:9:1: 20000 trails of 3600 s need about 4.15 TB, and there are "))
      << errors.substr(0, 200);
  EXPECT_EQ(errors_of(with_trails("\ntrail_time = 0.1\n")), "");
}

TEST(SceneBounds, TheSizeIsToldBeforeItIsBuilt) {
  std::optional<Counts> told;
  parse_scene(chain_of(1000), "f.toml", {}, [&](const Counts& counts) { told = counts; });
  ASSERT_TRUE(told);
  EXPECT_EQ(told->masses, 1001.0);
  EXPECT_EQ(told->links, 1000.0);
}

TEST(SceneBounds, CountsAreThoseOfWhatIsBuilt) {
  const std::string text = chain_of(7) +
                           "[[sheet]]\nname = \"cloth\"\nrows = 5\ncolumns = 9\nfrom = [0, 1, 0]\n"
                           "to = [1, 1, 0]\ndown = [0, -1, 0]\ndiagonals = true\nskip_one = true\n"
                           "hooks = { every = 4, draw = [[0, 1], [1, 0.5], [2, 0.4]] }\n"
                           "[[ragdoll]]\nname = \"man\"\nposition = [5, 1, 0]\n"
                           "[[mass]]\nname = \"bob\"\nposition = [9, 0, 0]\n"
                           "[[link]]\na = \"bob\"\nb = \"rope.0\"\n";
  Counts told;
  const Scene scene = parse_scene(text, "f.toml", {}, [&](const Counts& counts) { told = counts; });
  EXPECT_EQ(told.masses, static_cast<double>(scene.model.masses.size()));
  EXPECT_EQ(told.links, static_cast<double>(scene.model.links.size()));
  EXPECT_EQ(told.triangles, static_cast<double>(scene.model.triangles.size()));
  EXPECT_EQ(told.knots, 9.0) << "three hooks with three each";
}

}  // namespace
}  // namespace taut
