#include <gtest/gtest.h>

#include <string>

#include "base/failure.h"
#include "meshes/read_points.h"
#include "temporary_folder.h"

namespace taut::testing {
namespace {

const std::string three_masses =
    "name,x,y,z,vx,mass,radius,pinned\na,0,2,0,,1.5,0.1,1\nb,1,2,0,0.5,,,0\n\"c, d\",1,1,0,,,,\n";

class PointsFiles : public ::testing::Test {
 protected:
  PointsReading read(const std::string& masses, const std::string& links, PointsSpec spec = {}) const {
    spec.masses = "m.csv";
    folder_.write("m.csv", masses);
    if (!links.empty()) {
      spec.links = "l.csv";
      folder_.write("l.csv", links);
    }
    return read_points(folder_.path() / "m.csv", folder_.path() / "l.csv", spec);
  }
  std::string error(const std::string& masses, const std::string& links = {}) const {
    try {
      read(masses, links);
      return {};
    } catch (const BadRequest& problem) {
      return problem.what();
    }
  }

  TemporaryFolder folder_;
};

TEST_F(PointsFiles, AreRead) {
  const PointsReading reading = read(three_masses, "a,b,length,stiffness\na,b,,500\n\"c, d\",b,1.25,\n");
  const PointsData& data = *reading.data;
  ASSERT_EQ(data.masses.size(), 3U);
  EXPECT_EQ(data.masses[0].name, "a");
  EXPECT_EQ(data.masses[2].name, "c, d");
  EXPECT_EQ(data.masses[1].position, Vec3(1, 2, 0));
  EXPECT_EQ(data.masses[1].velocity, Vec3(0.5, 0, 0));
  EXPECT_EQ(data.masses[0].mass, 1.5);
  EXPECT_EQ(data.masses[1].mass, std::nullopt);
  EXPECT_EQ(data.masses[0].radius, 0.1);
  EXPECT_TRUE(data.masses[0].pinned);
  EXPECT_FALSE(data.masses[1].pinned);
  ASSERT_EQ(data.links.size(), 2U);
  EXPECT_EQ(data.links[0].length, std::nullopt);
  EXPECT_EQ(data.links[0].stiffness, 500.0);
  EXPECT_EQ(data.links[1].a, 2U);
  EXPECT_EQ(data.links[1].length, 1.25);
}

TEST_F(PointsFiles, ArePlaced) {
  PointsSpec spec;
  spec.turn = {0.0, 0.0, 90.0};
  spec.position = {0.0, 0.0, 7.0};
  const PointsReading reading = read("x,y,z,vx\r\n1,0,0,2\r\n", "", spec);
  const PointsData::Mass& mass = reading.data->masses.at(0);
  EXPECT_LT((mass.position - Vec3(0, 1, 7)).norm(), 1e-15);
  EXPECT_LT((mass.velocity - Vec3(0, 2, 0)).norm(), 1e-15);
  EXPECT_EQ(mass.name, "0");
}

TEST_F(PointsFiles, ThatAreExportsOfOneMoment) {
  const PointsReading reading =
      read("frame,time,mass,name,x,y,z,vx,vy,vz\n1,0,0,rope.0,0,2,0,0,0,0\n1,0,1,rope.1,1,2,0,0,-1,0\n",
           "frame,time,link,a,b,rest_length,length,strain,tension,broken_at\n"
           "1,0,0,rope.0,rope.1,1.5,1,-0.3,,\n1,0,1,rope.0,rope.1,1,,,,0.5\n");
  EXPECT_EQ(reading.data->masses[1].mass, std::nullopt);  // that column numbers them
  EXPECT_EQ(reading.data->masses[1].velocity, Vec3(0, -1, 0));
  ASSERT_EQ(reading.data->links.size(), 1U);  // a broken one is none
  EXPECT_EQ(reading.data->links[0].length, 1.5);
  EXPECT_EQ(error("frame,time,mass,name,x,y,z,vx,vy,vz\n1,0,0,a,0,0,0,0,0,0\n2,1,0,a,0,0,0,0,0,0\n"),
            "m.csv:3:1: another moment begins here: export one alone, as with --times 0");
}

TEST_F(PointsFiles, ThatAreWrongSayWhatAndWhere) {
  EXPECT_EQ(error(""), "m.csv: the file is empty");
  EXPECT_EQ(error("\n\n"), "m.csv: the file is empty");
  EXPECT_EQ(error("x,y,z\n"), "m.csv: there are no masses in it");
  EXPECT_EQ(error("x,y\n1,2\n"), "m.csv:1:1: there is no column \"z\"");
  EXPECT_EQ(error("x,y,z,mas\n1,2,3,4\n"),
            "m.csv:1:7: there is no column \"mas\" here; did you mean \"mass\"?");
  EXPECT_EQ(error("x,y,z,x\n"), "m.csv:1:7: the heading \"x\" is there twice");
  EXPECT_EQ(error("x,y,z\n1,2,3\n1,abc,3\n"), "m.csv:3:3: y must be a number, not \"abc\"");
  EXPECT_EQ(error("x,y,z\n1,2,nan\n"), "m.csv:2:5: z must be a number, not \"nan\"");
  EXPECT_EQ(error("x,y,z\n1,,3\n"), "m.csv:2:3: y is missing");
  EXPECT_EQ(error("x,y,z\n1,2\n"), "m.csv:2:3: the row has 2 fields, and there are 3 headings");
  EXPECT_EQ(error("x,y,z\n1,2,2e6\n"), "m.csv:2:5: z must be from -1e+06 to 1e+06, not 2000000");
  EXPECT_EQ(error("x,y,z,mass\n1,2,3,0\n"), "m.csv:2:7: mass must be above 0, not 0");
  EXPECT_EQ(error("x,y,z,pinned\n1,2,3,yes\n"), "m.csv:2:7: pinned must be 0, 1, false or true, not \"yes\"");
  EXPECT_EQ(error("name,x,y,z\né,1,2,3\né,2,2,3\n"), "m.csv:3:1: the name \"é\" is in line 2 already");
  EXPECT_EQ(error("name,x,y,z\n\"a,1,2,3\n"), "m.csv:2:1: the quote that opens here is never closed");
  EXPECT_EQ(error("name,x,y,z\n\"a\"b,1,2,3\n"), "m.csv:2:4: a field in quotes ends at its quote");
  EXPECT_EQ(error(three_masses, "a,b\na,e\n"), "l.csv:2:3: m.csv has no mass \"e\"");
  EXPECT_EQ(error(three_masses, "a,b\na,a\n"), "l.csv:2:3: a link can't join \"a\" to itself");
  EXPECT_EQ(error(three_masses, "a,b\n0,3\n"), "l.csv:2:3: m.csv has no mass \"3\"");
  EXPECT_EQ(error("x,y,z\n1,2,3\n1,2,3\n", "a,b\n0,1\n"),
            "l.csv:2:3: \"0\" and \"1\" are at the same point, so their link has no direction");
  EXPECT_EQ(error(three_masses, "a,b,damping\na,b,1\n"),
            "l.csv:2:5: damping needs a stiffness: a rigid link has no speed to damp");
  EXPECT_EQ(error(three_masses, "a,b,break_stretch\na,b,1\n"),
            "l.csv:2:5: break_stretch must be above 1, not 1");
}

}  // namespace
}  // namespace taut::testing
