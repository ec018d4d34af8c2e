#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "metrics_lines.h"
#include "program.h"

// What --metrics writes of every frame, and plots of it.

namespace taut::testing {
namespace {

using Json = nlohmann::json;

std::vector<std::string> table_rows(const std::string& text) {
  std::vector<std::string> rows;
  std::istringstream stream(text);
  for (std::string row; std::getline(stream, row);) rows.push_back(row);
  return rows;
}

std::vector<std::string> small_render(const std::string& scene, const std::vector<std::string>& more) {
  std::vector<std::string> words{"render", scene, "--size", "64x48", "-o", "frames", "--quiet"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// A pendulum of 1 kg and 1 m, let go level: at every frame its kinetic energy is what it has fallen by, and
// its sag, which is how far it hangs below its nail, says how far that is.
TEST(Metrics, AreThoseOfAPendulum) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("small.toml", small_scene());
  const Ran ran = taut(
      small_render(scene, {"--method", "rattle", "--set", "steps_per_second=2400", "--metrics", "m.jsonl"}),
      {}, folder.path());
  ASSERT_EQ(ran.status, 0) << ran.err;
  const std::vector<Json> lines = lines_of(read_file(folder / "m.jsonl"));
  ASSERT_EQ(lines.size(), 30U);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Json& line = lines[i];
    EXPECT_EQ(line["frame"], i + 1);
    EXPECT_NEAR(line["time"].get<double>(), static_cast<double>(i) / 30.0, 1e-12);
    const double kinetic = line["kinetic_energy"];
    EXPECT_NEAR(kinetic, 9.81 * line["sag"].get<double>(), 2e-4);
    EXPECT_NEAR(line["largest_speed"].get<double>(), std::sqrt(2.0 * kinetic), 1e-6);
    EXPECT_NEAR(line["total_energy"].get<double>(), 9.81 * 2.0, 2e-4);
    EXPECT_EQ(line["broken_links"], 0);
    EXPECT_EQ(line["largest_tension"].is_null(), i == 0) << "nothing is known before the first step";
    for (const char* stage : {"simulate", "shape", "draw", "flatten", "compress", "write"})
      EXPECT_GE(line[std::string(stage) + "_seconds"].get<double>(), 0.0) << stage;
  }
  EXPECT_GT(lines[10]["draw_seconds"].get<double>(), 0.0);
}

TEST(Metrics, OfATableHaveTheSameNumbers) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("small.toml", small_scene());
  ASSERT_EQ(
      taut(small_render(scene, {"--metrics", "m.csv", "--set", "break_stretch=9"}), {}, folder.path()).status,
      2);
  ASSERT_EQ(taut(small_render(scene, {"--metrics", "m.csv"}), {}, folder.path()).status, 0);
  ASSERT_EQ(
      taut({"simulate", scene, "-o", "motion", "--metrics", "m.jsonl", "--quiet"}, {}, folder.path()).status,
      0);
  const std::vector<std::string> rows = table_rows(read_file(folder / "m.csv"));
  const std::vector<Json> lines = lines_of(read_file(folder / "m.jsonl"));
  ASSERT_EQ(rows.size(), 31U);
  ASSERT_EQ(lines.size(), 30U);
  EXPECT_EQ(rows[0].rfind("frame,time,method,kinetic_energy,", 0), 0U);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(rows[i + 1].rfind(lines[i]["frame"].dump() + ",", 0), 0U);
    std::istringstream row(rows[i + 1].substr(rows[i + 1].rfind('"') + 2));
    double kinetic = 0.0;
    row >> kinetic;
    EXPECT_EQ(kinetic, lines[i]["kinetic_energy"].get<double>());
  }
}

