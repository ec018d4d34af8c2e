#include <gtest/gtest.h>

#include <string>

#include "base/failure.h"
#include "model/state.h"
#include "scene/scene.h"
#include "temporary_folder.h"

namespace taut {
namespace {

// A scene with every key of meshes, points and solids.
const std::string everything_from_files = R"(
[[mesh]]
name = "cloth"
file = "square.obj"
mass = 0.7
shares = "equal"
scale = 0.5
up = "z"
position = [0.1, 2, 0.30000000000000004]
turn = [10, 20, 30]
weld = 1e-5
pinned = ["left"]
pinned_box = [[-1, -1, -1], [9, 9, 9]]
pinned_masses = [0, 2]
motion = { amplitude = [0, 0.1, 0], angular_frequency = 10, phase = 1e-300 }
release = 2.5
collides = true
stiffness = 500
damping = 0.1
break_stretch = 1.3
scatter = 0.1
diagonals = true
skip_one = { stiffness = 30, damping = 0.1, break_tension = 7 }
bending = { stiffness = 0.001, from_start = true }
faces = { thickness = 0.01, friction = 0.3, self_collides = false }
colour = "teal"
draw = ["surface"]
[[points]]
name = "net"
masses = "masses.csv"
links = "links.csv"
position = [5, 0, 0]
turn = [0, 0, 90]
mass = 0.3
pinned = ["b"]
radius = 0.01
collides = true
stiffness = 100
break_tension = 5
colour = "#ff0000"
[[solid]]
name = "roof"
file = "roof.obj"
scale = 0.5
up = "z"
position = [0.1, -7, 0.30000000000000004]
turn = [10, 20, 30]
weld = 1e-5
friction = 0.3
restitution = 0.1
motion = { amplitude = [0, 0.1, 0], angular_frequency = 10, phase = 1e-300 }
rotation = { axis = [0, 1, 0], rate = 20, rise = 0.3 }
visible = false
colour = "gold"
[solve]
method = "xpbd"
)";

class SceneMeshes : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.write("square.obj", square_);
    folder_.write("roof.obj", roof_);
    folder_.write("masses.csv", "name,x,y,z\na,0,0,0\nb,1,0,0\n");
    folder_.write("links.csv", "a,b,length\na,b,1.5\n");
  }
  std::string error_of(const std::string& text) const {
    try {
      parse_scene(text, folder_ / "f.toml");
      return {};
    } catch (const BadRequest& problem) {
      const std::string said = problem.what();
      return said.substr(said.find("f.toml"), said.find('\n') - said.find("f.toml"));
    }
  }

  const std::string square_ = "g left\nv 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nf 1 2 3\nf 1 3 4\n";
  const std::string roof_ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  testing::TemporaryFolder folder_;
};

TEST_F(SceneMeshes, ResolvedTextGivesTheSameScene) {
  const Scene scene = parse_scene(everything_from_files, folder_ / "f.toml");
  EXPECT_EQ(scene.model.masses.size(), 6U);
  const std::string resolved = resolved_toml(scene);
  EXPECT_EQ(resolved.find("# content"), std::string::npos) << resolved;
  const Scene again = parse_scene(resolved, folder_ / "f.toml");
  EXPECT_EQ(resolved_toml(again), resolved);
  EXPECT_EQ(state_hash(again.start), state_hash(scene.start));
  EXPECT_EQ(again.model.links.length, scene.model.links.length);
}

TEST_F(SceneMeshes, AResolvedSceneIsOfItsFilesAsTheyWere) {
  const std::string resolved = resolved_toml(parse_scene(everything_from_files, folder_ / "f.toml"));
  folder_.write("links.csv", "a,b,length\na,b,1.25\n");
  const std::string table = error_of(resolved);
  EXPECT_NE(table.find("masses.csv: it has changed: its content is"), std::string::npos) << table;
  folder_.write("links.csv", "a,b,length\na,b,1.5\n");
  EXPECT_EQ(error_of(resolved), "");
  folder_.write("square.obj", square_ + "\n");
  const std::string mesh = error_of(resolved);
  EXPECT_NE(mesh.find("square.obj: it has changed: its content is"), std::string::npos) << mesh;
  folder_.write("square.obj", square_);
  folder_.write("roof.obj", roof_ + "\n");
  const std::string roof = error_of(resolved);
  EXPECT_NE(roof.find("roof.obj: it has changed: its content is"), std::string::npos) << roof;
}

TEST_F(SceneMeshes, ErrorsPointAtTheSceneAndIntoTheFile) {
  EXPECT_EQ(error_of("[[mesh]]\nname = \"cloth\"\n  file = \"away.obj\"\n"),
            "f.toml:3:3: away.obj: no such file");
  folder_.write("bad.obj", square_ + "f 1 2 7\n");
  EXPECT_EQ(error_of("[[mesh]]\nname = \"cloth\"\nfile = \"bad.obj\"\n"),
            "f.toml:3:1: bad.obj:8: the face has vertex 7, and there are 4 before it");
  EXPECT_EQ(error_of("[[mesh]]\nname = \"cloth\"\nfile = \"square.obj\"\npinned = [\"lefts\"]\n"),
            "f.toml:4:1: \"square.obj\" has no group or material named \"lefts\"");
  EXPECT_EQ(error_of("[[solid]]\nfile = \"square.obj\"\n").substr(0, 56),
            "f.toml:2:1: square.obj:6: the surface is open, and a sol");
  EXPECT_EQ(error_of("[[points]]\nname = \"net\"\nmasses = \"square.obj\"\n"),
            "f.toml:3:1: square.obj:1:1: there is no column \"g left\" here");
}

TEST_F(SceneMeshes, NotesAreKept) {
  folder_.write("two.obj", square_ + "v 5 0 0\nv 6 0 0\nv 5 0 1\nf 5 6 7\n");
  const Scene scene = parse_scene("[[mesh]]\nname = \"cloth\"\nfile = \"two.obj\"\n", folder_ / "f.toml");
  ASSERT_EQ(scene.notes.size(), 1U);
  EXPECT_NE(scene.notes[0].find("f.toml:3:1: note: two.obj: it is in 2 pieces"), std::string::npos)
      << scene.notes[0];
}

TEST_F(SceneMeshes, ASeamNamesItsMassesInAMesh) {
  EXPECT_EQ(error_of("[[mesh]]\nname = \"cloth\"\nfile = \"square.obj\"\n[[seam]]\nsheet = \"cloth\"\nrow = "
                     "0\nstrength = 0.5\n"),
            "f.toml:5:1: \"cloth\" is a mesh, which has no rows and columns: say between which masses the "
            "seam lies, "
            "with \"a\" and \"b\"");
}

}  // namespace
}  // namespace taut
