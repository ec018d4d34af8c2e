#include <gtest/gtest.h>

#include <string>

#include "base/failure.h"
#include "frames/frame_selection.h"

namespace taut {
namespace {

using Frames = std::vector<int>;

TEST(SelectFrames, UnderstandsNumbersRangesAndStrides) {
  EXPECT_EQ(select_frames("7", 10), (Frames{7}));
  EXPECT_EQ(select_frames("2-5", 10), (Frames{2, 3, 4, 5}));
  EXPECT_EQ(select_frames("1-8:3", 10), (Frames{1, 4, 7}));
  EXPECT_EQ(select_frames("9,1-3:2,2", 10), (Frames{1, 2, 3, 9}));
  EXPECT_EQ(select_frames("1-10:2147483647", 10), (Frames{1}));
}

TEST(SelectFrames, RefusesWhatItDoesNotUnderstand) {
  for (const char* text :
       {"", ",", "1,", "0", "-1", "3-1", "1-", "a", "1-3:0", "1-3:", "1 - 3", "1.5", "99999999999"})
    EXPECT_THROW(select_frames(text, 10), BadRequest) << '"' << text << '"';
}

TEST(SelectFrames, RefusesFramesBeyondTheLast) {
  EXPECT_NO_THROW(select_frames("10", 10));
  EXPECT_THROW(select_frames("11", 10), BadRequest);
  EXPECT_THROW(select_frames("1-11", 10), BadRequest);
}

TEST(SelectionText, IsTheShortestThatMeansTheSame) {
  for (const char* text : {"1", "1-10", "1-3,5,7-8", "2-3"})
    EXPECT_EQ(selection_text(select_frames(text, 10)), text);
}

TEST(FrameCount, IsDurationTimesRate) {
  EXPECT_EQ(frame_count(8.0, {30}), 240);
  EXPECT_EQ(frame_count(0.1, {30}), 3);  // a little less than 3 in binary
  EXPECT_EQ(frame_count(1.0, {2997, 100}), 29);
  EXPECT_THROW(frame_count(0.01, {30}), BadRequest);
  EXPECT_THROW(frame_count(0.0, {30}), BadRequest);
  EXPECT_THROW(frame_count(1e6, {30}), BadRequest);
}

TEST(FrameTime, StartsAtZero) {
  EXPECT_EQ(frame_time(1, {30}), 0.0);
  EXPECT_EQ(frame_time(31, {30}), 1.0);
  EXPECT_EQ(frame_time(4, {30}), frame_time(7, {60}));
}

TEST(RateOfSelection, EveryNthFrameStandsForNOfThem) {
  const auto rate = [](const std::string& text, const FrameRate& whole) {
    return rate_of_selection(select_frames(text, 200), whole).text();
  };
  EXPECT_EQ(rate("1-200", {30}), "30");
  EXPECT_EQ(rate("1-10:2", {30}), "15");
  EXPECT_EQ(rate("1-10:4", {30}), "15/2");
  EXPECT_EQ(rate("1-100:2", {24000, 1001}), "12000/1001");
  EXPECT_EQ(rate("7", {30}), "30");
  EXPECT_EQ(rate("1-99:2,150", {30}), "15") << "what is left out at the end is a cut";
  EXPECT_EQ(rate("1-5,150", {30}), "30");
}

}  // namespace
}  // namespace taut
