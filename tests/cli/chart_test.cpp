#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "output/child_process.h"
#include "program.h"

namespace taut::testing {
namespace {

using Json = nlohmann::json;

const std::vector<std::string> chart_flags{"--methods", "verlet,rattle", "--errors", "trajectory", "--budget",
                                           "1s",        "--quiet"};

std::vector<std::string> chart_words(const std::string& scene, const std::string& folder) {
  std::vector<std::string> words{"chart", scene, "-o", folder};
  words.insert(words.end(), chart_flags.begin(), chart_flags.end());
  return words;
}

Environment cache_in(const TemporaryFolder& folder) {
  return {{"TAUT_CACHE", folder / "cache"}};
}

// Runs a chart again and again until nothing is missing: a machine that is busy spends the budget early.
Ran chart_to_the_end(const TemporaryFolder& folder, const std::string& name) {
  Ran ran;
  do {
    ran = taut(chart_words(folder / "small.toml", folder / name), cache_in(folder));
  } while (ran.status == 3);
  return ran;
}

// The cases of a chart without what differs from run to run.
std::vector<std::string> cases_of(const std::string& file) {
  std::vector<std::string> cases;
  const Json chart = Json::parse(read_file(file));
  for (Json done : chart["cases"]) {
    for (const char* time : {"seconds", "processor_seconds", "wall_seconds"}) done.erase(time);
    cases.push_back(done.dump());
  }
  return cases;
}

TEST(Chart, HoldsEveryRawTimeAndWhatItWasMeasuredWith) {
  const TemporaryFolder folder;
  folder.write("small.toml", small_scene());
  const Ran ran = chart_to_the_end(folder, "chart");
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json chart = Json::parse(read_file(folder / "chart/small.json"));
  EXPECT_EQ(chart["completed"], chart["planned"]);
  EXPECT_EQ(chart["completed"], chart["cases"].size());
  EXPECT_EQ(chart["errors"], Json({"trajectory"}));
  for (const char* key : {"processor", "build", "flags", "commit", "reference"})
    EXPECT_FALSE(chart[key].get<std::string>().empty()) << key;
  EXPECT_NE(chart["omissions"].dump().find("xpbd was not asked for"), std::string::npos);
  for (const Json& done : chart["cases"]) {
    if (done["diverged"]) continue;
    EXPECT_GE(done["processor_seconds"].size(), 2U);
    const auto times = done["processor_seconds"].get<std::vector<double>>();
    EXPECT_EQ(done["seconds"], *std::ranges::min_element(times));
    EXPECT_GT(done["link_solves"], 0);
  }
  for (const char* file : {"small-trajectory.png", "small-trajectory.svg", "small-trajectory-solves.png",
                           "small-trajectory-solves.svg", "small.csv", "chart.html"})
    EXPECT_TRUE(std::filesystem::exists(folder / (std::string("chart/") + file))) << file;
}

// Those run and those left out together, as the progress counts them.
TEST(Chart, CountsTheSameCasesInProgressAndSummary) {
  const TemporaryFolder folder;
  folder.write("small.toml", small_scene());
  const std::vector<std::string> words{"chart",    folder / "small.toml", "--methods", "rattle",
                                       "--errors", "trajectory",          "--budget",  "40s",
                                       "-o",       folder / "chart"};
  const Ran ran = taut(words, cache_in(folder));
  ASSERT_EQ(ran.status, 0) << ran.err;
  std::smatch progress, summary;
  const std::regex counted("([0-9]+)/([0-9]+) cases");
  ASSERT_TRUE(std::regex_search(ran.err, progress, counted)) << ran.err;
  ASSERT_TRUE(std::regex_search(ran.err, summary, std::regex("small: ([0-9]+) of ([0-9]+) cases")))
      << ran.err;
  EXPECT_EQ(progress[2], summary[2]);
  EXPECT_EQ(summary[1], summary[2]);
  const Json chart = Json::parse(read_file(folder / "chart/small.json"));
  std::size_t handled = chart["completed"].get<std::size_t>();
  for (const auto& [why, count] : chart["left_out"].items()) handled += count.get<std::size_t>();
  EXPECT_EQ(summary[1], std::to_string(handled));
}

TEST(Chart, HasItsNotesInACaptionBesideIt) {
  const TemporaryFolder folder;
  folder.write("small.toml", small_scene());
  ASSERT_EQ(chart_to_the_end(folder, "chart").status, 0);
  const Json chart = Json::parse(read_file(folder / "chart/small.json"));
  for (const char* stem : {"small-trajectory", "small-trajectory-solves"}) {
    const std::string caption = read_file(folder / ("chart/" + std::string(stem) + ".txt"));
    EXPECT_NE(caption.find(std::string(stem) + ".svg"), std::string::npos) << caption;
    EXPECT_NE(caption.find(chart["reference"].get<std::string>()), std::string::npos) << caption;
    EXPECT_NE(caption.find(chart["processor"].get<std::string>()), std::string::npos) << caption;
    for (const Json& omission : chart["omissions"])
      EXPECT_NE(caption.find(omission.get<std::string>()), std::string::npos) << omission;
    // What is long stands there, and not on the picture.
    EXPECT_EQ(read_file(folder / ("chart/" + std::string(stem) + ".svg")).find("Left out"),
              std::string::npos);
  }
}

// The folder may come from another machine and build: what was measured is all that it takes.
TEST(Chart, IsDrawnAgainFromItsNumbersAlone) {
  const TemporaryFolder folder;
  folder.write("small.toml", small_scene());
  ASSERT_EQ(chart_to_the_end(folder, "chart").status, 0);
  const std::vector<std::string> drawn{"small-trajectory.svg", "small-trajectory-solves.svg",
                                       "small-trajectory.txt", "chart.html"};
  std::vector<std::string> before;
  for (const std::string& name : drawn) {
    before.push_back(read_file(folder / ("chart/" + name)));
    std::filesystem::remove(folder / ("chart/" + name));
  }
  std::filesystem::remove(folder / "chart/small.cases.jsonl");
  const std::vector<std::string> words{"chart", "small", "--draw-only", "-o", folder / "chart"};
  const Ran ran = taut(words, {{"TAUT_CACHE", folder / "empty"}});
  ASSERT_EQ(ran.status, 0) << ran.err;
  for (std::size_t i = 0; i < drawn.size(); ++i)
    EXPECT_EQ(read_file(folder / ("chart/" + drawn[i])), before[i]) << drawn[i];
  EXPECT_FALSE(std::filesystem::exists(folder / "chart/small.cases.jsonl")) << "nothing was run";
  const Ran missing = taut({"chart", "other", "--draw-only", "-o", folder / "chart"});
  EXPECT_EQ(missing.status, 2);
  EXPECT_NE(missing.err.find("other.json"), std::string::npos) << missing.err;
  folder.write("chart/other.json", "{}");
  EXPECT_EQ(taut({"chart", "other", "--draw-only", "-o", folder / "chart"}).status, 2);
}

TEST(Chart, KilledAtAnyMomentItEndsInTheSameCases) {
  const TemporaryFolder folder;
  folder.write("small.toml", small_scene());
  ASSERT_EQ(chart_to_the_end(folder, "whole").status, 0);
  std::string words;
  for (const std::string& word : chart_words(folder / "small.toml", folder / "killed"))
    words += " '" + word + "'";
  for (const char* moment : {"0.03", "0.11", "0.2", "0.3"}) {
    const std::string script = "'" TAUT_PROGRAM "'" + words + " & process=$!; sleep " + moment +
                               "; kill -KILL $process; wait $process";
    run_program("/bin/sh", {"-c", script}, cache_in(folder));
  }
  ASSERT_EQ(chart_to_the_end(folder, "killed").status, 0);
  EXPECT_EQ(cases_of(folder / "killed/small.json"), cases_of(folder / "whole/small.json"));
  std::istringstream saved(read_file(folder / "killed/small.cases.jsonl"));
  std::vector<std::string> keys;
  std::string line;
  std::getline(saved, line);
  while (std::getline(saved, line)) keys.push_back(Json::parse(line)["case"]);
  EXPECT_EQ(keys.size(), cases_of(folder / "whole/small.json").size());
  std::ranges::sort(keys);
  EXPECT_EQ(std::ranges::adjacent_find(keys), keys.end()) << "a case was run twice";
}

// While the truth is looked for, when there is a file but no case in it, and among the cases.
TEST(Chart, InterruptedItEndsWholeAndSaysSo) {
  for (const char* lines : {"1", "3"}) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("small.toml", small_scene());
    const std::string cases = folder / "chart/small.cases.jsonl";
    const std::string script = "'" TAUT_PROGRAM "' chart '" + scene + "' --budget 3600s -o '" +
                               (folder / "chart") + "' & process=$!; while [ \"$(cat '" + cases +
                               "' 2>/dev/null | wc -l)\" -lt " + lines +
                               " ]; do sleep 0.005; done; kill -INT $process; wait $process";
    const Ran ran = run_program("/bin/sh", {"-c", script}, cache_in(folder));
    EXPECT_EQ(ran.status, 130) << ran.err;
    EXPECT_NE(ran.err.find("running the same again goes on"), std::string::npos) << ran.err;
    const Ran other = taut({"chart", scene, "--budget", "1s", "-o", folder / "chart"}, cache_in(folder));
    EXPECT_EQ(other.status, 4) << "another budget plans other cases: " << other.err;
  }
}

TEST(Chart, SaysWhatItCannotDo) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("small.toml", small_scene());
  const auto error = [&](const std::vector<std::string>& words) {
    std::vector<std::string> all{"chart", scene, "-o", folder / "chart"};
    all.insert(all.end(), words.begin(), words.end());
    const Ran ran = taut(all, cache_in(folder));
    EXPECT_EQ(ran.status, 2) << ran.err;
    return ran.err;
  };
  EXPECT_NE(error({"--errors", "trajektory"}).find("did you mean \"trajectory\"?"), std::string::npos);
  EXPECT_NE(error({"--methods", "ratle"}).find("did you mean \"rattle\"?"), std::string::npos);
  EXPECT_NE(error({"--budget", "0"}).find("--budget must be more than 0 s"), std::string::npos);
  EXPECT_EQ(folder.entries(), 1U) << "nothing was written";
}

