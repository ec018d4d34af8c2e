// Plans of scenes in which something lands: what is promised is kept, as far as it is promised.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "fixtures.h"
#include "impact_reference.h"
#include "impact_scenes.h"
#include "measure/quick_plan.h"
#include "model/measures.h"
#include "motion/simulate.h"
#include "scenes_of_the_program.h"
#include "study/scene_plan.h"
#include "temporary_folder.h"

namespace taut::test {
namespace {

// Where the masses are at a time (s), by other means than the plan's; asked for at rising times.
using TruthAt = std::function<State(double)>;

Scene scene_of(const Description& description, double duration) {
  Scene scene;
  scene.name = "landing";
  scene.description = description;
  scene.duration = duration;
  scene.settings = complete_settings({"xpbd", {}});
  Built built = build_valid(description);
  scene.model = std::move(built.model);
  scene.start = std::move(built.start);
  return scene;
}

// Returns how much of the run is promised.
double expect_kept(const Scene& scene, const Plan& plan, const TruthAt& truth) {
  SCOPED_TRACE(plan.why + "; " + accuracy_sentence(plan));
  if (!plan.reached) return 0.0;
  std::vector<double> times;
  for (int i = 1; i / 60.0 <= plan.judged_until + 1e-9; ++i) times.push_back(i / 60.0);
  const SampledRun run = sampled_run(scene.model, scene.start, plan.settings, times);
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_LE(position_error(run.states.at(i), truth(times[i])), plan.wanted * plan.size) << times[i] << " s";
  return plan.judged_share();
}

// By rule for 10 %, and by a search of some seconds for 1 %.
void expect_promises_kept(const Scene& scene, const std::function<TruthAt()>& truth, double least_share) {
  const Plan quick =
      quick_plan(scene.model, scene.start, scene.duration, {ErrorKind::trajectory, 0.1, false});
  EXPECT_GE(expect_kept(scene, quick, truth()), least_share) << quick.why;
  const testing::TemporaryFolder folder;
  const Plan searched = plan_scene(scene, {{ErrorKind::trajectory, 0.01, false}, {}, 3.0, {}}, folder.path());
  EXPECT_GE(expect_kept(scene, searched, truth()), least_share) << searched.why;
}

TruthAt event_driven(const Scene& scene) {
  const auto reference = std::make_shared<ImpactReference>(scene.model, scene.start, 1e-3);
  return [reference](double time) { return reference->at(time); };
}

TEST(PlansPastImpacts, OfAChainThatLands) {
  const Scene scene = scene_of(landing_chain(), 0.4);
  expect_promises_kept(
      scene, [&] { return event_driven(scene); }, 0.9);
}

TEST(PlansPastImpacts, OfABallThatLandsBesideASwingingChain) {
  Description description = level_chain(5, 0.2);
  MassSpec ball;
  ball.name = "ball";
  ball.position = {2.0, -1.0, 0.0};
  ball.radius = 0.1;
  PlaneSpec ground;
  ground.point = {0.0, -1.5, 0.0};
  ground.friction = 0.0;
  description.masses.push_back(ball);
  description.planes = {ground};
  const Scene scene = scene_of(description, 0.6);
  expect_promises_kept(
      scene, [&] { return event_driven(scene); }, 0.9);
}

TEST(PlansPastImpacts, OfABouncingBall) {
  constexpr double radius = 0.1, height = 1.5, restitution = 0.6, gravity = 9.81;
  Description description;
  MassSpec ball;
  ball.name = "ball";
  ball.position = {0.0, height, 0.0};
  ball.radius = radius;
  PlaneSpec ground;
  ground.restitution = restitution;
  description.masses = {ball};
  description.planes = {ground};
  const Scene scene = scene_of(description, 1.2);
  const TruthAt parabolas = [&](double time) {
    const double landing = std::sqrt(2.0 * (height - radius) / gravity);
    double begin = -landing, speed = gravity * landing;
    while (time >= begin + 2.0 * speed / gravity) {
      begin += 2.0 * speed / gravity;
      speed *= restitution;
    }
    State state = scene.start;
    const double since = time - begin;
    state.position.set(0, Vec3(0.0, radius + speed * since - 0.5 * gravity * since * since, 0.0));
    return state;
  };
  expect_promises_kept(
      scene, [&] { return parabolas; }, 0.9);
}

// Runs of different kinds with steps too long for its landing agree with each other to the end, and not with
// what many passes at short steps make of the first touch.
TEST(PlansPastImpacts, OfALongChainThatLandsByItsEnd) {
  Description description = level_chain(34, 0.0841);
  description.drag = 0.947;
  ChainSpec& rope = description.chains[0];
  rope.pinned.clear();
  rope.from = {0.0, 3.0, 0.0};
  rope.to = {2.5739, 1.7528, 0.0};
  rope.mass = 0.967;
  rope.radius = 0.02;
  PlaneSpec ground;
  ground.point = {0.0, 1.433, 0.0};
  ground.friction = 0.04;
  description.planes = {ground};
  const Scene scene = scene_of(description, 1.98);
  Plan plan =
      quick_plan(scene.model, scene.start, scene.duration, {ErrorKind::trajectory, 0.01, false}, {}, {}, 3.0);
  plan.judged_until = std::min(plan.judged_until, 0.38);
  taut::Run many(scene.model, scene.start, settings("verlet", 15360.0, 64));
  EXPECT_GT(expect_kept(scene, plan, [&](double time) { return *many.at(time); }), 0.0);
}

// Chaotic from the first touch on, and beyond any event-driven answer: the end of the promise is stated, and
// as far as it goes a run with a sixteenth of the step is no further off.
TEST(PlansPastImpacts, OfARagdollOnAStair) {
  const Scene scene = scene_called("ragdoll-drop");
  const Plan plan = quick_plan(scene.model, scene.start, scene.duration, {ErrorKind::trajectory, 0.1, false});
  EXPECT_LT(plan.judged_share(), 1.0);
  Settings fine = plan.settings;
  fine.values["steps_per_second"] = 16.0 * plan.settings.steps_per_second();
  taut::Run finer(scene.model, scene.start, fine);
  EXPECT_GT(expect_kept(scene, plan, [&](double time) { return *finer.at(time); }), 0.0);
}

}  // namespace
}  // namespace taut::test
