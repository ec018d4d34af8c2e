#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "program.h"

namespace taut::testing {
namespace {

std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    auto& row = rows.emplace_back();
    std::string cell;
    for (std::istringstream cells(line); std::getline(cells, cell, ',');) row.push_back(cell);
  }
  return rows;
}

const std::string pendulum = R"(
[world]
duration = 1.0
[solve]
method = "rattle"
steps_per_second = 1000
[[mass]]
name = "hook"
position = [0, 0, 0]
pinned = true
[[mass]]
name = "bob"
position = [1, 0, 0]
[[link]]
a = "hook"
b = "bob"
break_tension = 29.0
)";

class ExportTest : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string scene_ = folder_.write("pendulum.toml", pendulum);
};

// A pendulum released level at rest has v² = 2 g × drop wherever it is.
TEST_F(ExportTest, ChosenInstantsAreExact) {
  const Ran ran = taut({"export", scene_, "--times", "0.25,0.4321"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const auto rows = rows_of(ran.out);
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(ran.out.substr(0, ran.out.find('\n')), "frame,time,mass,name,x,y,z,vx,vy,vz");
  EXPECT_EQ(rows[2][1], "0.25");
  EXPECT_EQ(rows[4][1], "0.4321");
  EXPECT_EQ(rows[4][3], "bob");
  const double y = std::stod(rows[4][5]), vx = std::stod(rows[4][7]), vy = std::stod(rows[4][8]);
  EXPECT_NEAR(vx * vx + vy * vy, -2.0 * 9.81 * y, 1e-3);
}

TEST_F(ExportTest, NumbersReadBackToTheSameDoubles) {
  const auto rows = rows_of(taut({"export", scene_, "--times", "0.3"}).out);
  EXPECT_GE(rows[2][4].size(), 16U) << "full precision";
}

TEST_F(ExportTest, FramesAreThoseOfAFilm) {
  const auto rows = rows_of(taut({"export", scene_, "--fps", "10"}).out);
  ASSERT_EQ(rows.size(), 1U + 2U * 10U);
  EXPECT_EQ(rows[1][0], "1");
  EXPECT_EQ(rows[1][1], "0");
  EXPECT_EQ(rows[3][1], "0.1");
}

TEST_F(ExportTest, EverySecondFrameKeepsItsNumber) {
  const auto rows = rows_of(taut({"export", scene_, "--fps", "10", "--every", "3"}).out);
  ASSERT_EQ(rows.size(), 1U + 2U * 4U);
  EXPECT_EQ(rows[3][0], "4");
  EXPECT_EQ(rows[3][1], "0.3");
  EXPECT_EQ(rows[8][0], "10");
}

// A thirtieth of a second is the frame of films that ask for no other; what is exported to a file is no film.
TEST_F(ExportTest, ASceneMayBeShorterThanAThirtiethOfASecond) {
  const std::string file = (folder_.path() / "moments.csv").string();
  const auto exported = [&](const std::string& duration, const std::vector<std::string>& instants) {
    std::vector<std::string> words{"export", scene_, "--set", "world.duration=" + duration, "-o", file};
    words.insert(words.end(), instants.begin(), instants.end());
    const Ran ran = taut(words);
    EXPECT_EQ(ran.status, 0) << duration << ": " << ran.err;
    return rows_of(read_file(file)).size();
  };
  EXPECT_EQ(exported("0.004", {"--fps", "1000"}), 1U + 2U * 4U);
  EXPECT_EQ(exported("0.01", {"--times", "0,0.01"}), 1U + 2U * 2U);
}

TEST_F(ExportTest, LinksHaveStrainTensionAndBreak) {
  const auto rows = rows_of(taut({"export", scene_, "--times", "0.3,0.9", "--table", "links"}).out);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"frame", "time", "link", "a", "b", "rest_length", "length",
                                               "strain", "tension", "broken_at"}));
  EXPECT_EQ(rows[1][5], "1");
  EXPECT_NEAR(std::stod(rows[1][6]), 1.0, 1e-11);
  EXPECT_NEAR(std::stod(rows[1][7]), 0.0, 1e-11);
  EXPECT_GT(std::stod(rows[1][8]), 5.0);
  ASSERT_EQ(rows[2].size(), 10U);
  for (const std::size_t empty : {6U, 7U, 8U}) EXPECT_EQ(rows[2][empty], "") << empty;
  EXPECT_NEAR(std::stod(rows[2][9]), 0.53, 0.05) << "it passes 29 N shortly before its lowest point";
}