// The page, as a browser shows it after a script has used it as a reader would.
TEST(ChartPage, WorksInABrowser) {
  std::optional<std::filesystem::path> browser;
  for (const char* name : {"chromium-headless-shell", "chromium"})
    if (!browser) browser = find_program(name);
  if (!browser) GTEST_SKIP() << "there is no Chromium here; bash app/setup.sh test installs one";
  const TemporaryFolder folder;
  folder.write("small.toml", small_scene());
  ASSERT_EQ(chart_to_the_end(folder, "chart").status, 0);
  std::string page = read_file(folder / "chart/chart.html");
  EXPECT_EQ(page.find("http"), page.find("http://www.w3.org/2000/svg")) << "no part from outside";
  page += R"(<script>
    const dots = () => document.querySelectorAll('circle').length;
    const results = [dots()];
    document.querySelector('circle').dispatchEvent(new MouseEvent('mousemove', { bubbles: true }));
    results.push(document.getElementById('tip').hidden, document.getElementById('tip').textContent);
    document.querySelector('#methods input').click();
    results.push(dots(), location.hash);
    document.title = JSON.stringify(results);
  </script>)";
  const std::string file = folder.write("used.html", page);
  const Ran shown = run_program(browser->string(),
                                {"--headless", "--no-sandbox", "--disable-gpu", "--virtual-time-budget=2000",
                                 "--user-data-dir=" + (folder / "browser"), "--dump-dom", "file://" + file});
  ASSERT_EQ(shown.status, 0) << shown.err;
  const std::size_t from = shown.out.find("<title>") + 7;
  const Json results = Json::parse(shown.out.substr(from, shown.out.find("</title>") - from), nullptr, false);
  ASSERT_TRUE(results.is_array()) << shown.out.substr(0, 2000) << shown.err;
  const Json chart = Json::parse(read_file(folder / "chart/small.json"));
  std::size_t all = 0, rattle = 0;
  for (const Json& done : chart["cases"]) {
    if (done["diverged"]) continue;
    const double error = done["errors"]["trajectory"];
    if (error > 3.0 || error <= chart["smallest_error_judged"]["trajectory"]) continue;
    ++all;
    rattle += done["method"] == "rattle";
  }
  EXPECT_EQ(results[0], all) << "a dot for every case that can be shown";
  EXPECT_EQ(results[1], false);
  EXPECT_NE(results[2].get<std::string>().find("steps per second: "), std::string::npos);
  EXPECT_EQ(results[3], rattle) << "verlet is the first method, and was switched off";
  EXPECT_NE(results[4].get<std::string>().find("without=verlet"), std::string::npos);
}

}  // namespace
}  // namespace taut::testing
