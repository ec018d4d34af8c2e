#include "render/colour_range.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "colour_vision.h"
#include "geometry/colour_scale.h"

namespace taut {
namespace {

TEST(ColourRange, EndsWhereAllButTwoPerCentStayBelow) {
  ColourRange range(ColourBy::strain);
  for (int i = 0; i < 980; ++i) range.add(0.019);
  for (int i = 0; i < 20; ++i) range.add(5.0);
  EXPECT_NEAR(range.top(), 0.02, 1e-12);
  for (int i = 0; i < 20; ++i) range.add(5.0);
  EXPECT_NEAR(range.top(), 5.0, 1e-9) << "now more than two per cent";
}

TEST(ColourRange, CountsWhatIsAtRestButIsNotLedByItAlone) {
  ColourRange range(ColourBy::speed);
  EXPECT_EQ(range.top(), 1.0);
  for (int i = 0; i < 1000; ++i) range.add(0.0);
  EXPECT_EQ(range.top(), 1.0);
  range.add(0.3);
  EXPECT_NEAR(range.top(), 0.3, 1e-12);
  for (int i = 0; i < 1000; ++i) {
    range.add(std::numeric_limits<double>::infinity());
    range.add(std::nan(""));
  }
  EXPECT_NEAR(range.top(), 0.3, 1e-12) << "what is no number counts for nothing";
}

TEST(ColourRange, IsTheSameInAnyOrder) {
  ColourRange one(ColourBy::tension), other(ColourBy::tension);
  for (int i = 1; i <= 500; ++i) one.add(0.01 * i);
  for (int i = 500; i >= 1; --i) other.add(0.01 * i);
  EXPECT_EQ(one.top(), other.top());
  EXPECT_NEAR(one.top(), 5.0, 1e-12);
}

TEST(RoundNumberAbove, IsNeverBelowAndAtMostAFourthAbove) {
  for (double value = 1e-7; value < 1e7; value *= 1.07) {
    const double round = round_number_above(value);
    EXPECT_GE(round, value / 1.01 * (1.0 - 1e-12));
    EXPECT_LE(round, 1.34 * value);
    EXPECT_DOUBLE_EQ(round_number_above(round), round);
  }
  EXPECT_EQ(round_number_above(0.0), 1.0);
}

TEST(ColourScale, SpreadsLogarithmsOverThreeDecades) {
  const ColourScale log{2.0, Theme::light, ColourSteps::log}, linear{2.0, Theme::light};
  EXPECT_EQ(log.at(2.0), linear.at(2.0));
  EXPECT_EQ(log.at(2e-3), linear.at(0.0));
  EXPECT_EQ(log.at(0.0), linear.at(0.0));
  EXPECT_NEAR(log.at(2.0 * std::pow(10.0, -1.5))[0], linear.at(1.0)[0], 1e-12);
  for (const double share : {0.0, 0.2, 0.5, 1.0}) {
    EXPECT_NEAR(log.at(log.value_at(share))[1], linear.at(linear.value_at(share))[1], 1e-9);
  }
}

// Linear light of a colour as displayed.
std::array<double, 3> linear(const Colour& colour) {
  std::array<double, 3> light{};
  for (std::size_t i = 0; i < 3; ++i)
    light[i] = colour[i] <= 0.04045 ? colour[i] / 12.92 : std::pow((colour[i] + 0.055) / 1.055, 2.4);
  return light;
}

double luminance_of(const std::array<double, 3>& light) {
  return 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2];
}

TEST(ColourScale, KeepsItsOrderInGreyAndWithoutGreenCones) {
  for (const Theme theme : {Theme::light, Theme::dark}) {
    const ColourScale scale{1.0, theme};
    double last = -1.0, last_without = -1.0;
    for (int i = 0; i <= 32; ++i) {
      const std::array<double, 3> light = linear(scale.at(i / 32.0));
      EXPECT_GT(luminance_of(light), last) << i;
      EXPECT_GT(luminance_of(testing::without_green_cones(light)), last_without) << i;
      last = luminance_of(light);
      last_without = luminance_of(testing::without_green_cones(light));
    }
    EXPECT_GT((last + 0.05) / (luminance_of(linear(scale.at(0.0))) + 0.05), 4.0) << "the ends are far apart";
  }
}

}  // namespace
}  // namespace taut
