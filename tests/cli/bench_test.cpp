#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "program.h"

namespace taut::testing {
namespace {

using Json = nlohmann::json;

TEST(Bench, TimesEachWayAndSaysOnWhat) {
  const Ran ran =
      taut({"bench", "--seconds", "0.001", "--frames", "2", "--json", "--quiet", "--simd", "scalar"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  const Json json = Json::parse(ran.out);
  EXPECT_EQ(json.at("simd"), "scalar");
  std::set<std::string> methods;
  for (const Json& speed : json.at("speeds")) {
    methods.insert(speed.at("method"));
    EXPECT_GT(speed.at("seconds_per_step"), 0.0);
    EXPECT_NEAR(speed.at("seconds_per_link").get<double>() * speed.at("links").get<double>(),
                speed.at("seconds_per_step").get<double>(), 1e-12);
  }
  EXPECT_EQ(methods, (std::set<std::string>{"newton", "rattle", "shake", "verlet", "xpbd", "xpbd single"}));
  std::set<std::string> scenes;
  for (const Json& speed : json.at("frames")) {
    scenes.insert(speed.at("scene"));
    EXPECT_EQ(speed.at("frames"), 2);
    EXPECT_GT(speed.at("seconds_to_first_file"), 0.0);
    EXPECT_GT(speed.at("stage_seconds").at("draw"), 0.0);
    EXPECT_GT(speed.at("stage_seconds").at("encode"), 0.0);
  }
  EXPECT_EQ(scenes, (std::set<std::string>{"breaking-cloth", "curtain", "hanging-chain"}));
}

TEST(Bench, RefusesFramesThatAreNone) {
  for (const char* wrong : {"-1", "some", "1.5", "1001"}) {
    const Ran ran = taut({"bench", "--frames", wrong});
    EXPECT_EQ(ran.status, 2) << wrong;
    EXPECT_NE(ran.err.find("--frames"), std::string::npos) << ran.err;
  }
}

TEST(Bench, RefusesATimeThatIsNone) {
  for (const char* wrong : {"0", "-1", "soon", "61"}) {
    const Ran ran = taut({"bench", "--seconds", wrong});
    EXPECT_EQ(ran.status, 2) << wrong;
    EXPECT_NE(ran.err.find("--seconds"), std::string::npos) << ran.err;
  }
}

}  // namespace
}  // namespace taut::testing
