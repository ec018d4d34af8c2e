#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/failure.h"
#include "frames/exact_shape.h"

namespace taut {
namespace {

Scene chain(const std::string& more, const std::string& world = "") {
  return parse_scene(R"(
[world]
duration = 1.0
)" + world + R"(
[[chain]]
name = "rope"
from = [0, 2, 0]
to = [1, 2, 0]
links = 4
)" + more + R"(
[look]
exact = true
)",
                     "chain.toml");
}

TEST(ExactShape, OfAChainFromOnePinHangsStraightDown) {
  const Scene scene = chain("pinned = [\"first\"]");
  EXPECT_EQ("", exact_problem(scene));
  const std::optional<State> shape = exact_shape(scene);
  ASSERT_TRUE(shape);
  for (std::size_t i = 0; i <= 4; ++i)
    EXPECT_NEAR(0.0, (shape->position.at(i) - Vec3(0.0, 2.0 - 0.25 * static_cast<double>(i), 0.0)).norm(),
                1e-12);
}

TEST(ExactShape, IsNotLookedForUnasked) {
  Scene scene = chain("");
  scene.look.exact = false;
  EXPECT_EQ("", exact_problem(scene));
  EXPECT_FALSE(exact_shape(scene));
}

TEST(ExactShape, IsRefusedWhereThereIsNone) {
  const auto expect_refused = [](const Scene& scene, const std::string& reason) {
    EXPECT_NE(std::string::npos, exact_problem(scene).find(reason)) << exact_problem(scene);
    EXPECT_THROW(require_exact(scene), BadRequest);
  };
  expect_refused(chain(""), "nothing is pinned");
  expect_refused(chain("pinned = [\"first\"]\nbreak_tension = 5"), "links may break");
  expect_refused(
      chain("pinned = [\"first\"]\nfirst_motion = { amplitude = [0, 0.1, 0], angular_frequency = 3 }"),
      "swings for ever");
  expect_refused(chain("pinned = [\"first\"]\nradius = 0.01\n[[plane]]\n"), "newton");
}

}  // namespace
}  // namespace taut
