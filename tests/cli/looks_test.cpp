// Looks of single objects, from the command line to pictures.

#include <gtest/gtest.h>

#include "program.h"

namespace taut::testing {
namespace {

TEST(LooksOfObjects, DrawAMotionAnewWithoutTouchingIt) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("small.toml", small_scene());
  ASSERT_EQ(taut({"simulate", scene, "-o", folder / "motion"}).status, 0);
  const auto drawn = [&](const std::string& set) {
    return taut({"render", "--motion", folder / "motion", "-o", folder / "frames", "--size", "64x48",
                 "--frames", "1-2", "--set", set});
  };
  ASSERT_EQ(drawn("mass.*.colour=teal").status, 0);
  EXPECT_EQ(drawn("mass.*.colour=teal").status, 0) << "the same again";
  EXPECT_EQ(drawn("mass.*.colour=#1a8587").status, 4) << "frames of another colour are not mixed in";
  EXPECT_EQ(taut({"verify", folder / "frames"}).status, 3) << "whole, but for the frames not asked for";
  const Ran wrong = drawn("mass.*.colour=teel");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("did you mean \"teal\"?"), std::string::npos) << wrong.err;
}

}  // namespace
}  // namespace taut::testing
