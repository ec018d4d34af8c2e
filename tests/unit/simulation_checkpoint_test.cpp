#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/failure.h"
#include "frames/simulation.h"
#include "methods/registry.h"

namespace taut {
namespace {

// A sheet that falls on a ball with friction, hangs by a driven pin, and tears.
std::string torn_cloth(std::string_view method) {
  return fmt::format(R"([world]
duration = 1.5
[solve]
method = "{}"
[[sheet]]
name = "cloth"
rows = 5
columns = 5
from = [0, 1.5, 0]
to = [1, 1.5, 0]
down = [0, -1, 0.2]
pinned = ["top-left", "top-right"]
stiffness = 400
break_stretch = 1.25
[[mass]]
name = "hand"
position = [2, 1, 0]
pinned = true
motion = {{ amplitude = [0, 0.1, 0], angular_frequency = 9.0, phase = 0.0 }}
[[mass]]
name = "bob"
position = [2.5, 1, 0]
[[link]]
a = "hand"
b = "bob"
stiffness = 300
[[load]]
masses = ["cloth.4.*"]
force = [0, -30, 0]
from = 0.2
to = 0.6
[look]
trails = ["bob"]
trail_time = 0.3
)",
                     method);
}

std::vector<double> frame_times(double per_second) {
  std::vector<double> times;
  for (int i = 0; i <= static_cast<int>(1.2 * per_second); ++i) times.push_back(i / per_second);
  return times;
}

class CheckpointTest : public ::testing::TestWithParam<std::tuple<std::string_view, double>> {};

// Taken before any frame, gone on from, every later frame is the same: also of a method whose steps are
// longer than a frame, and of one that chooses its own.
TEST_P(CheckpointTest, GoesOnBitForBit) {
  const auto [method, per_second] = GetParam();
  const Scene scene = parse_scene(torn_cloth(method), "test.toml");
  const std::vector<double> times = frame_times(per_second);
  Simulation whole(scene);
  struct Saved {
    std::size_t frame;
    std::string bytes;
  };
  std::vector<Saved> saved;
  std::vector<std::uint64_t> hashes;
  std::vector<std::size_t> trail_points;
  std::vector<double> energy_errors;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (i % 7 == 3)
      if (const auto state = whole.save_before(times[i])) saved.push_back({i, to_bytes(*state)});
    const State state = *whole.at(times[i]);
    hashes.push_back(state_hash(state));
    trail_points.push_back(whole.trails(state)->front().size());
    energy_errors.push_back(whole.measures(state).energy_error);
  }
  Simulation undisturbed(scene);
  for (std::size_t i = 0; i < times.size(); ++i)
    ASSERT_EQ(state_hash(*undisturbed.at(times[i])), hashes[i]) << "taking a checkpoint changed frame " << i;
  ASSERT_GE(saved.size(), 2U);
  for (const Saved& from : saved) {
    Simulation resumed(scene, from.bytes);
    for (std::size_t i = from.frame; i < times.size(); ++i) {
      const State state = *resumed.at(times[i]);
      ASSERT_EQ(state_hash(state), hashes[i]) << "from " << from.frame << ", frame " << i;
      ASSERT_EQ(resumed.trails(state)->front().size(), trail_points[i]);
      ASSERT_EQ(resumed.measures(state).energy_error, energy_errors[i]);
    }
  }
}

// Those that take such a scene, which leaves out those for rigid links alone.
std::vector<std::string_view> method_names() {
  const Scene scene = parse_scene(torn_cloth("xpbd"), "test.toml");
  std::vector<std::string_view> names;
  for (const Method& method : all_methods())
    if (refusals(scene.model, scene.start, complete_settings({std::string(method.name), {}})).empty())
      names.push_back(method.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Methods, CheckpointTest,
                         ::testing::Combine(::testing::ValuesIn(method_names()),
                                            ::testing::Values(30.0, 170.0, 1000.0)));

TEST(Checkpoint, OfAnotherSceneIsRefused) {
  const Scene scene = parse_scene(torn_cloth("xpbd"), "test.toml");
  Simulation simulation(scene);
  simulation.at(0.1);
  const std::optional<SavedSimulation> saved = simulation.save_before(0.5);
  ASSERT_TRUE(saved);
  const std::string bytes = to_bytes(*saved);
  EXPECT_NO_THROW(Simulation(scene, bytes));
  std::string other = torn_cloth("xpbd");
  other.replace(other.find("rows = 5"), 8, "rows = 6");
  const Scene larger = parse_scene(other, "test.toml");
  EXPECT_THROW(Simulation(larger, bytes), BadRequest);
  EXPECT_THROW(Simulation(scene, bytes.substr(0, bytes.size() / 2)), BadRequest);
}

}  // namespace
}  // namespace taut
