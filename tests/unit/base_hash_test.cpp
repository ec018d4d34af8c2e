#include <gtest/gtest.h>

#include <array>

#include "base/hash.h"

namespace taut {
namespace {

using namespace std::string_view_literals;

// Published 64-bit FNV-1a values (Fowler, Noll and Vo).
TEST(Hash, HasThePublishedValues) {
  EXPECT_EQ(Hash().value(), 0xcbf29ce484222325U);
  EXPECT_EQ(Hash().add("a"sv).value(), 0xaf63dc4c8601ec8cU);
  EXPECT_EQ(Hash().add("foobar"sv).value(), 0x85944171f73967e8U);
}

TEST(Hash, IsTheSameWhereverTheBytesAreSplit) {
  EXPECT_EQ(Hash().add("foo"sv).add("bar"sv).value(), Hash().add("foobar"sv).value());
}

TEST(Hash, TellsBitsApartThatCompareEqual) {
  EXPECT_NE(Hash().add(std::array{0.0}).value(), Hash().add(std::array{-0.0}).value());
}

TEST(Hash, HexHasSixteenDigits) {
  EXPECT_EQ(Hash().add("foobar"sv).hex(), "85944171f73967e8");
  EXPECT_EQ(Hash().hex().size(), 16U);
}

}  // namespace
}  // namespace taut
