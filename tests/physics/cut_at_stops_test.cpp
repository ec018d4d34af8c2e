// Steps that are cut where a hard stop is met: what makes rattle a witness of motion beyond it.

#include "fixtures.h"
#include "model/measures.h"
#include "motion/run.h"
#include "stopped_pendulum.h"

namespace taut::test {
namespace {

// Errors after the elbow has met its stop and left it, and their order.
double order_beyond_a_stop(bool cut, double& finest) {
  const Built built = build_valid(stopped_pendulum());
  constexpr double duration = 1.2;
  const State exact = accurately(built.model, built.start, {duration}, 1e-13).at(0);
  std::vector<double> steps, errors;
  for (const double rate : {1000.0, 2000.0, 4000.0, 8000.0}) {
    // Where in its step the stop is met is as good as random.
    double sum = 0.0;
    for (const double factor : {1.0, 1.07, 1.15, 1.25}) {
      taut::Run run(built.model, built.start, settings("rattle", rate * factor),
                    RunPolicy{.cut_at_stops = cut});
      const std::optional<State> end = run.at(duration);
      EXPECT_TRUE(end) << run.failure();
      if (end) sum += position_error(*end, exact);
    }
    steps.push_back(1.0 / rate);
    errors.push_back(sum / 4.0);
  }
  finest = errors.back();
  return observed_order(steps, errors);
}

TEST(CutAtStops, RattleIsOfSecondOrderBeyondAStopItCutsItsStepAt) {
  double uncut = 0.0, cut = 0.0;
  EXPECT_LT(order_beyond_a_stop(false, uncut), 1.4);
  EXPECT_GT(order_beyond_a_stop(true, cut), 1.8);
  EXPECT_LT(cut, 0.2 * uncut);
}

}  // namespace
}  // namespace taut::test
