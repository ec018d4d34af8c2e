// Looks of single objects, as a scene file and the command line say them.

#include <gtest/gtest.h>

#include "base/hash.h"
#include "frames/settled_view.h"
#include "model/measures.h"
#include "render/camera.h"
#include "scene_errors.h"
#include "wanted_manifest.h"

namespace taut {
namespace {

const std::string looks_text = R"([[chain]]
name = "rope"
from = [0, 2, 0]
to = [2, 2, 0]
links = 4
pinned = ["first"]
colour = "#102030"
draw = ["links"]
[[chain]]
name = "far"
from = [50, 2, 0]
to = [52, 2, 0]
pinned = ["first"]
visible = false
[[sheet]]
name = "cloth"
rows = 3
columns = 3
from = [0, 1, 0]
to = [1, 1, 0]
down = [0, -1, 0]
pinned = ["top"]
colour = "teal"
back_colour = [0.5, 0.25, 0.0]
[[sphere]]
centre = [0, -2, 0]
colour = "gold"
[[box]]
centre = [3, -2, 0]
visible = false
)";

Scene looks_with(const std::vector<std::string>& sets) {
  return parse_scene(looks_text, "f.toml", {sets, {}});
}

TEST(SceneLooks, AreReadWithTheirObjects) {
  const ObjectLooks looks = looks_with({}).look.objects;
  EXPECT_EQ(looks.chains.at(0).colour, (Colour{16 / 255.0, 32 / 255.0, 48 / 255.0}));
  EXPECT_EQ(looks.chains.at(0).draw, (std::vector<std::string>{"links"}));
  EXPECT_TRUE(looks.chains.at(0).shown());
  EXPECT_FALSE(looks.chains.at(1).shown());
  EXPECT_EQ(looks.sheets.at(0).back_colour, (Colour{0.5, 0.25, 0.0}));
  EXPECT_TRUE(looks.sheets.at(0).colour);
  EXPECT_TRUE(looks.spheres.at(0).colour);
  EXPECT_FALSE(looks.boxes.at(0).visible);
}

TEST(SceneLooks, AreReachedFromTheCommandLineOneByOneAndAllAtOnce) {
  const Scene scene = looks_with({"chain.*.visible=true", "chain.far.colour=red", "sphere.0.visible=false",
                                  "sheet.cloth.draw=[\"surface\"]"});
  EXPECT_TRUE(scene.look.objects.chains.at(1).visible);
  EXPECT_TRUE(scene.look.objects.chains.at(1).colour);
  EXPECT_FALSE(scene.look.objects.spheres.at(0).visible);
  EXPECT_EQ(scene.look.objects.sheets.at(0).draw, (std::vector<std::string>{"surface"}));
  EXPECT_EQ(looks_with({"chain.*.mass=3"}).description.chains.at(1).mass, 3.0) << "any key of all entries";
}

TEST(SceneLooks, ReadBackFromTheResolvedText) {
  const std::string resolved = resolved_toml(looks_with({}));
  EXPECT_EQ(resolved_toml(parse_scene(resolved, "again.toml")), resolved);
  EXPECT_NE(resolved.find("draw = [\"links\"]"), std::string::npos);
}

TEST(SceneLooks, ChangeNoBitOfThePhysics) {
  const Scene with = looks_with({});
  const Scene without = looks_with({"chain.*.visible=true", "chain.rope.colour=red", "sheet.cloth.draw=[]"});
  EXPECT_EQ(state_hash(with.start), state_hash(without.start));
  EXPECT_EQ(with.model.masses.mass, without.model.masses.mass);
  EXPECT_EQ(with.model.links.length, without.model.links.length);
}

TEST(SceneLooks, DecideFramesButNoMotion) {
  RenderRequest request;
  const Scene scene = looks_with({}), other = looks_with({"chain.rope.colour=red"});
  EXPECT_NE(frames_manifest({&scene, 1}, request).inputs, frames_manifest({&other, 1}, request).inputs);
  EXPECT_EQ(motion_manifest(scene, {}, "").inputs, motion_manifest(other, {}, "").inputs);
}

TEST(SceneLooks, OfHiddenObjectsDoNotMoveTheCamera) {
  const auto reach = [](Scene scene) {
    settle_views({&scene, 1}, {640, 360});
    return (*scene.camera.eye - *scene.camera.target).norm();
  };
  EXPECT_LT(reach(looks_with({})), 20.0);
  EXPECT_GT(reach(looks_with({"chain.far.visible=true"})), 40.0);
}

TEST(SceneLooks, ErrorsNameThePlaceAndTheNearestRightWord) {
  EXPECT_EQ(errors_of(chain_with("colour = \"greeen\"\n")),
            "f.toml:5:10: \"colour\" names no colour: \"greeen\"; there are black, grey, silver, white, red, "
            "orange, gold, yellow, olive, green, teal, sky, blue, violet, pink, brown, \"#rrggbb\" and [red, "
            "green, blue]\n"
            "    colour = \"greeen\"\n"
            "             ^\n"
            "    did you mean \"green\"?");
  EXPECT_EQ(errors_of(chain_with("color = \"green\"\n")),
            "f.toml:5:1: unknown key \"color\" in [[chain]]\n"
            "    color = \"green\"\n"
            "    ^\n"
            "    did you mean \"colour\"?");
  EXPECT_EQ(errors_of(chain_with("draw = [\"link\"]\n")),
            "f.toml:5:9: \"draw\" must be \"links\" or \"masses\", not \"link\"\n"
            "    draw = [\"link\"]\n"
            "            ^\n"
            "    did you mean \"links\"?");
  EXPECT_EQ(errors_of(chain_with("colour = [1.0, 2.0, 0.0]\n")),
            "f.toml:5:16: \"colour\" must be between 0 and 1, not 2\n"
            "    colour = [1.0, 2.0, 0.0]\n"
            "                   ^");
  EXPECT_EQ(errors_of(looks_text, {{"chain.ropes.visible=false"}, {}}),
            "--set chain.ropes.visible=false: \"chain\" has no entry named \"ropes\"\n"
            "    did you mean \"rope\"?");
  EXPECT_EQ(errors_of(looks_text, {{"ragdoll.*.visible=false"}, {}}),
            "--set ragdoll.*.visible=false: the scene has no [[ragdoll]] to change");
  EXPECT_EQ(errors_of(chain_with("back_colour = \"red\"\n")),
            "f.toml:5:1: unknown key \"back_colour\" in [[chain]]\n"
            "    back_colour = \"red\"\n"
            "    ^\n"
            "    \"back_colour\" is a key of [[sheet]], [[mesh]]");
}

}  // namespace
}  // namespace taut
