#include <gtest/gtest.h>

#include <memory>
#include <new>
#include <optional>
#include <string>

#include "base/failure.h"
#include "panel_runs.h"

namespace taut {
namespace {

// The same pendulum, run as the methods say.
std::vector<Scene> pendulums(const std::vector<std::string>& methods) {
  std::vector<Scene> scenes;
  for (const std::string& method : methods)
    scenes.push_back(parse_scene(R"(
[world]
duration = 1.0
[solve]
method = ")" + method + R"("
steps_per_second = 100
[[mass]]
name = "nail"
position = [0, 0, 0]
pinned = true
[[mass]]
name = "bob"
position = [1, 0, 0]
[[link]]
a = "nail"
b = "bob"
)",
                                 "pendulum.toml"));
  return scenes;
}

State state_at(double time) {
  State state;
  state.time = time;
  return state;
}

PanelState panel_at(double time) {
  return {std::make_shared<const State>(state_at(time)), {}};
}

TEST(MoveOn, TakesTheStateOrStopsWhenTold) {
  PanelState panel = panel_at(1.0);
  EXPECT_TRUE(move_on(panel, [] { return std::optional(state_at(2.0)); }));
  EXPECT_EQ(panel.state->time, 2.0);
  EXPECT_EQ(panel.failure, "");
  EXPECT_FALSE(move_on(panel, [] { return std::optional<State>(); }));
  EXPECT_EQ(panel.state->time, 2.0);
}

TEST(MoveOn, AnyFailureStaysWithItsPanel) {
  const auto failure_of = [](const auto& thrown) {
    PanelState panel = panel_at(1.0);
    EXPECT_TRUE(move_on(panel, [&]() -> std::optional<State> { throw thrown; }));
    EXPECT_EQ(panel.state->time, 1.0) << "it stays where it was";
    return panel.failure;
  };
  EXPECT_EQ(failure_of(RunFailure("a step failed")), "a step failed");
  EXPECT_EQ(failure_of(BadRequest("refused after a break")), "refused after a break");
  EXPECT_EQ(failure_of(std::bad_alloc()), "this machine has not enough memory for that");
  EXPECT_NE(failure_of(7), "");
}

TEST(PanelRuns, GoInStep) {
  const std::vector<Scene> scenes = pendulums({"rattle", "xpbd"});
  PanelRuns runs(scenes);
  const auto panels = runs.at(0.5, {});
  ASSERT_TRUE(panels);
  ASSERT_EQ(panels->size(), 2U);
  EXPECT_EQ((*panels)[0].state->time, 0.5);
  EXPECT_EQ((*panels)[1].state->time, 0.5);
  EXPECT_EQ(runs.measures(0).time, 0.5);
  EXPECT_FALSE(runs.at(1.0, [] { return true; })) << "told to stop";
}

TEST(PanelRuns, GoOnFromWhatWasSaved) {
  for (const std::vector<std::string>& methods : {std::vector<std::string>{"rattle"}, {"rattle", "xpbd"}}) {
    const std::vector<Scene> scenes = pendulums(methods);
    PanelRuns runs(scenes);
    ASSERT_TRUE(runs.at(0.25, {}));
    const std::optional<std::string> saved = runs.save_before(0.5, {});
    ASSERT_TRUE(saved);
    PanelRuns resumed(scenes, *saved);
    EXPECT_EQ(panels_hash(*resumed.at(0.5, {})), panels_hash(*runs.at(0.5, {})));
    EXPECT_EQ(resumed.measures(0).energy_error, runs.measures(0).energy_error);
    EXPECT_THROW(PanelRuns(scenes, saved->substr(0, saved->size() - 1)), BadRequest);
    EXPECT_THROW(PanelRuns(scenes, *saved + "x"), BadRequest) << "more than was saved";
  }
}

// Of several, one that fails after the others went on stays where it was seen last: that is saved, too.
TEST(PanelRuns, OneThatFailsLaterStaysWhereItWasSeen) {
  const std::vector<Scene> scenes = pendulums({"rattle", "xpbd"});
  PanelRuns runs(scenes);
  ASSERT_TRUE(runs.at(0.25, {}));
  PanelRuns resumed(scenes, *runs.save_before(0.5, {}));
  int asked = 0;
  const StopTest failing = [&asked]() -> bool {
    if (++asked == 1) throw RunFailure("it fails");
    return false;
  };
  const auto panels = resumed.at(0.5, failing);
  ASSERT_TRUE(panels);
  EXPECT_EQ((*panels)[0].failure, "it fails");
  EXPECT_EQ((*panels)[0].state->time, 0.25);
  EXPECT_EQ((*panels)[1].state->time, 0.5);
}

}  // namespace
}  // namespace taut