// Each method's rows stand one after the other.
TEST(Metrics, OfAComparisonNameTheMethod) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("small.toml", small_scene());
  const Ran ran = taut({"compare", scene, "--methods", "xpbd,euler", "--size", "64x48", "-o", "frames",
                        "--quiet", "--metrics", "m.jsonl"},
                       {}, folder.path());
  ASSERT_EQ(ran.status, 0) << ran.err;
  const std::vector<Json> lines = lines_of(read_file(folder / "m.jsonl"));
  ASSERT_EQ(lines.size(), 60U);
  EXPECT_EQ(lines[20]["method"], "xpbd, 240 steps/s");
  EXPECT_EQ(lines[21]["method"], "euler, 240 steps/s");
  EXPECT_EQ(lines[20]["frame"], lines[21]["frame"]);
  EXPECT_FALSE(lines[20]["largest_tension"].is_null());
  EXPECT_TRUE(lines[21]["largest_tension"].is_null()) << "euler knows none";
}

TEST(Metrics, AreMadeOnce) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("small.toml", small_scene());
  const std::vector<std::string> words = small_render(scene, {"--metrics", "m.jsonl"});
  ASSERT_EQ(taut(words, {}, folder.path()).status, 0);
  const std::string first = read_file(folder / "m.jsonl");
  ASSERT_EQ(taut(words, {}, folder.path()).status, 0);
  EXPECT_EQ(read_file(folder / "m.jsonl"), first) << "with what the stages took the first time";
  EXPECT_EQ(taut({"verify", "frames"}, {}, folder.path()).status, 0);
  folder.write("m.jsonl", "of somebody else\n");
  EXPECT_EQ(taut(words, {}, folder.path()).status, 4) << "a file that the manifest doesn't know stays";
  EXPECT_EQ(read_file(folder / "m.jsonl"), "of somebody else\n");
  EXPECT_EQ(taut({"verify", "frames"}, {}, folder.path()).status, 5);
  ASSERT_EQ(taut(small_render(scene, {"--metrics", "m.jsonl", "--overwrite"}), {}, folder.path()).status, 0);
  EXPECT_EQ(measured_part(read_file(folder / "m.jsonl")), measured_part(first));
}

// Frames that are there already are simulated once more for it, and not drawn.
TEST(Metrics, CanBeAskedForLater) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("small.toml", small_scene());
  ASSERT_EQ(taut(small_render(scene, {}), {}, folder.path()).status, 0);
  const Ran ran = taut(small_render(scene, {"--metrics", "m.jsonl", "--json"}), {}, folder.path());
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(Json::parse(ran.out)["frames"]["kept"], 30);
  EXPECT_EQ(lines_of(read_file(folder / "m.jsonl")).size(), 30U);
  ASSERT_EQ(taut({"simulate", scene, "-o", "motion", "--quiet"}, {}, folder.path()).status, 0);
  const Ran drawn = taut(
      {"render", "--motion", "motion", "--size", "64x48", "-o", "seen", "--quiet", "--metrics", "seen.jsonl"},
      {}, folder.path());
  ASSERT_EQ(drawn.status, 0) << drawn.err;
  EXPECT_EQ(measured_part(read_file(folder / "seen.jsonl")), measured_part(read_file(folder / "m.jsonl")));
}

// A film without a folder of frames keeps them in its own manifest.
TEST(Metrics, StandBesideAFilmAlone) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("small.toml", small_scene());
  const std::vector<std::string> words{"render", scene,       "--size",  "64x48",  "--no-frames", "--film",
                                       "a.mp4",  "--metrics", "m.jsonl", "--json", "--quiet"};
  ASSERT_EQ(taut(words, {}, folder.path()).status, 0);
  const std::string first = read_file(folder / "m.jsonl");
  EXPECT_EQ(lines_of(first).size(), 30U);
  const Ran again = taut(words, {}, folder.path());
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(read_file(folder / "m.jsonl"), first) << "the same command twice does nothing";
  EXPECT_EQ(taut({"verify", "a.mp4"}, {}, folder.path()).status, 0);
}

