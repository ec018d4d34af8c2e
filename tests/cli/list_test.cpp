#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "methods/registry.h"
#include "program.h"

namespace taut::testing {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Names = std::set<std::string>;

Names names_in(const Json& list) {
  Names names;
  for (const Json& entry : list) names.insert(entry.at("name").get<std::string>());
  return names;
}

TEST(List, ScenesAreExactlyTheFilesOfTheFolder) {
  Names files;
  for (const auto& entry : fs::directory_iterator(TAUT_SCENE_FOLDER))
    if (entry.path().extension() == ".toml") files.insert(entry.path().stem().string());
  const Ran ran = taut({"list", "scenes", "--json"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json scenes = Json::parse(ran.out);
  EXPECT_EQ(names_in(scenes), files);
  for (const Json& scene : scenes) {
    EXPECT_FALSE(scene.contains("error")) << scene.dump(2);
    EXPECT_NE(scene.at("title"), "");
    EXPECT_GT(scene.at("masses"), 0);
    EXPECT_GT(scene.at("links"), 0);
    EXPECT_TRUE(fs::exists(scene.at("path").get<std::string>()));
  }
}

TEST(List, MethodsAreExactlyThoseOfTheRegistry) {
  Names registered;
  for (const Method& method : all_methods()) registered.insert(std::string(method.name));
  const Ran ran = taut({"list", "methods", "--json"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json methods = Json::parse(ran.out);
  EXPECT_EQ(names_in(methods), registered);
  for (const Json& method : methods) {
    EXPECT_NE(method.at("title"), "");
    EXPECT_NE(method.at("source"), "");
    const auto params = names_in(method.at("params"));
    EXPECT_TRUE(params.contains("steps_per_second") || params.contains("tolerance"));
    for (const Json& param : method.at("params")) {
      EXPECT_NE(param.at("help"), "") << param.dump();
      EXPECT_TRUE(param.contains("choices") || param.at("min") <= param.at("max")) << param.dump();
    }
  }
}

TEST(List, PeopleSeeTheSameNames) {
  const std::string scenes = taut({"list", "scenes"}).out, methods = taut({"list", "methods"}).out;
  for (const char* name : {"hanging-chain", "curtain", "breaking-cloth"})
    EXPECT_NE(scenes.find(name), std::string::npos) << scenes;
  for (const char* name : {"euler", "verlet", "xpbd", "steps_per_second"})
    EXPECT_NE(methods.find(name), std::string::npos) << methods;
}

TEST(List, KeysAreTheReference) {
  const Ran ran = taut({"list", "keys"});
  EXPECT_EQ(ran.status, 0);
  for (const char* key : {"gravity", "break_stretch", "steps_per_second", "field_of_view"})
    EXPECT_NE(ran.out.find(key), std::string::npos) << key;
}

TEST(List, KeysAreDataToo) {
  const Ran ran = taut({"list", "keys", "--json"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  bool found = false;
  for (const auto& section : nlohmann::json::parse(ran.out))
    for (const auto& group : section["groups"])
      for (const auto& key : group["keys"]) {
        if (section["section"] != "world" || key["name"] != "drag") continue;
        found = true;
        EXPECT_EQ(key["unit"], "1/s");
        EXPECT_EQ(key["min"], 0.0);
        EXPECT_EQ(key["default"], "0.0");
      }
  EXPECT_TRUE(found);
}

TEST(Help, EveryVerbHasAnExample) {
  for (const std::string verb : {"render", "still", "strip", "check", "list"}) {
    const Ran ran = taut({verb, "--help"});
    EXPECT_EQ(ran.status, 0) << verb;
    EXPECT_NE(ran.out.find("Example:\n  taut " + verb), std::string::npos) << ran.out;
  }
  EXPECT_EQ(taut({"--help"}).status, 0);
  EXPECT_EQ(taut({"--version"}).out.rfind("taut ", 0), 0U);
}

}  // namespace
}  // namespace taut::testing
