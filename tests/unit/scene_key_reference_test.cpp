#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "methods/registry.h"
#include "scene/scene.h"

namespace taut {
namespace {

const std::string page = TAUT_SOURCE_DIR "/docs/scene-keys.md";

// The keys in the rows of a section's tables.
std::set<std::string> keys_of(const std::string& heading) {
  const std::string reference = key_reference();
  const std::size_t begin = reference.find("\n## " + heading + "\n");
  if (begin == std::string::npos) return {};
  const std::string section = reference.substr(begin, reference.find("\n## ", begin + 1) - begin);
  const std::regex row("\n\\| `([a-z_.]+)` \\|");
  std::set<std::string> keys;
  for (std::sregex_iterator it(section.begin(), section.end(), row), end; it != end; ++it)
    keys.insert((*it)[1]);
  return keys;
}

using Names = std::set<std::string>;

Names operator+(Names all, const Names& more) {
  all.insert(more.begin(), more.end());
  return all;
}

// Keys within another one.
Names within(const std::string& key, const Names& inner) {
  Names names{key};
  for (const std::string& name : inner) names.insert(key + "." + name);
  return names;
}

const Names links{"acts",          "longest",  "stiffness", "damping",     "break_stretch",
                  "break_tension", "break_at", "scatter",   "scatter_seed"};
const Names motion{"amplitude", "angular_frequency", "phase", "path", "with"};
const Names solid = Names{"name", "friction", "restitution", "visible", "colour"} +
                    within("motion", {"amplitude", "angular_frequency", "phase", "path"}) +
                    within("rotation", {"axis", "through", "rate", "rise", "angle"});

TEST(KeyReference, ListsEveryKeyOfEverySection) {
  EXPECT_EQ(keys_of("Top level"), (Names{"title"}));
  EXPECT_EQ(keys_of("`[world]`"), (Names{"gravity", "duration", "drag", "accuracy"}));
  EXPECT_EQ(keys_of("`[[chain]]`"),
            (Names{"name", "from", "to", "points", "smooth", "links", "length", "mass", "last_mass", "radius",
                   "collides", "pinned", "first_release", "last_release"} +
             within("first_motion", motion) + within("last_motion", motion) +
             within("wound", {"around", "turns", "start", "end", "axis"}) +
             within("bending", {"stiffness", "from_start"}) + links + Names{"visible", "colour", "draw"}));
  EXPECT_EQ(
      keys_of("`[[sheet]]`"),
      (Names{"name", "rows", "columns", "from", "to", "down", "mass", "fullness", "radius", "collides",
             "pinned", "release"} +
       within("hooks", {"every", "draw"}) + within("top_motion", motion) + within("bottom_motion", motion) +
       within("left_motion", motion) + within("right_motion", motion) +
       within("bending", {"stiffness", "warp", "weft", "bias", "from_start"}) + links +
       within("weft", links) + within("diagonals", links) + within("skip_one", links) +
       within("faces", {"thickness", "friction", "self_collides"}) +
       Names{"visible", "colour", "back_colour", "draw"}));
  EXPECT_EQ(keys_of("`[[mesh]]`"),
            (Names{"name", "file", "content", "mass", "shares", "scale", "up", "position", "turn", "weld",
                   "pinned", "pinned_box", "pinned_masses", "release", "radius", "collides"} +
             within("motion", motion) + links + within("diagonals", links) + within("skip_one", links) +
             within("bending", {"stiffness", "from_start"}) +
             within("faces", {"thickness", "friction", "self_collides"}) +
             Names{"visible", "colour", "back_colour", "draw"}));
  EXPECT_EQ(keys_of("`[[points]]`"), (Names{"name", "masses", "links", "content", "position", "turn", "mass",
                                            "pinned", "radius", "collides", "visible", "colour", "draw"} +
                                      links));
  EXPECT_EQ(keys_of("`[[mass]]`"), (Names{"name", "position", "velocity", "mass", "pinned", "release",
                                          "radius", "collides", "visible", "colour"} +
                                    within("motion", motion)));
  EXPECT_EQ(keys_of("`[[link]]`"), (Names{"a", "b", "length", "visible", "colour"} + links));
  EXPECT_EQ(keys_of("`[[tie]]`"), (Names{"a", "b", "every"} + links));
  EXPECT_EQ(keys_of("`[[load]]`"), (Names{"masses", "force", "from", "to", "until", "gone"}));
  EXPECT_EQ(keys_of("`[[seam]]`"), (Names{"sheet", "row", "column", "a", "b", "strength", "break_stretch",
                                          "break_tension", "break_at"}));
  EXPECT_EQ(keys_of("`[[plane]]`"), (Names{"point", "normal"} + solid));
  EXPECT_EQ(keys_of("`[[sphere]]`"), (Names{"centre", "radius"} + solid));
  EXPECT_EQ(keys_of("`[[capsule]]`"), (Names{"from", "to", "radius"} + solid));
  EXPECT_EQ(keys_of("`[[solid]]`"),
            (Names{"file", "content", "scale", "up", "position", "turn", "weld"} + solid));
  EXPECT_EQ(keys_of("`[[box]]`"), (Names{"centre", "size", "turn"} + solid));
  EXPECT_EQ(keys_of("`[wind]`"),
            (Names{"velocity", "gust", "gust_time", "seed", "density", "drag_coefficient"}));
  EXPECT_EQ(keys_of("`[[angle]]`"), (Names{"masses", "min", "max", "compliance"}));
  EXPECT_EQ(keys_of("`[[hinge]]`"), (Names{"masses", "axis", "min", "max", "compliance"}));
  EXPECT_EQ(keys_of("`[[cone]]`"), (Names{"frame", "limb", "axis", "half_angle", "compliance"}));
  EXPECT_EQ(keys_of("`[[ragdoll]]`"), (Names{"name",
                                             "height",
                                             "mass",
                                             "position",
                                             "turn",
                                             "velocity",
                                             "spin",
                                             "pose",
                                             "pose.neck",
                                             "pose.left_shoulder",
                                             "pose.right_shoulder",
                                             "pose.left_shoulder_out",
                                             "pose.right_shoulder_out",
                                             "pose.left_elbow",
                                             "pose.right_elbow",
                                             "pose.left_hip",
                                             "pose.right_hip",
                                             "pose.left_hip_out",
                                             "pose.right_hip_out",
                                             "pose.left_knee",
                                             "pose.right_knee",
                                             "ranges",
                                             "ranges.neck",
                                             "ranges.elbow",
                                             "ranges.knee",
                                             "ranges.shoulder",
                                             "ranges.hip",
                                             "ranges.hip_twist",
                                             "ranges.wrist",
                                             "ranges.ankle",
                                             "joint_damping",
                                             "joint_friction",
                                             "pinned",
                                             "collides",
                                             "visible",
                                             "colour",
                                             "draw"}));
  EXPECT_EQ(keys_of("`[camera]`"),
            (Names{"eye", "target", "direction", "show", "field_of_view", "up", "orbit", "follow"}));
  EXPECT_EQ(keys_of("`[look]`"), (Names{"masses",       "links",          "surface",
                                        "ground",       "shadows",        "theme",
                                        "colour_by",    "colour_range",   "colour_steps",
                                        "speed",        "ground_height",  "mass_radius",
                                        "link_radius",  "mass_colour",    "pin_colour",
                                        "link_colour",  "surface_colour", "surface_back_colour",
                                        "pattern",      "bones",          "colliders",
                                        "mass_shape",   "bone_colour",    "collider_colour",
                                        "weights",      "link_shape",     "chain_pitch",
                                        "families",     "loads",          "exact",
                                        "trails",       "trail_time",     "supports",
                                        "thread_pitch", "hem_width"}));
  EXPECT_EQ(keys_of("`[expect]`"), (Names{"max_strain", "energy_drift", "broken_links", "sag", "at_rest",
                                          "inside", "limit_excess", "penetration", "tangled"}));
}

TEST(KeyReference, ListsEveryParameterOfEveryMethod) {
  Names expected{"method"};
  for (const Method& method : all_methods())
    for (const Param& param : method.params) expected.insert(std::string(param.name));
  EXPECT_EQ(keys_of("`[solve]`"), expected);
}

TEST(KeyReference, EveryRowSaysWhatTheKeyMeans) {
  const std::string reference = key_reference();
  const std::regex row("\n\\| `[a-z_.]+` \\|[^\n]*");
  std::size_t rows = 0;
  for (std::sregex_iterator it(reference.begin(), reference.end(), row), end; it != end; ++it, ++rows) {
    const std::string line = std::regex_replace(it->str(), std::regex("\\\\\\|"), "");
    EXPECT_EQ(std::count(line.begin(), line.end(), '|'), 7) << line;
    EXPECT_FALSE(line.ends_with("| – |")) << "no meaning: " << line;
  }
  EXPECT_GT(rows, 90U);
}

TEST(KeyReference, GivesUnitDefaultAndRange) {
  EXPECT_NE(key_reference().find("| `drag` | a number | 1/s | `0.0` | 0 … 1e6 |"), std::string::npos);
  EXPECT_NE(key_reference().find("| `from` | a list of 3 numbers | m | **required** | -1e6 … 1e6 |"),
            std::string::npos);
  EXPECT_NE(key_reference().find("| `stiffness` | a number | N/m | rigid | > 0, ≤ 1e15 |"),
            std::string::npos);
  EXPECT_NE(key_reference().find("| `theme` | text | – | `\"light\"` | `\"light\"`, `\"dark\"` |"),
            std::string::npos);
}

// The page is made by this test when TAUT_UPDATE_DOCS is set in the environment.
TEST(KeyReference, ThePageInDocsIsUpToDate) {
  if (std::getenv("TAUT_UPDATE_DOCS")) std::ofstream(page, std::ios::binary) << key_reference();
  std::ifstream stream(page, std::ios::binary);
  const std::string stored(std::istreambuf_iterator<char>(stream), {});
  EXPECT_EQ(stored, key_reference()) << "run this test with TAUT_UPDATE_DOCS=1 to write " << page;
}

}  // namespace
}  // namespace taut
