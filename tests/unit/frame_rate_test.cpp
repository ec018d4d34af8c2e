#include "base/frame_rate.h"

#include <gtest/gtest.h>

namespace taut {
namespace {

TEST(FrameRate, IsWhatTheTextSaysExactly) {
  const auto text_of = [](const char* text) {
    return frame_rate_from(text).value_or(FrameRate{-1, 1}).text();
  };
  EXPECT_EQ(text_of("30"), "30");
  EXPECT_EQ(text_of("24000/1001"), "24000/1001");
  EXPECT_EQ(text_of("60000/2002"), "30000/1001");
  EXPECT_EQ(text_of("29.97"), "2997/100");
  EXPECT_EQ(text_of("12.50"), "25/2");
  EXPECT_EQ(text_of(".5"), "1/2");
  EXPECT_EQ(text_of("999999999"), "999999999");
  EXPECT_EQ(text_of("0.000000101"), "101/1000000000");
  EXPECT_EQ(text_of("101/1000000000"), "101/1000000000");
  EXPECT_DOUBLE_EQ(frame_rate_from("24000/1001")->value(), 24000.0 / 1001.0);
}

TEST(FrameRate, IsNothingForAnyOtherText) {
  for (const char* text :
       {"1000000001", "",    "0",   "0.0", "30/0",  "0/1",   "-1",          "1/-2",
        "a",          "30 ", " 30", "30.", "1/2/3", "1.5/2", "/",           "/1",
        "1/",         ".",   "1e3", "inf", "nan",   "+5",    "12345678901", "1.0000000001"})
    EXPECT_FALSE(frame_rate_from(text).has_value()) << '"' << text << '"';
}

}  // namespace
}  // namespace taut
