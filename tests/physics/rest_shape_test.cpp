#include "measure/rest_shape.h"

#include <gtest/gtest.h>

#include "base/failure.h"
#include "model/measures.h"
#include "scenes_of_the_program.h"

namespace taut::test {
namespace {

Settings verlet(double passes) {
  return {"verlet", {{"steps_per_second", 60.0}, {"passes", passes}}};
}

TEST(RestShape, TheExactCurveIsWhereRattleComesToRest) {
  const Scene scene = scene_called("hanging-chain-two-pins");
  const RestShape exact = exact_rest_shape(scene.model, scene.start, {});
  const RestShape settled = settle(scene.model, scene.start, {"rattle", {{"steps_per_second", 1200.0}}}, {});
  ASSERT_TRUE(settled.at_rest);
  // A pixel of a picture 2000 pixels wide is 1e-3 m.
  EXPECT_LT(position_error(settled.state, exact.state), 5e-5);
}

TEST(RestShape, AChainWithAFreeEndHangsStraightDown) {
  const Scene scene = scene_called("hanging-chain");
  const RestShape exact = exact_rest_shape(scene.model, scene.start, {});
  EXPECT_EQ(exact.how, "balance of forces");
  EXPECT_NEAR(sag(scene.model, exact.state), 2.0, 1e-12);
  for (std::size_t i = 0; i < exact.state.position.size(); ++i)
    EXPECT_EQ(exact.state.position.x[i], exact.state.position.x[0]);
  // 40 masses of 0.4 kg / 41 hang on the first link.
  EXPECT_NEAR(exact.state.tension[0], 0.4 * 40.0 / 41.0 * 9.81, 1e-12);
}

TEST(RestShape, AnElasticChainStretchesByTheWeightBelowEachLink) {
  const Scene scene = parse_scene(R"(
[[chain]]
name = "rope"
from = [0, 0, 0]
to = [1, 0, 0]
links = 4
mass = 5.0
stiffness = 1000.0
pinned = ["first"]
)",
                                  "elastic.toml");
  const RestShape exact = exact_rest_shape(scene.model, scene.start, {});
  // 4, 3, 2 and 1 masses of 1 kg below the links.
  EXPECT_NEAR(sag(scene.model, exact.state), 1.0 + 10.0 * 9.81 / 1000.0, 1e-12);
  const RestShape settled = settle(scene.model, scene.start, {"newton", {}}, {});
  EXPECT_LT(position_error(settled.state, exact.state), 1e-5);
}

TEST(RestShape, SagShrinksToTheExactOneAsPassesGrow) {
  const Scene scene = scene_called("hanging-chain-two-pins");
  const double exact = sag(scene.model, exact_rest_shape(scene.model, scene.start, {}).state);
  double last = infinity;
  for (const double passes : {4.0, 8.0, 16.0, 32.0, 64.0}) {
    const RestShape shape = settle(scene.model, scene.start, verlet(passes), {});
    ASSERT_TRUE(shape.at_rest);
    const double error = sag(scene.model, shape.state) - exact;
    EXPECT_GT(error, 0.0);
    if (last < infinity) {
      EXPECT_NEAR(last / error, 2.0, 0.15);  // one over the passes
    }
    last = error;
  }
}

TEST(RestShape, ANetIsJudgedByNewtonAtAnyStep) {
  const Scene scene = parse_scene(R"(
[[sheet]]
name = "net"
rows = 6
columns = 6
from = [0, 1, 0]
to = [0.8, 1, 0]
down = [0, -1, 0]
fullness = 1.25
mass = 1.0
pinned = ["top-left", "top-right"]
)",
                                  "net.toml");
  const RestShape coarse = settle(scene.model, scene.start, {"newton", {{"steps_per_second", 120.0}}}, {});
  const RestShape fine = settle(scene.model, scene.start, {"newton", {{"steps_per_second", 480.0}}}, {});
  ASSERT_TRUE(coarse.at_rest && fine.at_rest);
  EXPECT_LT(position_error(coarse.state, fine.state), 1e-4);
}

TEST(RestShape, APinThatSwingsForEverHasNone) {
  const Scene scene = parse_scene(R"(
[[mass]]
name = "hand"
position = [0, 0, 0]
mass = 1.0
pinned = true
motion = { amplitude = [0, 0.1, 0], angular_frequency = 10.0 }
[[mass]]
name = "bob"
position = [1, 0, 0]
mass = 1.0
[[link]]
a = "hand"
b = "bob"
)",
                                  "swinging.toml");
  EXPECT_THROW(settle(scene.model, scene.start, {"newton", {}}, {}), BadRequest);
}

}  // namespace
}  // namespace taut::test
