#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "base/failure.h"
#include "export/scratch_file.h"
#include "export/zip_writer.h"
#include "exported_states.h"

// CSV against the states themselves, bit for bit: what scripts hold the other formats against.

namespace taut::testing {
namespace {

// Rows of cells, the first line left out; quotes are those of RFC 4180.
std::vector<std::vector<std::string>> cells_of_csv(const std::string& text) {
  std::vector<std::vector<std::string>> rows{{""}};
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string& cell = rows.back().back();
    if (text[i] == '"' && quoted && i + 1 < text.size() && text[i + 1] == '"')
      cell += text[++i];
    else if (text[i] == '"')
      quoted = !quoted;
    else if (text[i] == ',' && !quoted)
      rows.back().emplace_back();
    else if (text[i] == '\n' && !quoted)
      rows.push_back({""});
    else
      cell += text[i];
  }
  rows.pop_back();
  rows.erase(rows.begin());
  return rows;
}

double number(const std::string& cell) {
  return std::strtod(cell.c_str(), nullptr);
}

class ExportTablesTest : public ::testing::Test {
 protected:
  std::vector<std::vector<std::string>> table(ExportTable table) {
    return cells_of_csv(read_file(exported_.write("csv", folder_, table)));
  }

  TemporaryFolder folder_;
  ExportedStates exported_;
};

TEST_F(ExportTablesTest, MassesAreTheStatesBitForBit) {
  const auto rows = table(ExportTable::masses);
  const std::size_t masses = exported_.model().masses.size();
  ASSERT_EQ(rows.size(), masses * exported_.states().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const State& state = exported_.states()[i / masses];
    const std::size_t mass = i % masses;
    ASSERT_EQ(rows[i].size(), 10U);
    EXPECT_EQ(rows[i][0], std::to_string(i / masses + 1));
    EXPECT_EQ(number(rows[i][1]), state.time);
    EXPECT_EQ(rows[i][3], exported_.model().masses.name[mass]);
    const Vec3 x = state.position.at(mass), v = state.velocity.at(mass);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(number(rows[i][static_cast<std::size_t>(4 + axis)]), x[axis]);
      EXPECT_EQ(number(rows[i][static_cast<std::size_t>(7 + axis)]), v[axis]);
    }
  }
}

TEST_F(ExportTablesTest, LinksAreTheStatesBitForBit) {
  const auto rows = table(ExportTable::links);
  const Links& links = exported_.model().links;
  ASSERT_EQ(rows.size(), links.size() * exported_.states().size());
  std::size_t broken = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const State& state = exported_.states()[i / links.size()];
    const std::size_t link = i % links.size();
    ASSERT_EQ(rows[i].size(), 10U);
    EXPECT_EQ(rows[i][3], exported_.model().masses.name[links.a[link]]);
    EXPECT_EQ(rows[i][4], exported_.model().masses.name[links.b[link]]);
    EXPECT_EQ(number(rows[i][5]), links.length[link]);
    if (state.broken(link)) {
      ++broken;
      EXPECT_EQ(number(rows[i][9]), state.broken_at[link]);
      EXPECT_EQ(rows[i][8], "");
      continue;
    }
    EXPECT_EQ(rows[i][9], "");
    EXPECT_EQ(number(rows[i][6]), link_distance(exported_.model(), state.position, link));
    if (state.time > 0.0) {
      EXPECT_EQ(number(rows[i][8]), state.tension[link]);
    }
  }
  EXPECT_EQ(broken, 13U + 14U + 14U) << "at 0.25, 0.4 and 0.5 s";
}

// USD's stage is upright whatever the scene's gravity; its one turn is read from the text.
TEST_F(ExportTablesTest, UsdaStandsUpright) {
  for (const std::string gravity : {"[0, -9.81, 0]", "[0, 0, -9.81]", "[9.81, 0, 0]"}) {
    const ExportedStates exported({"world.gravity=" + gravity});
    const std::string text = read_file(exported.write("usda", folder_));
    const std::string_view begin = "quatd xformOp:orient = (";
    const std::size_t at = text.find(begin);
    ASSERT_NE(at, std::string::npos);
    std::istringstream in(text.substr(at + begin.size()));
    double w = 0.0, x = 0.0, y = 0.0, z = 0.0;
    char comma = ' ';
    in >> w >> comma >> x >> comma >> y >> comma >> z;
    const Vec3 up = Eigen::Quaterniond(w, x, y, z) * Vec3(-exported.model().gravity.normalized());
    EXPECT_LT((up - Vec3::UnitY()).norm(), 1e-12) << gravity << ": " << up.transpose();
  }
}

TEST(ScratchFile, GivesBackWhatWasKeptAndHasNoName) {
  const TemporaryFolder folder;
  ScratchFile scratch(folder.path());
  const std::string large(3 << 20, 'x');
  scratch.append("abc");
  scratch.append(large);
  EXPECT_EQ(scratch.size(), 3U + large.size());
  EXPECT_EQ(folder.entries(), 0U);
  std::string read;
  scratch.copy(1, 2 + large.size(), [&read](std::string_view bytes) { read += bytes; });
  EXPECT_TRUE(read == "bc" + large);
  EXPECT_THROW(scratch.copy(4, large.size(), [](std::string_view) {}), RunFailure) << "beyond its end";
  EXPECT_THROW(ScratchFile(folder.path() / "nowhere"), RunFailure);
}

TEST(ZipWriter, FailsWhereItsBytesAreNotTaken) {
  int taken = 0;
  const auto write_all = [&taken](int most) {
    ZipWriter zip([&taken, most](std::string_view) {
      if (taken++ >= most) throw RunFailure("the disk is full");
    });
    for (const char* name : {"a", "b"}) {
      zip.begin(name, 1 << 20);
      zip.write(std::string(1 << 20, 'x'));
    }
    zip.finish();
  };
  write_all(1 << 20);
  const int all = taken;
  EXPECT_GT(all, 1);
  for (int most = 0; most < all; most += all / 3) {
    taken = 0;
    EXPECT_THROW(write_all(most), RunFailure) << most;
  }
}

}  // namespace
}  // namespace taut::testing
