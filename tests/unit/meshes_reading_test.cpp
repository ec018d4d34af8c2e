#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "mesh_texts.h"

namespace taut::testing {
namespace {

std::vector<Index> face_of(const MeshData& mesh, std::size_t number) {
  const auto face = mesh.face(number);
  return {face.begin(), face.end()};
}

TEST(MeshReading, TheSameSquareOfEveryFormat) {
  const MeshFiles files;
  for (const auto& [name, text] :
       std::vector<std::pair<std::string, std::string>>{{"a.obj", square_obj},
                                                        {"a.ply", square_ply},
                                                        {"a.stl", square_stl},
                                                        {"b.STL", binary_square_stl()}}) {
    const MeshReading reading = files.read(name, text);
    const MeshData& mesh = *reading.data;
    ASSERT_EQ(mesh.vertices.size(), 4U) << name;
    EXPECT_EQ(mesh.vertices[2], Vec3(1, 1, 0)) << name;
    ASSERT_EQ(mesh.face_count(), 2U) << name;
    EXPECT_EQ(face_of(mesh, 0), (std::vector<Index>{0, 1, 2})) << name;
    EXPECT_EQ(face_of(mesh, 1), (std::vector<Index>{0, 2, 3})) << name;
    EXPECT_EQ(mesh.pieces, 1U) << name;
    EXPECT_TRUE(reading.notes.empty()) << name << reading.notes.front();
  }
}

TEST(MeshReading, QuadsStayAndPolygonsAreCut) {
  const MeshFiles files;
  const std::string corners = "v 0 0 0\nv 2 0 0\nv 3 1 0\nv 2 2 0\nv 0 2 0\n";
  const MeshReading quad = files.read("q.obj", corners + "f 1 2 4 5\n");
  EXPECT_EQ(face_of(*quad.data, 0).size(), 4U);
  const MeshReading pentagon = files.read("p.obj", corners + "f 1 2 3 4 5\n");
  EXPECT_EQ(pentagon.data->face_count(), 3U);
  ASSERT_EQ(pentagon.notes.size(), 1U);
  EXPECT_EQ(pentagon.notes[0], "p.obj: a face of more than four corners was cut into triangles");
  const MeshReading dented =
      files.read("d.obj", "v 0 0 0\nv 2 0 0\nv 1 0.5 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4 5\n");
  ASSERT_EQ(dented.data->face_count(), 3U);
  EXPECT_EQ(files.error("s.obj",
                        "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 3 1 0\nv 2 4 0\nv 1 1 0\nv 0 4 0\nf 1 2 3 4 5 6 7\n"),
            "s.obj:8: the face has 7 corners and can't be cut into triangles from any of them: triangulate "
            "it before "
            "it is exported");
}

TEST(MeshReading, WeldsWhatIsNear) {
  const MeshFiles files;
  const std::string seam = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 0.001\nv 1 1 0.001\nv 0 1 0\nf 1 2 3\nf 4 5 6\n";
  const MeshReading apart = files.read("s.obj", seam);
  EXPECT_EQ(apart.data->vertices.size(), 6U);
  EXPECT_EQ(apart.data->pieces, 2U);
  ASSERT_EQ(apart.notes.size(), 1U);
  EXPECT_TRUE(apart.notes[0].starts_with("s.obj: it is in 2 pieces, which nothing holds together"))
      << apart.notes[0];
  MeshSpec spec;
  spec.weld = 0.0011;
  const MeshReading joined = files.read("s.obj", seam, spec);
  EXPECT_EQ(joined.data->vertices.size(), 4U);
  EXPECT_EQ(joined.data->pieces, 1U);
  EXPECT_EQ(joined.data->vertices[3], Vec3(0, 1, 0));  // the masses that are left have no gaps
  // Not by chains: each is as near to the first of its kind.
  std::string row;
  for (int i = 0; i < 10; ++i) row += fmt::format("v {} 0 0\nv {} 1 0\n", 0.001 * i, 0.001 * i);
  spec.weld = 0.0015;
  const MeshReading strip = files.read("r.obj", row + "f 1 5 6 2\nf 5 9 10 6\n", spec);
  EXPECT_EQ(strip.data->vertices.size(), 6U);
}

TEST(MeshReading, ScaleUpTurnAndPosition) {
  const MeshFiles files;
  MeshSpec spec;
  spec.scale = 0.01;
  spec.up = UpAxis::z;
  spec.turn = {0.0, 90.0, 0.0};
  spec.position = {5.0, 0.0, 0.0};
  const MeshReading reading = files.read("a.obj", "v 100 0 0\nv 0 200 0\nv 0 0 300\nf 1 2 3\n", spec);
  const std::vector<Vec3> expected{{5.0, 0.0, -1.0}, {3.0, 0.0, 0.0}, {5.0, 3.0, 0.0}};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_LT((reading.data->vertices[i] - expected[i]).norm(), 1e-15) << i;
}

TEST(MeshReading, GroupsObjectsAndMaterials) {
  const MeshFiles files;
  const MeshReading reading = files.read("g.obj",
                                         "o my shirt\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ng left top\nusemtl "
                                         "red\nf -4 -3 -2\ng right\nf 1/1/1 3//2 4\n");
  const MeshData& mesh = *reading.data;
  const auto vertices = [&](const std::string& name) {
    const auto found = std::ranges::find(mesh.groups, name);
    return found == mesh.groups.end()
               ? std::vector<Index>{}
               : mesh.group_vertices[static_cast<std::size_t>(found - mesh.groups.begin())];
  };
  EXPECT_EQ(vertices("my shirt"), (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(vertices("left"), (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(vertices("top"), (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(vertices("red"), (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(vertices("right"), (std::vector<Index>{0, 2, 3}));
}

TEST(MeshReading, TurnsFacesToRunAsTheirNeighbours) {
  const MeshFiles files;
  const MeshReading reading = files.read("t.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 4 3\n");
  EXPECT_EQ(face_of(*reading.data, 1), (std::vector<Index>{0, 2, 3}));
  ASSERT_EQ(reading.notes.size(), 1U);
  EXPECT_EQ(reading.notes[0],
            "t.obj: a face ran around the other way than its neighbours and was turned over");
}

TEST(MeshReading, LeavesOutWhatIsOfNoUse) {
  const MeshFiles files;
  const MeshReading reading =
      files.read("u.obj", "v 9 9 9\n" + square_obj.substr(11) + "v 0.5 0.5 0\nf 2 2 3\n");
  EXPECT_EQ(reading.data->vertices.size(), 4U);
}

struct Broken {
  std::string name, text, error;
};

TEST(MeshReading, BrokenMeshesSayWhatIsWrongAndWhere) {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const std::vector<Broken> all{
      {"a.obj", "", "a.obj: the file is empty"},
      {"a.fbx", "x", "a.fbx: a mesh's file ends in .obj, .ply or .stl, and not in \".fbx\""},
      {"mesh", "x", "mesh: a mesh's file ends in .obj, .ply or .stl, and not in nothing"},
      {"a.obj", "# nothing\n", "a.obj: there are no vertices in it"},
      {"a.obj", triangle, "a.obj: there are no faces in it, and cloth is made of those"},
      {"a.obj", "hello world\n", "a.obj:1: \"hello\" begins no line of an OBJ file"},
      {"a.obj", "v 0 0 0\nv 1 0\n", "a.obj:2: a vertex needs three numbers"},
      {"a.obj", "v 0 0 nan\n", "a.obj:1: a vertex needs three numbers, and \"nan\" is none"},
      {"a.obj", "v 0 0 1e999\n", "a.obj:1: a vertex needs three numbers, and \"1e999\" is none"},
      {"a.obj", "v 0 1,5 0\n", "a.obj:1: a vertex needs three numbers, and \"1,5\" is none"},
      {"a.obj", triangle + "f 1 2\n", "a.obj:4: a face needs three corners, not 2"},
      {"a.obj", triangle + "f 1 2 4\n", "a.obj:4: the face has vertex 4, and there are 3 before it"},
      {"a.obj", triangle + "f 1 2 0\n",
       "a.obj:4: a corner of a face is the number of a vertex, and \"0\" is none"},
      {"a.obj", triangle + "f 1 2 x/1\n",
       "a.obj:4: a corner of a face is the number of a vertex, and \"x/1\" is none"},
      {"a.obj", triangle + "v 2e6 0 0\nf 1 2 4\n",
       "a.obj:4: a vertex is more than 1000 km from the scene's origin"},
      {"a.obj", triangle + "v 2 0 0\nf 1 2 3\nf 1 2 4\n",
       "a.obj:6: the face has no area: its corners lie on a line"},
      {"a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 2 2 0\nf 1 2 3 2\n",
       "a.obj:5: the face comes to one of its corners twice"},
      {"a.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\nf 1 2 3\nf 1 2 4\nf 2 1 5\n",
       "a.obj:8: three faces meet at one edge, and cloth has two at most: those of lines 6, 7 and 8, from "
       "(0, 0, 1) "
       "to (0, 0, 0) in the file"},
      {"a.obj", "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n",
       "a.obj: no face is left, since all of its corners are within 0 m of each other: is \"scale\" right, "
       "or "
       "\"weld\" too large?"},
      {"a.ply", "solid x\n", "a.ply: not a PLY file, which begins with \"ply\""},
      {"a.ply",
       square_ply.substr(0, square_ply.find("0 0 0")) + "0 0 nan\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n",
       "a.ply:10: \"nan\" is no number"},
      {"a.ply", square_ply + "x", ""},
  };
  const MeshFiles files;
  for (const Broken& each : all) EXPECT_EQ(files.error(each.name, each.text), each.error);
  const std::string no_area =
      files.error("a.ply", square_ply.substr(0, square_ply.rfind("3 0 2 3")) + "3 0 1 1\n");
  EXPECT_EQ(no_area, "");  // smaller than any weld: left out
  MeshSpec missing;
  missing.file = "away.obj";
  try {
    read_mesh("/nowhere/away.obj", missing);
    ADD_FAILURE();
  } catch (const BadRequest& problem) {
    EXPECT_STREQ(problem.what(), "away.obj: no such file");
  }
}

// Whatever is in a file, reading it ends, with a mesh or with a sentence.
TEST(MeshReading, DamagedFilesAreRefusedOrRead) {
  const MeshFiles files;
  std::mt19937 chance(5);
  int refused = 0, tried = 0;
  for (const auto& [name, whole] :
       std::vector<std::pair<std::string, std::string>>{{"a.obj", square_obj},
                                                        {"a.ply", square_ply},
                                                        {"a.stl", square_stl},
                                                        {"b.stl", binary_square_stl()}}) {
    for (int round = 0; round < 150; ++round) {
      std::string text = whole;
      if (round % 3 == 0) text.resize(chance() % text.size());
      for (unsigned i = 0; i < 1 + chance() % 3 && !text.empty(); ++i)
        text[chance() % text.size()] = static_cast<char>(chance() % 256);
      ++tried;
      try {
        const MeshReading reading = files.read(name, text);
        EXPECT_GT(reading.data->face_count(), 0U);
        for (const Index corner : reading.data->corners) ASSERT_LT(corner, reading.data->vertices.size());
      } catch (const BadRequest& problem) {
        EXPECT_TRUE(std::string_view(problem.what()).starts_with(name)) << problem.what();
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, tried / 4);
}

}  // namespace
}  // namespace taut::testing