// Of a mass of 1 kg, whose link breaks on the way: the rest follows from where it is and how fast.
TEST_F(ExportTest, EnergiesAreThoseOfTheMasses) {
  const auto energies = rows_of(taut({"export", scene_, "--times", "0,0.3,0.9", "--table", "energy"}).out);
  const auto masses = rows_of(taut({"export", scene_, "--times", "0,0.3,0.9"}).out);
  ASSERT_EQ(energies.size(), 4U);
  EXPECT_EQ(energies[0],
            (std::vector<std::string>{"frame", "time", "kinetic", "potential", "elastic", "total", "pin_work",
                                      "load_work", "contact_work", "broken_energy"}));
  for (std::size_t i = 1; i < energies.size(); ++i) {
    const auto& bob = masses[2 * i];
    ASSERT_EQ(bob[3], "bob");
    EXPECT_EQ(energies[i][1], bob[1]);
    const double vx = std::stod(bob[7]), vy = std::stod(bob[8]), vz = std::stod(bob[9]);
    EXPECT_NEAR(std::stod(energies[i][2]), 0.5 * (vx * vx + vy * vy + vz * vz), 1e-12);
    EXPECT_NEAR(std::stod(energies[i][3]), 9.81 * std::stod(bob[5]), 1e-12);
    EXPECT_EQ(energies[i][4], "0");
    EXPECT_NEAR(std::stod(energies[i][5]), 0.0, 1e-3) << "none is lost";
    for (const std::size_t none : {6U, 7U, 8U}) EXPECT_EQ(energies[i][none], "0") << none;
  }
}

// What xpbd leaves of a stretch stands beside the length it should have.
TEST_F(ExportTest, LengthNowIsNotTheRestLength) {
  const auto rows = rows_of(taut({"export", scene_, "--method", "xpbd", "--set", "steps_per_second=60",
                                  "--times", "0.5", "--table", "links"})
                                .out);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1][5], "1");
  EXPECT_NEAR(std::stod(rows[1][6]) - 1.0, std::stod(rows[1][7]), 1e-12);
}

TEST_F(ExportTest, TensionIsEmptyWhereTheMethodKnowsNone) {
  std::string unbreakable = pendulum;
  unbreakable.erase(unbreakable.find("break_tension"));
  const std::string scene = folder_.write("unbreakable.toml", unbreakable);
  for (const auto& [method, known] : {std::pair{"euler", false}, {"verlet", true}, {"rattle", true}}) {
    const Ran ran = taut({"export", scene, "--method", method, "--times", "0,0.5", "--table", "links"});
    ASSERT_EQ(ran.status, 0) << ran.err;
    const auto rows = rows_of(ran.out);
    EXPECT_EQ(rows[1][8], "") << method << " has made no step";
    EXPECT_EQ(!rows[2][8].empty(), known) << method << ": " << rows[2][8];
    const nlohmann::json measures = nlohmann::json::parse(
        taut({"check", scene, "--method", method, "--run", "--json"}).out)[0]["measures"];
    EXPECT_EQ(measures["largest_tension"].is_number(), known) << method << ": " << measures;
  }
}

// RFC 4180: quotes around, and those within doubled.
TEST_F(ExportTest, NamesAreQuotedWhereTheyNeedBe) {
  std::string odd = pendulum;
  for (std::size_t at; (at = odd.find("\"bob\"")) != std::string::npos;)
    odd.replace(at, 5, R"("bob,\"the\"\nmass")");
  const std::string scene = folder_.write("odd.toml", odd);
  const std::string quoted = "\"bob,\"\"the\"\"\nmass\"";
  for (const char* table : {"masses", "links", "orientations"}) {
    const Ran ran = taut({"export", scene, "--times", "0.2", "--table", table});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_NE(ran.out.find("," + quoted + ","), std::string::npos) << ran.out;
    EXPECT_EQ(ran.out.find("\"hook"), std::string::npos) << ran.out;
  }
}

// The second run looks at the whole motion, however few instants are asked for, and changes none of them.
TEST_F(ExportTest, ACertificateChangesNoNumber) {
  const Ran plain = taut({"export", scene_, "--times", "0.25,0.5"}),
            certified = taut({"export", scene_, "--times", "0.25,0.5", "--certify"});
  EXPECT_EQ(certified.status, 0) << certified.err;
  EXPECT_EQ(certified.out, plain.out);
  EXPECT_NE(certified.err.find("over all of its 1 s"), std::string::npos) << certified.err;
}

