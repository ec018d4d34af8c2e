#include "base/nearest.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace taut {
namespace {

using namespace std::string_view_literals;

constexpr std::array known_keys{"compliance"sv, "stiffness"sv, "damping"sv, "drag"sv, "mass"sv};

TEST(NearestName, FindsEachKindOfTypingError) {
  EXPECT_EQ(nearest_name("complance", known_keys), "compliance") << "a letter missing";
  EXPECT_EQ(nearest_name("stifffness", known_keys), "stiffness") << "a letter too many";
  EXPECT_EQ(nearest_name("dampimg", known_keys), "damping") << "a wrong letter";
  EXPECT_EQ(nearest_name("darg", known_keys), "drag") << "two letters swapped";
}

TEST(NearestName, IsTheNameItselfWhenItIsThere) {
  EXPECT_EQ(nearest_name("mass", known_keys), "mass");
}

TEST(NearestName, IsEmptyWhenNothingIsMeant) {
  EXPECT_EQ(nearest_name("elasticity", known_keys), "");
  EXPECT_EQ(nearest_name("friction", known_keys), "");
}

TEST(NearestName, AllowsAThirdOfALongWordToDiffer) {
  EXPECT_EQ(nearest_name("cmplince", known_keys), "compliance") << "2 of 8 letters";
  EXPECT_EQ(nearest_name("cmplnc", known_keys), "") << "4 of 6 letters";
}

TEST(NearestName, IsEmptyWhenNothingOfAShortWordIsLeft) {
  constexpr std::array words{"2"sv, "4"sv, "to"sv};
  EXPECT_EQ(nearest_name("3", words), "");
  EXPECT_EQ(nearest_name("ab", words), "");
  EXPECT_EQ(nearest_name("op", std::array{"top"sv}), "top");
}

TEST(NearestName, TakesTheNearestOfSeveral) {
  constexpr std::array names{"first_motion"sv, "last_motion"sv};
  EXPECT_EQ(nearest_name("lst_motion", names), "last_motion");
}

TEST(NearestName, HandlesEmptyAndHugeWords) {
  EXPECT_EQ(nearest_name("", {}), "");
  EXPECT_EQ(nearest_name("x", {}), "");
  EXPECT_EQ(nearest_name(std::string(1'000'000, 'a'), known_keys), "");
}

}  // namespace
}  // namespace taut
