#include "base/diagnostic.h"

#include <gtest/gtest.h>

#include <string>

#include "base/utf8.h"

namespace taut {
namespace {

constexpr std::string_view source_text = "[solve]\nmethod = \"xpbd\"\ncomplance = 1\n";

TEST(Diagnostic, NamesPlaceLineCaretAndHint) {
  const Diagnostic diagnostic{"scenes/cloth.toml", 3, 1, "unknown key \"complance\" in [solve]",
                              did_you_mean("compliance", "m/N")};
  EXPECT_EQ(to_text(diagnostic, source_text),
            "scenes/cloth.toml:3:1: unknown key \"complance\" in [solve]\n"
            "    complance = 1\n"
            "    ^\n"
            "    did you mean \"compliance\" (m/N)?");
}

TEST(Diagnostic, WithoutAPlaceHasNoLine) {
  EXPECT_EQ(to_text({"--set drag=x", 0, 0, "not so", "try this"}, source_text),
            "--set drag=x: not so\n    try this");
}

TEST(Diagnostic, CaretStandsUnderCharactersNotBytes) {
  EXPECT_EQ(to_text({"f", 1, 8, "m", ""}, "é.ü.x = nan"), "f:1:8: m\n    é.ü.x = nan\n           ^");
}

TEST(Diagnostic, CaretKeepsTabsBeforeIt) {
  EXPECT_EQ(to_text({"f", 1, 4, "m", ""}, "\ta\tb"), "f:1:4: m\n    \ta\tb\n    \t \t^");
}

TEST(Diagnostic, CaretCountsWideCharactersTwice) {
  EXPECT_EQ(to_text({"f", 1, 3, "m", ""}, "名名x"), "f:1:3: m\n    名名x\n        ^");
}

TEST(Diagnostic, CaretMayStandBehindTheEnd) {
  EXPECT_EQ(to_text({"f", 1, 5, "m", ""}, "a = \r\nb"), "f:1:5: m\n    a = \n        ^");
  EXPECT_EQ(to_text({"f", 9, 9, "m", ""}, "a"), "f:9:9: m\n    \n    ^");
}

TEST(Diagnostic, LongLinesAreCutAroundTheCaret) {
  const std::string line = std::string(200, 'a') + "X" + std::string(200, 'b');
  EXPECT_EQ(to_text({"f", 1, 201, "m", ""}, line), "f:1:201: m\n    …" + std::string(70, 'a') + "X" +
                                                       std::string(49, 'b') + "…\n" + std::string(75, ' ') +
                                                       "^");
}

TEST(Diagnostic, ReplacesWhatCouldSteerATerminal) {
  EXPECT_EQ(to_text({"f", 1, 1, "bad \x1b[31mred\n", ""}, "\x1b[31m"),
            "f:1:1: bad \uFFFD[31mred\uFFFD\n    \uFFFD[31m\n    ^");
}

TEST(Diagnostics, AreInTheOrderOfTheText) {
  const std::string all = to_text(
      {{"--set a=1", 0, 0, "third", ""}, {"f", 2, 1, "second", ""}, {"f", 1, 3, "first", ""}}, "a\nb", 50);
  EXPECT_EQ(all, "f:1:3: first\n    a\n     ^\nf:2:1: second\n    b\n    ^\n--set a=1: third");
}

TEST(Diagnostics, BeyondTheMostAreCounted) {
  const std::vector<Diagnostic> many(5, {"f", 0, 0, "m", ""});
  EXPECT_EQ(to_text(many, "", 5), "f: m\nf: m\nf: m\nf: m\nf: m");
  EXPECT_EQ(to_text(many, "", 4), "f: m\nf: m\nf: m\nf: m\n… and 1 more error");
  EXPECT_EQ(to_text(many, "", 2), "f: m\nf: m\n… and 3 more errors");
  EXPECT_EQ(to_text(many, "", 2, 10), "f: m\nf: m\n… and 13 more errors");
}

TEST(InQuotes, CutsLongNamesBetweenCharacters) {
  EXPECT_EQ(in_quotes("rope"), "\"rope\"");
  std::string long_name, expected;
  for (int i = 0; i < 100; ++i) long_name += "é";
  for (int i = 0; i < 30; ++i) expected += "é";
  EXPECT_EQ(in_quotes(long_name), "\"" + expected + "…\"");
}

TEST(DidYouMean, IsEmptyWithoutAName) {
  EXPECT_EQ(did_you_mean("", "m"), "");
  EXPECT_EQ(did_you_mean("rows"), "did you mean \"rows\"?");
}

TEST(Utf8, AcceptsEveryLength) {
  EXPECT_EQ(utf8_length("a"), 1U);
  EXPECT_EQ(utf8_length("é"), 2U);
  EXPECT_EQ(utf8_length("名"), 3U);
  EXPECT_EQ(utf8_length("🙂"), 4U);
  EXPECT_EQ(find_invalid_utf8("aé名🙂"), std::string_view::npos);
}

TEST(Utf8, RefusesWhatIsNotWellFormed) {
  EXPECT_EQ(utf8_length(""), 0U);
  EXPECT_EQ(utf8_length("\x80"), 0U) << "a continuation alone";
  EXPECT_EQ(utf8_length("\xc3"), 0U) << "cut off";
  EXPECT_EQ(utf8_length("\xc0\xaf"), 0U) << "overlong";
  EXPECT_EQ(utf8_length("\xe0\x80\xaf"), 0U) << "overlong";
  EXPECT_EQ(utf8_length("\xed\xa0\x80"), 0U) << "a surrogate";
  EXPECT_EQ(utf8_length("\xf4\x90\x80\x80"), 0U) << "above U+10FFFF";
  EXPECT_EQ(utf8_length("\xf0\x80\x80\x80"), 0U) << "overlong";
  EXPECT_EQ(find_invalid_utf8("ab\xff"), 2U);
}

}  // namespace
}  // namespace taut