TEST_F(ExportTest, TimesBeyondTheEndAreRefused) {
  const std::string file = (folder_.path() / "table.csv").string();
  const Ran ran = taut({"export", scene_, "--times", "0.5,1.5", "-o", file});
  EXPECT_EQ(ran.status, 2);
  EXPECT_NE(ran.err.find("1.5 s is outside"), std::string::npos) << ran.err;
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_EQ(taut({"export", scene_, "--times", "0.5,1.0"}).status, 0);
}

TEST_F(ExportTest, GoesToAFileAsAWhole) {
  const std::string file = (folder_.path() / "table.csv").string();
  const Ran ran = taut({"export", scene_, "--times", "0.5", "-o", file});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.out, "");
  std::ifstream stream(file);
  std::stringstream text;
  text << stream.rdbuf();
  EXPECT_EQ(rows_of(text.str()).size(), 3U);
}

TEST_F(ExportTest, BadFlagsAreRefused) {
  for (const std::vector<std::string>& flags : {std::vector<std::string>{"--format", "xml"},
                                                {"--table", "forces"},
                                                {"--times", "0.5,0.2"},
                                                {"--times", "soon"}}) {
    std::vector<std::string> arguments{"export", scene_};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    const Ran ran = taut(arguments);
    EXPECT_EQ(ran.status, 2) << flags[1];
    EXPECT_NE(ran.err, "");
    EXPECT_EQ(ran.out, "");
  }
}

// The first call works the reference out and keeps it; the second reads it and says the same.
TEST_F(ExportTest, ReferencesAreKeptBetweenCalls) {
  const std::filesystem::path cache = folder_.path() / "cache";
  std::string free_swing = pendulum;
  free_swing.erase(free_swing.find("break_tension"));
  const std::string scene = folder_.write("free.toml", free_swing);
  const Environment environment{{"TAUT_CACHE", cache.string()}};
  const Ran first = taut({"check", scene, "--reference", "--json"}, environment);
  ASSERT_EQ(first.status, 0) << first.err;
  ASSERT_FALSE(std::filesystem::is_empty(cache));
  EXPECT_EQ(taut({"check", scene, "--reference", "--json"}, environment).out, first.out);
  const auto reference = nlohmann::json::parse(first.out)[0]["reference"];
  EXPECT_LT(reference["position_error"].get<double>(), 1e-4);
  EXPECT_LT(reference["uncertainty"].get<double>(), 1e-6);
}

TEST_F(ExportTest, AReferenceGoesOnPastABreak) {
  const Environment environment{{"TAUT_CACHE", (folder_.path() / "cache").string()}};
  const Ran whole = taut({"check", scene_, "--reference", "--json"}, environment);
  ASSERT_EQ(whole.status, 0) << whole.err;
  const auto json = nlohmann::json::parse(whole.out)[0];
  const double duration = json["duration"].get<double>();
  EXPECT_EQ(json["reference"]["time"].get<double>(), duration) << whole.out;
}

TEST_F(ExportTest, ThreadsChangeNothing) {
  std::string alone;
  for (const char* threads : {"1", "2", "3"}) {
    const Ran ran = taut({"export", "curtain", "--times", "0.1", "--threads", threads, "--table", "links"});
    EXPECT_EQ(ran.status, 0) << ran.err;
    if (alone.empty()) alone = ran.out;
    EXPECT_EQ(ran.out, alone) << threads;
  }
  for (const char* wrong : {"0", "-1", "1.5", "many", "1e9"}) {
    // Also where nothing is run: before anything that takes long.
    for (const char* verb : {"export", "check"}) {
      const Ran ran = taut({verb, "curtain", "--threads", wrong});
      EXPECT_EQ(ran.status, 2) << ran.err;
      EXPECT_NE(ran.err.find("--threads"), std::string::npos) << ran.err;
    }
  }
}

TEST_F(ExportTest, VectorInstructionsChangeNothing) {
  const auto table = [](const char* simd) {
    return taut({"export", "curtain", "--times", "0.1", "--table", "links"}, {{"TAUT_SIMD", simd}});
  };
  const Ran plain = table("scalar"), best = table("");
  EXPECT_EQ(plain.status, 0) << plain.err;
  EXPECT_EQ(plain.out, best.out);
  const Ran wrong = table("mmx");
  EXPECT_EQ(wrong.status, 2) << wrong.err;
  EXPECT_NE(wrong.err.find("scalar"), std::string::npos) << wrong.err;
}

}  // namespace
}  // namespace taut::testing
