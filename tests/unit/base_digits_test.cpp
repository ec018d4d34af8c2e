#include <gtest/gtest.h>

#include <limits>

#include "base/digits.h"

namespace taut {
namespace {

TEST(TwoDigits, AreWrittenOut) {
  EXPECT_EQ(two_digits(0.0583), "0.058");
  EXPECT_EQ(two_digits(1.0), "1");
  EXPECT_EQ(two_digits(9.96), "10");
  EXPECT_EQ(two_digits(99.6), "100");
  EXPECT_EQ(two_digits(1481.0), "1500");
  EXPECT_EQ(two_digits(148900.0), "150000");
  EXPECT_EQ(two_digits(std::numeric_limits<double>::infinity()), "inf");
}

TEST(Percent, HasTwoDigitsOrABound) {
  EXPECT_EQ(percent(0.0058), "0.58 %");
  EXPECT_EQ(percent(14.81), "1500 %");
  EXPECT_EQ(percent(1.1e-6), "0.00011 %");
  EXPECT_EQ(percent(4.2e-11), "below 0.0001 %");
  EXPECT_EQ(percent(0.0), "below 0.0001 %");
}

TEST(WithPowerOfTen, IsWrittenAsPeopleDo) {
  EXPECT_EQ(with_power_of_ten(0.01), "0.01");
  EXPECT_EQ(with_power_of_ten(1e-6), "10⁻⁶");
  EXPECT_EQ(with_power_of_ten(3e-12), "3·10⁻¹²");
  EXPECT_EQ(with_power_of_ten(2.5e9), "2.5·10⁹");
}

}  // namespace
}  // namespace taut
