#include <gtest/gtest.h>

#include "base/utf8.h"

namespace taut {
namespace {

using namespace std::string_view_literals;

TEST(Utf8Length, CountsTheBytesOfEachKindOfCharacter) {
  EXPECT_EQ(utf8_length("a"), 1U);
  EXPECT_EQ(utf8_length("é"), 2U);
  EXPECT_EQ(utf8_length("√"), 3U);
  EXPECT_EQ(utf8_length("\xf0\x9f\xa7\xb5"), 4U);
  EXPECT_EQ(utf8_length(""), 0U);
}

TEST(Utf8Length, IsZeroForWhatIsNoCharacter) {
  EXPECT_EQ(utf8_length("\x80"), 0U) << "a continuation byte alone";
  EXPECT_EQ(utf8_length("\xc3"), 0U) << "cut short";
  EXPECT_EQ(utf8_length("\xc0\x80"), 0U) << "overlong, two bytes";
  EXPECT_EQ(utf8_length("\xe0\x9f\xbf"), 0U) << "overlong, three bytes";
  EXPECT_EQ(utf8_length("\xf0\x8f\xbf\xbf"), 0U) << "overlong, four bytes";
  EXPECT_EQ(utf8_length("\xed\xa0\x80"), 0U) << "a surrogate";
  EXPECT_EQ(utf8_length("\xf4\x90\x80\x80"), 0U) << "above U+10FFFF";
  EXPECT_EQ(utf8_length("\xff"), 0U);
}

TEST(Utf8Length, TakesTheFirstAndLastOfEachRange) {
  EXPECT_EQ(utf8_length("\xc2\x80"), 2U);
  EXPECT_EQ(utf8_length("\xe0\xa0\x80"), 3U);
  EXPECT_EQ(utf8_length("\xed\x9f\xbf"), 3U);
  EXPECT_EQ(utf8_length("\xf0\x90\x80\x80"), 4U);
  EXPECT_EQ(utf8_length("\xf4\x8f\xbf\xbf"), 4U);
}

TEST(FindInvalidUtf8, IsTheOffsetOfTheFirstBadByte) {
  EXPECT_EQ(find_invalid_utf8("müde √2"), std::string_view::npos);
  EXPECT_EQ(find_invalid_utf8("mü\xffx"), 3U);
  EXPECT_EQ(find_invalid_utf8(""), std::string_view::npos);
}

TEST(Printable, ReplacesWhatMovesTheCursor) {
  EXPECT_EQ(printable("a\x1b[2Jb"), "a\xef\xbf\xbd[2Jb");
  EXPECT_EQ(printable("a\xffz"), "a\xef\xbf\xbdz");
  EXPECT_EQ(printable("a\xc2\x85z"), "a\xef\xbf\xbdz") << "next line, a C1 control";
  EXPECT_EQ(printable("a\xe2\x80\xaez"), "a\xef\xbf\xbdz") << "right-to-left override";
  EXPECT_EQ(printable("müde √2"), "müde √2");
}

TEST(Printable, KeepsTabsOnlyWhenAsked) {
  EXPECT_EQ(printable("a\tb", true), "a\tb");
  EXPECT_EQ(printable("a\tb"),
            "a\xef\xbf\xbd"
            "b");
}

}  // namespace
}  // namespace taut
