// Whatever a scene can say, a method does, or refuses: every key of the reference that is about physics, set
// to another value in a small scene in which it matters, gives another motion with every method that takes
// the scene. The keys come from the program's own table: one that is missing here fails.

#include <algorithm>
#include <map>
#include <optional>
#include <regex>
#include <set>

#include "base/failure.h"
#include "fixtures.h"
#include "scene/scene.h"
#include "scene_key_bodies.h"
#include "scene_key_cases.h"
#include "scene_key_files.h"
#include "scene_key_scenes.h"

namespace taut::test {
namespace {

// Keys that are not about how things move; those of [solve] are the methods' own parameters.
bool about_physics(const std::string& section, const std::string& key) {
  static const std::set<std::string> pictures{"camera", "look", "expect", "solve", ""};
  static const std::set<std::string> labels{
      "chain.name",  "sheet.name",     "mass.name",    "ragdoll.name", "world.duration", "world.accuracy",
      "plane.name",  "sphere.name",    "capsule.name", "box.name",     "mesh.name",      "mesh.content",
      "points.name", "points.content", "solid.name",   "solid.content"};
  static const std::set<std::string> looks{"visible", "colour", "back_colour", "draw"};
  return !pictures.contains(section) && !labels.contains(section + "." + key) && !looks.contains(key);
}

// Every key of the program's reference as section.key.
std::vector<std::string> physics_keys() {
  const std::string reference = key_reference();
  const std::regex line(R"(\n(?:## `\[+([a-z]+)\]+`|(## Top level)|\| `([a-z_.]+)` \|))");
  std::vector<std::string> keys;
  std::string section;
  for (std::sregex_iterator it(reference.begin(), reference.end(), line), end; it != end; ++it) {
    if ((*it)[3].matched) {
      if (about_physics(section, (*it)[3])) keys.push_back(section + "." + (*it)[3].str());
    } else {
      section = (*it)[1].str();
    }
  }
  return keys;
}

// FILES is the folder of the files of scenes.
std::string with_files(const std::string& text) {
  return std::regex_replace(text, std::regex("FILES"), TAUT_TEST_DATA "/physics/key_files");
}

std::string text_for(const KeyCase& each, const Method& method) {
  static const std::map<std::string, std::string> key_files = key_file_scenes();
  const std::string soft_links = method.can.rigid ? "" : "stiffness = 2000.0";
  const auto& scenes = key_bodies.contains(each.scene)  ? key_bodies
                       : key_files.contains(each.scene) ? key_files
                                                        : key_scenes;
  return with_files(std::regex_replace(scenes.at(each.scene), std::regex("LINKS"), soft_links));
}

std::map<std::string, KeyCase> all_cases() {
  std::map<std::string, KeyCase> all = key_cases();
  add_file_cases(all);
  for (auto& [key, each] : all) each.value = with_files(each.value);
  return all;
}

// The hash of the state after a short run; none where the method refuses the scene.
std::optional<std::uint64_t> outcome(const std::string& text, const std::vector<std::string>& sets,
                                     const Method& method) {
  Scene scene;
  try {
    scene = parse_scene(text, "scene.toml", {sets, std::string(method.name)});
  } catch (const BadRequest& problem) {
    if (std::string_view(problem.what()).find("; these have: ") == std::string_view::npos) throw;
    return std::nullopt;
  }
  const bool doll = !scene.description.ragdolls.empty();
  State state = scene.start;
  try {
    taut::Run run(scene.model, scene.start, scene.settings);
    const std::optional<State> end = run.at(doll ? 0.15 : 0.3);
    EXPECT_EQ(run.failure(), "");
    state = end.value_or(run.state());
  } catch (const BadRequest&) {
    return std::nullopt;
  }
  return state_hash(state);
}

// chain.first_motion.phase → chain.0.first_motion.phase
std::string path_of(const std::string& key) {
  static const std::set<std::string> single{"world", "wind"};
  const std::size_t dot = key.find('.');
  return single.contains(key.substr(0, dot)) ? key : key.substr(0, dot) + ".0" + key.substr(dot);
}

class SceneKeys : public ::testing::TestWithParam<std::string> {};

TEST_P(SceneKeys, ChangeTheMotionOrAreRefused) {
  const Method& method = *find_method(GetParam());
  const std::map<std::string, KeyCase> known = all_cases();
  std::map<std::string, std::optional<std::uint64_t>> unchanged;
  for (const std::string& key : physics_keys()) {
    const auto found = known.find(key);
    if (found == known.end()) continue;                          // the other test's
    if (method.name == "euler" && key == "mass.mass") continue;  // it ignores mass, as its text has it
    const KeyCase& each = found->second;
    const std::string text = text_for(each, method);
    const std::string path = each.at.empty() ? path_of(key) : each.at;
    try {
      if (!unchanged.contains(each.scene)) unchanged[each.scene] = outcome(text, {}, method);
      const auto changed = outcome(text, {path + "=" + each.value}, method);
      EXPECT_TRUE(!changed || changed != unchanged[each.scene]) << key << " is taken, and changes nothing";
    } catch (const BadRequest& problem) {
      ADD_FAILURE() << key << ": " << problem.what();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, SceneKeys, ::testing::ValuesIn(every_method()), case_name);

TEST(SceneKeyCases, AreAllKeysOfTheReference) {
  const std::map<std::string, KeyCase> known = all_cases();
  const std::vector<std::string> keys = physics_keys();
  EXPECT_GT(keys.size(), 100U);
  for (const std::string& key : keys) EXPECT_TRUE(known.contains(key)) << key << " has no case here";
  for (const auto& [key, each] : known)
    EXPECT_TRUE(std::ranges::find(keys, key) != keys.end()) << key << " is no key of the reference";
}

// A scene in which every key matters to at least one method, or its case says nothing.
TEST(SceneKeyCases, MatterToSomeMethod) {
  for (const auto& [key, each] : all_cases()) {
    bool matters = false;
    for (const Method& method : all_methods()) {
      const std::string text = text_for(each, method);
      const auto before = outcome(text, {}, method);
      if (!before) continue;
      const auto after =
          outcome(text, {(each.at.empty() ? path_of(key) : each.at) + "=" + each.value}, method);
      matters = after && after != before;
      if (matters) break;
    }
    EXPECT_TRUE(matters) << key;
  }
}

// The methods' own parameters: a scene with a stop, in which each of them matters.
TEST(SolveKeys, ChangeTheMotion) {
  const std::map<std::string, std::string> values{
      {"steps_per_second", "700"}, {"passes", "3"}, {"impact_passes", "2"}, {"velocities", "derived"},
      {"precision", "single"},     {"order", "4"},  {"tolerance", "0.01"},  {"relax", "lines"}};
  for (const Method& method : all_methods())
    for (const Param& param : method.params) {
      const std::string name(param.name);
      ASSERT_TRUE(values.contains(name)) << name << " has no case here";
      const KeyCase each{name == "impact_passes" ? "stopped pendulum" : "rope", "", ""};
      std::vector<std::string> sets;
      if (name == "tolerance" && find_param(method, "passes") != nullptr) sets.emplace_back("solve.passes=8");
      const std::string text = text_for(each, method);
      const auto before = outcome(text, sets, method);
      sets.push_back("solve." + name + "=" + values.at(name));
      const auto after = outcome(text, sets, method);
      EXPECT_TRUE(before && after) << method.name << " " << name;
      EXPECT_NE(before, after) << method.name << " " << name;
    }
}

}  // namespace
}  // namespace taut::test
