#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "output/label_layout.h"

namespace taut {
namespace {

TEST(SpreadApart, LeavesAloneWhatHasRoom) {
  const std::vector<double> wanted{70.0, 10.0, 40.0};
  EXPECT_EQ(spread_apart(wanted, 20.0, 0.0, 100.0), wanted);
}

TEST(SpreadApart, KeepsTheGapTheOrderAndTheBounds) {
  const std::vector<double> wanted{50.0, 50.0, 95.0, 51.0, 99.0, 0.0, 2.0, 50.0};
  const std::vector<double> places = spread_apart(wanted, 10.0, 0.0, 100.0);
  std::vector<std::size_t> order(wanted.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return places[i]; });
  for (std::size_t i = 1; i < order.size(); ++i) {
    EXPECT_GE(places[order[i]] - places[order[i - 1]], 10.0 - 1e-9);
    EXPECT_GE(wanted[order[i]], wanted[order[i - 1]]);
  }
  EXPECT_GE(places[order.front()], 0.0);
  EXPECT_LE(places[order.back()], 100.0 + 1e-9);
}

// Three that want the same place share it out evenly around it.
TEST(SpreadApart, MovesAsLittleAsCanBe) {
  EXPECT_EQ(spread_apart({50.0, 50.0, 50.0}, 10.0, 0.0, 100.0), (std::vector<double>{40.0, 50.0, 60.0}));
  EXPECT_EQ(spread_apart({2.0, 2.0}, 10.0, 0.0, 100.0), (std::vector<double>{0.0, 10.0}));
}

TEST(LabelBox, MeetsALineThatCrossesItAndNoOther) {
  const LabelBox box{10.0, 20.0, 10.0, 20.0};
  EXPECT_TRUE(meets(box, {0.0, 15.0, 30.0, 15.0}));
  EXPECT_TRUE(meets(box, {5.0, 5.0, 25.0, 25.0}));
  EXPECT_TRUE(meets(box, {12.0, 12.0, 13.0, 13.0})) << "within";
  EXPECT_FALSE(meets(box, {0.0, 25.0, 30.0, 25.0}));
  EXPECT_FALSE(meets(box, {0.0, 15.0, 5.0, 15.0})) << "ends before it";
  EXPECT_FALSE(meets(box, {0.0, 18.0, 18.0, 36.0})) << "passes its corner";
}

}  // namespace
}  // namespace taut
