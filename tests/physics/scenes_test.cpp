// Every scene that comes with the program does what it says in [expect]; where its cloth has faces nothing of
// it passes through it, or through a solid, in any frame of a film, and no rope is drawn through a solid.

#include <gtest/gtest.h>

#include <map>

#include "exact_solids.h"
#include "fixtures.h"
#include "frames/simulation.h"
#include "measure/expectation.h"
#include "scenes_of_the_program.h"

namespace taut::test {
namespace {

constexpr double frames_per_second = 30.0;

// Cloth that is shown as what people ask for, and in how many of its frames, at most, some of it is through
// itself: nothing of it is ever in a solid. All but two have faces: the hammock is a net, whose ropes lie
// over each other; the towels hang free.
const std::map<std::string, std::size_t, std::less<>> shown_cloth{
    {"folded-cloth", 0}, {"hammock", 160}, {"knot", 0},       {"laundry-line", 0}, {"poncho", 0},
    {"round-cloth", 0},  {"torn-flag", 0}, {"torn-shirt", 0}, {"turning-table", 0}};

// The frames in which something passes.
struct PassedFrames {
  std::vector<int> cloth, solids, ropes;

  void look(int frame, const Model& model, const State& state) {
    if (exact_tangles(model, state) > 0) cloth.push_back(frame);
    const auto any = [&](const auto& passes) {
      return std::ranges::any_of(model.colliders,
                                 [&](const Collider& solid) { return passes(solid, model, state) > 0; });
    };
    if (any(exact_solid_passes)) solids.push_back(frame);
    if (any(exact_rope_passes)) ropes.push_back(frame);
  }
};

class Scenes : public ::testing::TestWithParam<std::string> {};

TEST_P(Scenes, EndAsTheyExpect) {
  const Scene scene = scene_called(GetParam());
  const auto cloth = shown_cloth.find(GetParam());
  const bool shows_cloth = cloth != shown_cloth.end();
  EXPECT_TRUE(shows_cloth || scene.model.faces.empty()) << "a scene with faces is to be among those";
  Simulation simulation(scene);
  PassedFrames passed;
  for (int frame = 0; frame / frames_per_second < scene.duration; ++frame) {
    const std::optional<State> state = simulation.at(frame / frames_per_second);
    ASSERT_TRUE(state);
    if (shows_cloth || !scene.model.chains.empty()) passed.look(frame, scene.model, *state);
  }
  if (shows_cloth) {
    EXPECT_LE(passed.cloth.size(), cloth->second);
    EXPECT_EQ(passed.solids, std::vector<int>{});
  }
  EXPECT_EQ(passed.ropes, std::vector<int>{});

  const std::optional<State> end = simulation.at(scene.duration);
  ASSERT_TRUE(end);
  const auto findings = check_expectation(scene.expectation, scene.model, *end, simulation.measures(*end));
  EXPECT_FALSE(findings.empty()) << "a scene says what must hold at its end";
  for (const Finding& finding : findings) EXPECT_TRUE(finding.holds) << finding.key << ": " << finding.text;
}

INSTANTIATE_TEST_SUITE_P(Folder, Scenes, ::testing::ValuesIn(scene_names()), case_name);

}  // namespace
}  // namespace taut::test
