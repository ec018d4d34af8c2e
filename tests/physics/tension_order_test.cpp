// The tension in a State is that at the State's own time, to the order the method says: against the exact one
// of a pendulum and the multipliers at acceleration level along a reference motion.

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "fixtures.h"
#include "measure/exact.h"
#include "scenes_of_the_program.h"

namespace taut::test {
namespace {

struct Variant {
  std::string method;
  double passes = 0.0;
  std::string order = {};
};

Settings settings_of(const Variant& variant, double rate) {
  Settings result = settings(variant.method, rate, variant.passes);
  if (!variant.order.empty()) result.values["order"] = variant.order;
  return result;
}

class SecondOrderTension : public ::testing::TestWithParam<Variant> {
 protected:
  // Order 4 is down to rounding where order 2 has just begun to converge.
  static std::vector<double> rates(double first) {
    if (GetParam().order == "4") first = 50.0;
    return {first, 2.0 * first, 4.0 * first, 8.0 * first};
  }

  // The observed order of an error over steps a second; errors_ has the errors.
  double order_of(const std::vector<double>& all_rates, const std::function<double(double)>& error) {
    std::vector<double> steps, errors;
    errors_.clear();
    for (const double rate : all_rates) {
      steps.push_back(1.0 / rate);
      errors.push_back(error(rate));
      errors_ += fmt::format(" {:.3g} N at {} steps/s", errors.back(), rate);
    }
    return observed_order(steps, errors);
  }

  std::string errors_;
};

TEST_P(SecondOrderTension, OfAPendulumOnItsWay) {
  const Built built = build_valid(pendulum());
  const double order = order_of(rates(500.0), [&](double rate) {
    double worst = 0.0;
    for (const double time : {0.25, 0.5, 0.75}) {
      const State end = run(built, settings_of(GetParam(), rate), time);
      const double exact = 3.0 * 9.81 * std::sin(pendulum_angle_below_level(1.0, 9.81, time));
      worst = std::max(worst, std::abs(end.tension[0] - exact));
    }
    return worst;
  });
  EXPECT_GT(order, 1.9) << errors_;
}

// Everything a method of second order knows as a force: springs with damping, drag, a load, a driven pin.
Description everything(bool damped) {
  Description description = mixed_chain();
  description.chains[0].first_motion.sinusoid = SinusoidSpec{{0.0, 0.05, 0.0}, 8.0, 0.0};
  if (damped) {
    description.loads = {LoadSpec{{"rope.2"}, {0.0, -3.0, 1.0}, 0.0, 0.4}};
  } else {
    description.drag = 0.0;
    description.links[0].properties.damping = 0.0;
  }
  return description;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

TEST_P(SecondOrderTension, OfAChainWithEveryForce) {
  const Built built = build_valid(everything(GetParam().order != "4"));
  const State exact = accurately(built.model, built.start, {0.3}, 1e-12).at(0);
  const double order = order_of(rates(1000.0), [&](double rate) {
    return largest_difference(run(built, settings_of(GetParam(), rate), 0.3).tension, exact.tension);
  });
  EXPECT_GT(order, 1.8) << errors_;
}

// The first steps from a start in motion, where nothing is known of the steps before.
TEST_P(SecondOrderTension, AfterTheFirstSteps) {
  const Built built = build_valid(pendulum());
  State start = built.start;
  start.velocity.set(1, {0.0, -3.0, 0.0});
  for (const std::int64_t count : {1, 2, 3}) {
    const double order = order_of(rates(100.0), [&](double rate) {
      State state = start;
      simulate(built.model, state, settings_of(GetParam(), rate), count);
      const double exact =
          accurately(built.model, start, {static_cast<double>(count) / rate}, 1e-13).at(0).tension[0];
      return std::abs(state.tension[0] - exact);
    });
    EXPECT_GT(order, 1.8) << count << " steps:" << errors_;
  }
}

// A guard halves steps, and the rest of a broken step is a short one.
TEST_P(SecondOrderTension, WhereTheStepChanges) {
  const Built built = build_valid(pendulum());
  const double order = order_of(rates(500.0), [&](double rate) {
    const Settings how = complete_settings(settings_of(GetParam(), rate));
    const auto stepper = find_method(how.method)->make(built.model, how, {});
    stepper->load(built.start);
    double time = 0.0;
    const auto step = [&](double h) {
      time += h;
      stepper->step(h, time);
    };
    for (int i = 0; i < static_cast<int>(0.4 * rate); ++i) step(1.0 / rate);
    double worst = 0.0;
    for (const double share : {0.5, 0.5, 1.0, 0.3, 0.7, 1.0, 1.0, 1.0}) {
      step(share / rate);
      const State& state = stepper->store();
      const double exact = 3.0 * 9.81 * std::sin(pendulum_angle_below_level(1.0, 9.81, state.time));
      worst = std::max(worst, std::abs(state.tension[0] - exact));
    }
    return worst;
  });
  EXPECT_GT(order, 1.8) << errors_;
}

std::string variant_name(const ::testing::TestParamInfo<Variant>& info) {
  return info.param.method + info.param.order +
         (info.param.passes > 0.0 ? fmt::format("{:.0f}", info.param.passes) : "");
}

INSTANTIATE_TEST_SUITE_P(Methods, SecondOrderTension,
                         ::testing::Values(Variant{"shake", 1.0}, Variant{"shake", 16.0}, Variant{"rattle"},
                                           Variant{"rattle", 0.0, "4"}),
                         variant_name);

// verlet's corrections sum to the tension: at rest they hold what hangs below, whatever the masses.
TEST(VerletTension, HoldsWhatHangs) {
  Description description = level_chain(3, 0.5);
  description.chains[0].to = {0.0, -1.5, 0.0};
  const State end = run(build_valid(description), settings("verlet", 600.0, 1.0), 1.0);
  for (std::size_t link = 0; link < 3; ++link)
    EXPECT_NEAR(end.tension[link], 9.81 * static_cast<double>(3 - link), 0.05 * 9.81) << link;
}

// The rope bridge carries 70.9 N in its outermost links, by the balance of forces at every mass.
TEST(VerletTension, OfTheBridge) {
  const Scene scene = scene_called("bridge", {{}, std::string("verlet")});
  State state = scene.start;
  const double rate = scene.settings.steps_per_second();
  simulate(scene.model, state, scene.settings, std::llround(scene.duration * rate));
  EXPECT_NEAR(*std::max_element(state.tension.begin(), state.tension.end()), 70.9, 0.05 * 70.9);
}

}  // namespace
}  // namespace taut::test
