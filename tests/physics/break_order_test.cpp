// The moment of a break within a step, and the motion after it, are of the order of the method.

#include <algorithm>

#include "fixtures.h"
#include "measure/exact.h"
#include "methods/breaking.h"
#include "model/measures.h"

namespace taut::test {
namespace {

State run_with_breaks(const Model& model, const State& start, const Settings& how, double duration) {
  State state = start;
  const RunReport report =
      simulate(model, state, how, std::llround(duration * complete_settings(how).steps_per_second()));
  EXPECT_EQ(report.end, RunEnd::none);
  return state;
}

class BreakOfSecondOrder : public ::testing::TestWithParam<std::string> {
 protected:
  struct Errors {
    double time = 0.0, place = 0.0, velocity = 0.0;
  };
  struct Orders {
    double time = 0.0, place = 0.0, velocity = 0.0;
  };

  // Where a break falls in its step makes single errors uneven: the largest of several steps nearly as long.
  template <class Error>
  static Orders orders(const Error& error) {
    std::vector<double> steps, times, places, velocities;
    for (const double rate : {400.0, 800.0, 1600.0, 3200.0}) {
      Errors largest;
      for (const double factor : {1.0, 1.05, 1.1, 1.15, 1.25}) {
        const Errors errors = error(rate * factor);
        largest.time = std::max(largest.time, errors.time);
        largest.place = std::max(largest.place, errors.place);
        largest.velocity = std::max(largest.velocity, errors.velocity);
      }
      steps.push_back(1.0 / rate);
      times.push_back(largest.time);
      places.push_back(largest.place);
      velocities.push_back(largest.velocity);
    }
    return {observed_order(steps, times), observed_order(steps, places), observed_order(steps, velocities)};
  }
};

TEST_P(BreakOfSecondOrder, PendulumByTension) {
  Description description = pendulum();
  description.links[0].properties.break_tension = 20.0;
  const Built built = build_valid(description);
  const double angle = std::asin(20.0 / (3.0 * 9.81));
  double low = 0.0, high = 0.59;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (pendulum_angle_below_level(1.0, 9.81, middle) < angle ? low : high) = middle;
  }
  const double speed = std::sqrt(2.0 * 9.81 * std::sin(angle)), flight = 0.8 - low;
  const Vec3 g(0.0, -9.81, 0.0), velocity = speed * Vec3(-std::sin(angle), -std::cos(angle), 0.0);
  const Vec3 place =
      Vec3(std::cos(angle), -std::sin(angle), 0.0) + flight * velocity + 0.5 * flight * flight * g;
  const Orders order = orders([&](double rate) -> Errors {
    const State end = run_with_breaks(built.model, built.start, settings(GetParam(), rate, 4.0), 0.8);
    return {std::abs(end.broken_at[0] - low), (end.position.at(1) - place).norm(),
            (end.velocity.at(1) - velocity - flight * g).norm()};
  });
  EXPECT_GT(order.time, 1.8);
  EXPECT_GT(order.place, 1.8);
  EXPECT_GT(order.velocity, 1.8);
}

// A mass of 1 kg thrown outward on a spring of 100 N/m without gravity: stretch 0.2 m × sin(10 t).
TEST_P(BreakOfSecondOrder, SpringByStretch) {
  Description description = pendulum();
  description.gravity = Vec3::Zero();
  description.masses[1].velocity = {2.0, 0.0, 0.0};
  description.links[0].properties.stiffness = 100.0;
  description.links[0].properties.break_stretch = 1.1;
  const Built built = build_valid(description);
  const double exact_time = std::asin(0.5) / 10.0, speed = 2.0 * std::sqrt(0.75);
  const Orders order = orders([&](double rate) -> Errors {
    const State end = run_with_breaks(built.model, built.start, settings(GetParam(), rate, 4.0), 0.2);
    return {std::abs(end.broken_at[0] - exact_time),
            std::abs(end.position.x[1] - 1.1 - (0.2 - exact_time) * speed),
            std::abs(end.velocity.x[1] - speed)};
  });
  EXPECT_GT(order.time, 1.8);
  EXPECT_GT(order.place, 1.8);
  EXPECT_GT(order.velocity, 1.8);
}

// The middle link of a swinging chain goes: what is left on either side moves on.
TEST_P(BreakOfSecondOrder, ChainByTension) {
  Description description = level_chain(3, 0.4);
  description.drag = 0.3;
  Built built = build_valid(description);
  constexpr double threshold = 15.0, duration = 0.4;
  const auto state_at = [&](double time) {
    return accurately(built.model, built.start, {time}, 1e-13).at(0);
  };
  double low = 0.02, high = duration;
  ASSERT_LT(state_at(low).tension[1], threshold);
  ASSERT_GT(state_at(high).tension[1], threshold);
  for (int i = 0; i < 45; ++i) {
    const double middle = 0.5 * (low + high);
    (state_at(middle).tension[1] < threshold ? low : high) = middle;
  }
  State broken = state_at(low);
  broken.broken_at[1] = broken.time;
  const State exact = accurately(built.model, broken, {duration + 0.2}, 1e-13).at(0);
  built.model.links.break_tension[1] = threshold;
  built.model.breakable_links = {1};
  const Orders order = orders([&](double rate) -> Errors {
    const State end =
        run_with_breaks(built.model, built.start, settings(GetParam(), rate, 64.0), duration + 0.2);
    return {std::abs(end.broken_at[1] - low), position_error(end, exact), 1.0 / (rate * rate)};
  });
  EXPECT_GT(order.time, 1.8);
  EXPECT_GT(order.place, 1.8);
}

INSTANTIATE_TEST_SUITE_P(Registry, BreakOfSecondOrder,
                         ::testing::ValuesIn(methods_that([](const Capabilities& can) {
                           return can.rigid && can.stiffness && can.tension_order >= 2 && !can.chooses_steps;
                         })),
                         case_name);

}  // namespace
}  // namespace taut::test
