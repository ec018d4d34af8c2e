// What is said about scenes that are no TOML, or barely.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "scene_errors.h"

namespace taut {
namespace {

TEST(SceneSyntaxErrors, CaretIsRightBehindTabsAndOtherScripts) {
  EXPECT_EQ(errors_of("[[chain]]\nname = \"rope\"\nfrom = [0, 2, 0]\n\tto = [\"é\", 2, 0]\n"),
            "f.toml:4:8: \"to\" must be a list of 3 numbers in m, not \"é\"\n    \tto = [\"é\", 2, 0]\n"
            "    \t      ^");
  EXPECT_EQ(errors_of(chain_with("pinned = [\"é\", 3]\n")),
            "f.toml:5:11: \"pinned\" must be \"first\" or \"last\", not \"é\"\n    pinned = [\"é\", 3]\n"
            "              ^\n"
            "f.toml:5:16: \"pinned\" must be text, not 3\n    pinned = [\"é\", 3]\n                   ^");
}

TEST(SceneSyntaxErrors, SyntaxErrorsHaveTheirPlace) {
  EXPECT_EQ(errors_of("[world]\ndrag = \n"),
            "f.toml:2:8: not valid TOML: parsing key-value pair: expected value, saw '\\n'\n    drag = \n"
            "           ^");
  EXPECT_EQ(errors_of("a = 1\na = 2\n").substr(0, 30), "f.toml:2:5: not valid TOML: pa");
  EXPECT_EQ(errors_of("x = \"").substr(0, 28), "f.toml:1:6: not valid TOML: ");
}

TEST(SceneSyntaxErrors, NothingToParse) {
  EXPECT_EQ(errors_of(""), "f.toml: the file is empty");
  EXPECT_EQ(errors_of(" \r\n\t\n"), "f.toml: the file is empty");
  EXPECT_EQ(errors_of("# a comment\n"),
            "f.toml: the scene has no masses: it needs a [[chain]], a [[sheet]], a [[mesh]] or a [[mass]]");
}

TEST(SceneSyntaxErrors, ByteOrderMarkAndCarriageReturnsAreNoErrors) {
  EXPECT_EQ(errors_of("\xef\xbb\xbf[[chain]]\r\nname = \"r\"\r\nfrom = [0, 2, 0]\r\nto = [2, 2, 0]\r\n"), "");
  EXPECT_EQ(errors_of("\xef\xbb\xbfx = 1\r\n" + chain_with("")),
            "f.toml:1:1: unknown key \"x\"\n    x = 1\n    ^");
}

TEST(SceneSyntaxErrors, NotUtf8) {
  EXPECT_EQ(errors_of("title = \"\xff\"\n"), "f.toml: not UTF-8 text: byte 10 is 0xff");
}

std::string repeated(const std::string& part, int times) {
  std::string out;
  for (int i = 0; i < times; ++i) out += part;
  return out;
}

TEST(SceneSyntaxErrors, KeysOfTooManyParts) {
  const std::string errors = errors_of(fmt::format("a{} = 1\n", repeated(".a", 60'000)));
  EXPECT_TRUE(errors.starts_with("f.toml:1:32: a dotted key of more than 16 parts\n"))
      << errors.substr(0, 80);
  EXPECT_TRUE(errors_of(fmt::format("[a{}]\n", repeated(" . a", 60'000)))
                  .starts_with("f.toml:1:64: a dotted key of more than 16 parts\n"));
  EXPECT_TRUE(errors_of("x = { 'a'" + repeated(".\"a\"", 60'000) + " = 1 }\n").find("more than 16 parts") !=
              std::string::npos);
}

TEST(SceneSyntaxErrors, BracketsTooDeep) {
  EXPECT_TRUE(errors_of("\na = " + repeated("[", 60'000) + "\n")
                  .starts_with("f.toml:2:37: lists and tables nested more than 32 deep\n"));
  EXPECT_TRUE(errors_of("a = " + repeated("{a=", 60'000)).find("more than 32 deep") != std::string::npos);
}

TEST(SceneSyntaxErrors, DotsAndBracketsInStringsAndCommentsDoNotCount) {
  const std::string many = repeated(".[", 200);
  EXPECT_EQ(errors_of("# " + many + "\ntitle = \"" + many + "\\\"" + many + "\"\n" + chain_with("")), "");
  EXPECT_EQ(errors_of("title = '" + many + "\\'\n" + chain_with("")), "");
  EXPECT_EQ(errors_of("title = \"\"\"\n\"" + many + "\\\"\"\"\" # " + many + "\n" + chain_with("")), "");
  EXPECT_EQ(errors_of("title = '''\n'" + many + "'''\n" + chain_with("")), "");
  EXPECT_EQ(errors_of("title = \"\"\"a\"\"\"\"\" # \"" + many + "\n" + chain_with("")), "");
}

TEST(SceneSyntaxErrors, LettersThatAreNotAsciiOutsideOfQuotes) {
  EXPECT_EQ(
      errors_of("\té = 1\n"),
      "f.toml:1:2: not valid TOML: parsing root table: expected keys, tables, whitespace or comments, saw "
      "'é'\n    \té = 1\n    \t^");
  for (const char* text :
       {"x = é", "x = 1é", "x = 4\"é\"", "[é]", "x = [é]", "x = { é = 1 }", "x = \"\"\"\\é\"\"\"",
        "x = \"\"\"\\ é\"\"\"", "x = true\u0499", "x = 1979-05-27é"})
    EXPECT_TRUE(errors_of(text).starts_with("f.toml:1:")) << text << "\n" << errors_of(text);
}

TEST(SceneSyntaxErrors, BrokenHeadersDoNotAddUpToDepth) {
  EXPECT_TRUE(errors_of(repeated("[[x]\n", 100)).starts_with("f.toml:1:")) << "the first one is reported";
  EXPECT_EQ(errors_of(repeated("[[x]\n", 100)).find("nested"), std::string::npos);
}

}  // namespace
}  // namespace taut
