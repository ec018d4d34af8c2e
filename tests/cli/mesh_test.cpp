#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program.h"

namespace taut::testing {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

// A scene with a mesh and a table in a folder beside it.
class MeshTest : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_.path() / "scenes/files");
    folder_.write("scenes/files/square.obj", square);
    folder_.write("scenes/files/masses.csv", "x,y,z,pinned\n3,1,0,1\n3,0,0,0\n");
    folder_.write("scenes/files/links.csv", "a,b\n0,1\n");
    folder_.write("scenes/square.toml", scene);
  }
  Ran run(Words words, const std::string& from = "") const {
    return taut(std::move(words), {}, folder_.path() / from);
  }
  Ran render() const {
    return run({"render", "scenes/square.toml", "-o", folder_ / "out", "--size", "64x48", "--fps", "10"});
  }

  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
  const std::string scene =
      "[world]\nduration = 0.3\n[solve]\nmethod = \"xpbd\"\nsteps_per_second = 200\n"
      "[[mesh]]\nname = \"cloth\"\nfile = \"files/square.obj\"\npinned_masses = [3]\n"
      "[[points]]\nname = \"net\"\nmasses = \"files/masses.csv\"\nlinks = \"files/links.csv\"\n"
      "[look]\nsurface = true\n";
  TemporaryFolder folder_;
};

TEST_F(MeshTest, IsFoundFromTheFolderOfTheScene) {
  EXPECT_EQ(run({"check", "scenes/square.toml"}).status, 0);
  EXPECT_EQ(run({"check", "../scenes/square.toml"}, "scenes").status, 0);
  EXPECT_EQ(run({"check", "square.toml"}, "scenes").status, 0);
  const Ran named = taut({"check", "square"}, {{"TAUT_SCENES", folder_ / "scenes"}}, "/");
  EXPECT_EQ(named.status, 0) << named.err;
  const Ran masses = run({"export", "scenes/square.toml", "--times", "0"});
  EXPECT_NE(masses.out.find("cloth.2,1,1,0"), std::string::npos) << masses.out;
  EXPECT_NE(masses.out.find("net.1,3,0,0"), std::string::npos) << masses.out;
}

TEST_F(MeshTest, AChangedFileIsAnotherScene) {
  ASSERT_EQ(render().status, 0);
  EXPECT_EQ(render().status, 0);
  const Ran deep = run({"verify", folder_ / "out", "--deep"});
  EXPECT_EQ(deep.status, 0) << deep.err;
  folder_.write("scenes/files/square.obj", square + "# not as it was\n");
  const Ran again = render();
  EXPECT_EQ(again.status, 4) << again.err;
  const Ran changed = run({"verify", folder_ / "out", "--deep"});
  EXPECT_NE(changed.status, 0);
  EXPECT_NE(changed.err.find("files/square.obj: it has changed"), std::string::npos) << changed.err;
}

// A scene whose only file is a solid's.
TEST_F(MeshTest, AMotionOverASolidIsDrawnFromAnywhereAndIsOfItsFile) {
  folder_.write("scenes/files/roof.obj",
                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  folder_.write("scenes/square.toml",
                "[world]\nduration = 0.3\n[solve]\nmethod = \"xpbd\"\nsteps_per_second = 200\n"
                "[[mass]]\nname = \"ball\"\nposition = [0.1, 2.0, 0.1]\nradius = 0.1\n"
                "[[solid]]\nfile = \"files/roof.obj\"\n");
  ASSERT_EQ(run({"simulate", "scenes/square.toml", "-o", folder_ / "motion", "--fps", "10"}).status, 0);
  const Words drawing{"render", "--motion", folder_ / "motion", "-o", folder_ / "seen", "--size", "64x48"};
  const Ran drawn = taut(drawing, {}, "/");
  EXPECT_EQ(drawn.status, 0) << drawn.err;
  folder_.write("scenes/files/roof.obj",
                "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  const Ran changed = taut(drawing, {}, "/");
  EXPECT_NE(changed.status, 0);
  EXPECT_NE(changed.err.find("files/roof.obj: it has changed"), std::string::npos) << changed.err;
}

TEST_F(MeshTest, AMotionIsDrawnFromAnywhere) {
  ASSERT_EQ(run({"simulate", "scenes/square.toml", "-o", folder_ / "motion", "--fps", "10"}).status, 0);
  const Ran drawn =
      taut({"render", "--motion", folder_ / "motion", "-o", folder_ / "seen", "--size", "64x48"}, {}, "/");
  EXPECT_EQ(drawn.status, 0) << drawn.err;
}

TEST_F(MeshTest, ErrorsNameSceneAndFile) {
  folder_.write("scenes/files/square.obj", square + "f 1 2 9\n");
  const Ran ran = render();
  EXPECT_EQ(ran.status, 2);
  EXPECT_NE(
      ran.err.find(
          "scenes/square.toml:8:1: files/square.obj:7: the face has vertex 9, and there are 4 before it"),
      std::string::npos)
      << ran.err;
  EXPECT_FALSE(fs::exists(folder_.path() / "out"));
  folder_.write("scenes/files/square.obj", square);
  folder_.write("scenes/files/links.csv", "a,b\n0,2\n");
  const Ran table = render();
  EXPECT_EQ(table.status, 2);
  EXPECT_NE(
      table.err.find("scenes/square.toml:13:1: files/links.csv:2:3: files/masses.csv has no mass \"2\""),
      std::string::npos)
      << table.err;
}

// What is written of one moment can be read again, and starts from there.
TEST_F(MeshTest, ExportsAreReadAsPoints) {
  for (const std::string table : {"masses", "links"})
    ASSERT_EQ(run({"export", "scenes/square.toml", "--times", "0.2", "--table", table, "-o", table + ".csv"})
                  .status,
              0);
  folder_.write("again.toml",
                "[world]\nduration = 0.1\n[[points]]\nname = \"all\"\nmasses = \"masses.csv\"\nlinks = "
                "\"links.csv\"\npinned = "
                "[\"cloth.3\", \"net.0\"]\n");
  ASSERT_EQ(run({"export", "again.toml", "--times", "0", "-o", "again.csv"}).status, 0);
  const std::string before = read_file(folder_ / "masses.csv"), after = read_file(folder_ / "again.csv");
  const std::string row = before.substr(before.find("cloth.1,"),
                                        before.find('\n', before.find("cloth.1,")) - before.find("cloth.1,"));
  EXPECT_NE(after.find("all." + row), std::string::npos) << row << "\n" << after;
}

}  // namespace
}  // namespace taut::testing
