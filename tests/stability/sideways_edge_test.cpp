// The edge of rattle with the guard off against √(m l/T): light links under tension vibrate sideways.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "measure/stability.h"
#include "measure/stability_edge.h"
#include "measure/stability_limit.h"
#include "physics/fixtures.h"

namespace taut::test {
namespace {

// Over longer times the largest tension is that of a short snap, which can be over before the vibration has
// grown: at 1 s the edge of one of the chains below is at 1.32 √(m l/T).
constexpr double duration = 0.7;  // s

Built chain_with_tip(double ratio) {
  Description description = level_chain(20, 0.1);
  description.chains[0].last_mass = ratio;
  return build_valid(description);
}

TEST(SidewaysEdge, OfRattleFollowsTheTension) {
  std::vector<double> tensions, edges;
  for (const double ratio : {1.0, 10.0, 100.0, 1000.0, 10000.0}) {
    SCOPED_TRACE(ratio);
    const Built built = chain_with_tip(ratio);
    const auto largest = largest_tensions(built.model, built.start, duration);
    ASSERT_TRUE(largest.has_value());
    const auto predicted = predicted_step(built.model, built.start, *find_method("rattle"), largest);
    ASSERT_TRUE(predicted.has_value());
    const auto holds = [&](double h) {
      const auto steps = static_cast<std::int64_t>(std::ceil(duration / h));
      return !run_unguarded(built.model, built.start, settings("rattle", 1.0 / h), steps).failed();
    };
    const auto edge = find_edge(holds, 0.2 * predicted->value, 5.0 * predicted->value);
    ASSERT_TRUE(edge.has_value());
    tensions.push_back(*std::max_element(largest->begin(), largest->end()));
    edges.push_back(edge->value());
    const double quotient = edge->value() / std::sqrt(1.0 * 0.1 / tensions.back());
    EXPECT_GT(quotient, 0.5);
    EXPECT_LT(quotient, 1.2);
  }
  EXPECT_NEAR(observed_order(tensions, edges), -0.5, 0.1);
}

}  // namespace
}  // namespace taut::test
