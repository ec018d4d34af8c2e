#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "measure/exact.h"
#include "measure/work_precision.h"
#include "model/description.h"
#include "model/measures.h"

namespace taut {
namespace {

// The same pendulum so many times in one place.
Built pendulums(int count) {
  Description description;
  for (int i = 0; i < count; ++i) {
    MassSpec pivot, bob;
    pivot.name = "pivot" + std::to_string(i);
    pivot.pinned = true;
    bob.name = "bob" + std::to_string(i);
    bob.position = {1.0, 0.0, 0.0};
    description.masses.push_back(pivot);
    description.masses.push_back(bob);
    description.links.push_back(LinkSpec{pivot.name, bob.name, 1.0, {}});
  }
  return build(description);
}

Built pendulum() {
  return pendulums(1);
}

// The exact motion of the pendulum, as a truth.
Truth pendulum_truth(const Built& built) {
  Reference reference;
  for (const double time : {0.5, 1.0}) {
    const double angle = pendulum_angle_below_level(1.0, 9.81, time);
    const double speed = std::sqrt(2.0 * 9.81 * std::sin(angle));  // before the first turning point at 1.18 s
    State state = built.start;
    state.time = time;
    for (std::size_t bob = 1; bob < state.position.size(); bob += 2) {
      state.position.set(bob, {std::cos(angle), -std::sin(angle), 0.0});
      state.velocity.set(bob, {-speed * std::sin(angle), -speed * std::cos(angle), 0.0});
    }
    reference.states.push_back(state);
  }
  reference.uncertainty = 1e-12;
  return truth_from(built.model, built.start, reference);
}

TEST(JudgedRun, ErrorsOfAnExactMotionAreNothing) {
  const Built built = pendulum();
  const Truth truth = pendulum_truth(built);
  const Errors errors = judge(built.model, built.start, truth, truth.states);
  EXPECT_EQ(*errors[ErrorKind::trajectory], 0.0);
  EXPECT_LT(*errors[ErrorKind::strain], 1e-15);
  EXPECT_EQ(*errors[ErrorKind::energy], 0.0);
}

// A mass 3 cm off along its link is 3 % of the scene's size off, and stretches it by 3 %.
TEST(JudgedRun, ErrorsAreMeasuredInTheSceneSize) {
  const Built built = pendulum();
  const Truth truth = pendulum_truth(built);
  std::vector<State> states = truth.states;
  states[0].position.set(1, 1.03 * states[0].position.at(1));
  const Errors errors = judge(built.model, built.start, truth, states);
  EXPECT_NEAR(*errors[ErrorKind::trajectory], 0.03, 1e-12);
  EXPECT_NEAR(*errors[ErrorKind::strain], 0.03, 1e-12);
  EXPECT_NEAR(*errors[ErrorKind::energy], 0.03 * std::abs(truth.states[0].position.y[1]), 1e-12);
}

TEST(JudgedRun, OrdersOfConvergenceShow) {
  const Built built = pendulum();
  const Truth truth = pendulum_truth(built);
  const auto error = [&](const MethodVariant& curve, double rate) {
    return *judge_run(built.model, built.start, truth, settings_at(built.model, curve, rate, 1))
                .errors[ErrorKind::trajectory];
  };
  std::map<std::string, double> orders;
  for (const MethodVariant& curve : variants_of(built.model, built.start).variants)
    orders[curve.name] = std::log2(error(curve, 480.0) / error(curve, 960.0));
  EXPECT_NEAR(orders.at("verlet"), 1.0, 0.2);
  EXPECT_NEAR(orders.at("shake"), 2.0, 0.2);
  EXPECT_NEAR(orders.at("rattle order 2"), 2.0, 0.2);
  EXPECT_NEAR(orders.at("rattle order 4"), 4.0, 0.4);
}

TEST(MethodVariants, SayWhatIsLeftOutAndWhy) {
  const Built built = pendulum();
  const MethodVariants curves = variants_of(built.model, built.start, {"spring-implicit", "rattle"});
  ASSERT_EQ(curves.variants.size(), 2U);
  EXPECT_EQ(curves.variants[0].name, "rattle order 2");
  EXPECT_EQ(curves.variants[1].name, "rattle order 4");
  EXPECT_NE(std::ranges::find(curves.omissions, "spring-implicit has no rigid links (without stiffness)"),
            curves.omissions.end());
}

// What a walk does, as text.
std::vector<std::string> walked(const Built& built, const Truth& truth, double most_seconds) {
  const std::vector<MethodVariant> curves = variants_of(built.model, built.start).variants;
  GridWalk walk(built.model, curves, truth, most_seconds);
  std::vector<std::string> points;
  while (const auto point = walk.next()) {
    const MethodVariant& curve = curves[point->curve];
    const Settings settings = settings_at_place(curve, point->fineness, point->row);
    const double passes = curve.passes ? curve.passes->value(point->row) : 1.0;
    points.push_back(curve.name + " " + pace_text(settings) + " " + std::to_string(std::lround(passes)));
    walk.record(judge_run(built.model, built.start, truth, settings));
  }
  const GridWalk::Counts counts = walk.counts();
  EXPECT_EQ(counts.run, points.size());
  EXPECT_EQ(counts.open, 0U);
  std::size_t all = 0;
  for (const MethodVariant& curve : curves)
    all += static_cast<std::size_t>(curve.finer.count) * (curve.relaxes() ? 5 : 1);
  EXPECT_EQ(counts.run + counts.off_front + counts.no_gain + counts.too_dear, all)
      << "every point is accounted for";
  return points;
}

TEST(GridWalk, GoesTheSameWayTwiceRunsNoPointTwiceAndStopsAtItsLimit) {
  const Built built = pendulum();
  const Truth truth = pendulum_truth(built);
  const std::vector<std::string> points = walked(built, truth, 1e-4);
  EXPECT_EQ(points, walked(built, truth, 1e-4));
  std::vector<std::string> sorted = points;
  std::ranges::sort(sorted);
  EXPECT_EQ(std::ranges::adjacent_find(sorted), sorted.end());
  EXPECT_GT(walked(built, truth, 1e-3).size(), points.size());
}

// Links that share no mass are solved by one pass: more passes can't reach the front, and few are tried.
// There are forty, so that passes cost what links cost, and not what a step costs anyway.
TEST(GridWalk, GivesUpPassesThatDoNotPay) {
  const Built built = pendulums(40);
  const Truth truth = pendulum_truth(built);
  const std::vector<MethodVariant> curves = variants_of(built.model, built.start, {"verlet"}).variants;
  GridWalk walk(built.model, curves, truth, 1e-2);
  std::size_t dear = 0;
  while (const auto point = walk.next()) {
    dear += point->row >= 2;
    walk.record(judge_run(built.model, built.start, truth,
                          settings_at_place(curves[0], point->fineness, point->row)));
  }
  EXPECT_LE(dear, 6U);
  EXPECT_GT(walk.counts().off_front, 30U);
}

// Long steps of a dear method wait until short ones of a cheap method have been tried.
TEST(GridWalk, GoesFromCheapToDearOverAllCurves) {
  const Built built = pendulums(40);
  const std::vector<std::string> points = walked(built, pendulum_truth(built), 1e-2);
  const auto place = [&](const char* point) {
    const auto found = std::ranges::find(points, point);
    EXPECT_NE(found, points.end()) << point;
    return found - points.begin();
  };
  EXPECT_LT(place("verlet at 240 steps/s 1"), place("verlet at 60 steps/s 16"));
  EXPECT_LT(place("verlet at 120 steps/s 1"), place("rattle order 4 at 60 steps/s 1"));
}

TEST(ParetoFront, HoldsWhatNothingBeats) {
  const std::vector<double> costs{4.0, 1.0, 2.0, 3.0, 2.0}, errors{0.1, 1.0, 0.5, 0.6, 0.4};
  EXPECT_EQ(pareto_front(costs, errors), (std::vector<std::size_t>{1, 4, 0}));
}

}  // namespace
}  // namespace taut