TEST(Metrics, RefuseWhatTheyCannotBe) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("small.toml", small_scene());
  for (const std::string verb : {"render", "simulate"}) {
    const Ran ran = taut({verb, scene, "--metrics", "m.txt"}, {}, folder.path());
    EXPECT_EQ(ran.status, 2) << verb;
    EXPECT_NE(ran.err.find(".csv or .jsonl"), std::string::npos) << ran.err;
    EXPECT_EQ(folder.entries(), 1U) << "nothing but the scene itself";
  }
}

TEST(Plot, DrawsMetricsAndWays) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("small.toml", small_scene());
  ASSERT_EQ(
      taut({"simulate", scene, "-o", "motion", "--metrics", "m.csv", "--quiet"}, {}, folder.path()).status,
      0);
  const std::vector<std::vector<std::string>> plots{
      {"plot", "m.csv", "-o", "a"},
      {"plot", scene, "-o", "b.png", "--show", "energy,tension"},
      {"plot", "--motion", "motion", "-o", "c", "--path", "bob"},
      {"plot", scene, "-o", "d.svg", "--path", "bob,nail"}};
  for (const std::vector<std::string>& words : plots) {
    const Ran ran = taut(words, {}, folder.path());
    EXPECT_EQ(ran.status, 0) << words[1] << ": " << ran.err;
  }
  for (const char* stem : {"a", "b", "c", "d"})
    for (const char* ending : {".png", ".svg"})
      EXPECT_GT(read_file(folder / (std::string(stem) + ending)).size(), 2000U);
  EXPECT_NE(read_file(folder / "a.svg").find("speed (m/s)"), std::string::npos);
  EXPECT_NE(read_file(folder / "c.svg").find("seen along z"), std::string::npos);
}

struct BadPlot {
  std::vector<std::string> words;
  std::string said;
};

TEST(Plot, RefusesInWords) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("small.toml", small_scene());
  folder.write("other.csv", "a,b\n1,2\n");
  folder.write("cut.csv", "frame,time,method,sag\n1,0,\"xpbd\",0\n2,0.1,\"xpbd\"\n");
  folder.write("odd.csv", "frame,time,method,sag\n1,zero,\"xpbd\",0\n");
  folder.write("odd.jsonl", "[1]\n");
  folder.write("empty.csv", "frame,time,method,sag\n1,,\"xpbd\",0\n");
  const std::vector<BadPlot> plots{
      {{"plot"}, "nothing to plot"},
      {{"plot", "none.csv"}, "there is no file none.csv"},
      {{"plot", "other.csv"}, "other.csv:1:1: there is no column"},
      {{"plot", "cut.csv"}, "cut.csv:3:7: the row has 3 fields, and there are 4 headings"},
      {{"plot", "odd.csv"}, "odd.csv:2:3: time must be a number, not \"zero\""},
      {{"plot", "empty.csv"}, "empty.csv:2:3: there is no time"},
      {{"plot", "odd.jsonl"}, "odd.jsonl:1: this is no object"},
      {{"plot", scene, "--show", "enrgy"}, "did you mean \"energy\"?"},
      {{"plot", scene, "--path", "bbo"}, "did you mean \"bob\"?"},
      {{"plot", scene, "--path", "bob", "--show", "sag"}, "plots of their own"},
      {{"plot", "cut.csv", "--path", "bob"}, "hold no places"}};
  for (const BadPlot& plot : plots) {
    std::vector<std::string> words = plot.words;
    words.insert(words.end(), {"-o", "plot"});
    const Ran ran = taut(words, {}, folder.path());
    EXPECT_EQ(ran.status, 2) << plot.said << ": " << ran.err;
    EXPECT_NE(ran.err.find(plot.said), std::string::npos) << ran.err;
    EXPECT_EQ(folder.entries(), 6U) << "nothing was written";
  }
}

}  // namespace
}  // namespace taut::testing
