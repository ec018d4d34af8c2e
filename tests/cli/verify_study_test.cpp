#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program.h"

// Charts, maps and sag sheets are held against what they were when they were made.

namespace taut::testing {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

// How a study is made, where its files lie in its folder, and some of each kind that it makes.
struct Study {
  std::string name;
  Words words;
  std::string below;
  Words files;
};

std::vector<Study> studies() {
  return {{"sag",
           {"sag", "hanging-chain-two-pins", "--passes", "1,4", "--size", "64x48"},
           "",
           {"sag.png", "sag-over-passes.svg", "sag.csv", "sag.json", "shapes.jsonl"}},
          {"stability",
           {"stability", "level-chain", "--methods", "xpbd", "--axes", "step,mass-ratio", "--grid", "3x3",
            "--duration", "0.1"},
           "level-chain/step-mass-ratio/",
           {"overview.png", "xpbd.svg", "cells.csv", "maps.json", "overview.txt", "cases.jsonl"}},
          {"chart",
           {"chart", "pendulum", "--methods", "rattle", "--horizon", "0.2s"},
           "",
           {"pendulum-trajectory.png", "pendulum-trajectory.svg", "pendulum.csv", "pendulum.json",
            "pendulum-trajectory.txt", "chart.html", "which-method.md", "pendulum.cases.jsonl"}}};
}

class VerifyStudy : public ::testing::TestWithParam<Study> {
 protected:
  void SetUp() override {
    const Ran ran = make();
    ASSERT_EQ(ran.status, 0) << ran.err;
  }
  Ran make(const Words& more = {}) const {
    Words words = GetParam().words;
    words.insert(words.end(), {"-o", folder_ / "study"});
    words.insert(words.end(), more.begin(), more.end());
    return taut(words, {{"TAUT_CACHE", folder_ / "cache"}});
  }
  std::string place_of(const std::string& file) const { return "study/" + GetParam().below + file; }
  void expect_fault(const std::string& text) const {
    const Ran ran = taut({"verify", folder_ / "study"});
    EXPECT_EQ(ran.status, 5) << ran.err;
    EXPECT_NE(ran.err.find(text), std::string::npos) << text << "\n" << ran.err;
  }
  void expect_whole() const {
    const Ran ran = taut({"verify", folder_ / "study"});
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_NE(ran.err.find("whole"), std::string::npos) << ran.err;
  }

  TemporaryFolder folder_;
};

TEST_P(VerifyStudy, WhatWasJustMadeIsWhole) {
  expect_whole();
  const Json found = Json::parse(taut({"verify", folder_ / "study", "--json"}).out);
  EXPECT_GE(found["checked"], GetParam().files.size());
  EXPECT_EQ(found["notes"], Json::array());
  EXPECT_EQ(taut({"verify", folder_ / "study", "--deep"}).status, 2);
}

TEST_P(VerifyStudy, FindsWhatIsMissingCutShortAndChanged) {
  for (const std::string& name : GetParam().files) {
    const std::string file = place_of(name), whole = read_file(folder_ / file);
    const std::string shown = GetParam().below + name;
    ASSERT_GT(whole.size(), 10U) << file;
    fs::remove(folder_ / file);
    expect_fault(shown + " is missing");
    folder_.write(file, whole.substr(0, whole.size() - 1));
    expect_fault(shown + " is cut short");
    std::string edited = whole;
    edited[whole.size() / 2] ^= 1;
    folder_.write(file, edited);
    expect_fault(shown + " is not as it was made");
    folder_.write(file, whole);
  }
  expect_whole();
}

TEST_P(VerifyStudy, TheSameCommandMendsIt) {
  fs::remove(folder_ / place_of(GetParam().files.front()));
  EXPECT_EQ(taut({"verify", folder_ / "study"}).status, 5);
  ASSERT_EQ(make().status, 0);
  expect_whole();
}

TEST_P(VerifyStudy, FindsADamagedListAndAnotherPhysics) {
  const std::string file = place_of("contents.json");
  const std::string whole = read_file(folder_ / file);
  folder_.write(file, whole.substr(0, whole.size() / 2));
  expect_fault("is no list of a study's files");
  Json contents = Json::parse(whole);
  contents["physics"] = "0000000000000000";
  folder_.write(file, contents.dump());
  expect_fault("made by a taut that moves or judges otherwise");
}

// A store that another run has added to is no fault; a line of it that can't be read is.
TEST_P(VerifyStudy, AStoreOfCasesMayHaveGrown) {
  const std::string file = folder_ / place_of(GetParam().files.back());
  std::ofstream(file, std::ios::app) << R"({"case":"more","build":"","result":1})"
                                     << "\n";
  const Ran ran = taut({"verify", folder_ / "study"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.err.find("has grown since it was drawn"), std::string::npos) << ran.err;
  std::ofstream(file, std::ios::app) << "no case\n";
  expect_fault("is damaged");
}

std::string name_of(const ::testing::TestParamInfo<Study>& study) {
  return study.param.name;
}
INSTANTIATE_TEST_SUITE_P(Each, VerifyStudy, ::testing::ValuesIn(studies()), name_of);

TEST(VerifyShards, NamesThoseThatAreMissingAndFindsDamage) {
  const TemporaryFolder folder;
  const auto make = [&](const std::string& part) {
    return taut({"stability", "level-chain", "--methods", "xpbd", "--axes", "step,mass-ratio", "--grid",
                 "4x2", "--duration", "0.1", "-o", folder / "maps", "--shard", part});
  };
  ASSERT_EQ(make("1/2").status, 0);
  Ran ran = taut({"verify", folder / "maps"});
  EXPECT_EQ(ran.status, 3) << ran.err;
  EXPECT_NE(ran.err.find("shard 2 of 2 is missing"), std::string::npos) << ran.err;
  ASSERT_EQ(make("2/2").status, 0);
  ran = taut({"verify", folder / "maps"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  std::ofstream(folder / "maps/level-chain/step-mass-ratio/cases-2-of-2.jsonl", std::ios::app) << "no case\n";
  EXPECT_EQ(taut({"verify", folder / "maps"}).status, 5);
}

}  // namespace
}  // namespace taut::testing
