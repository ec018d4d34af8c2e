// The pictures in docs/ are those that the commands beside them make.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "program.h"
#include "read_picture.h"

namespace taut::testing {
namespace {

namespace fs = std::filesystem;

const fs::path docs = fs::path(TAUT_SOURCE_DIR) / "docs";

struct Entry {
  std::string file, title, command;
};

std::vector<Entry> gallery() {
  std::ifstream list(docs / "gallery.txt");
  std::vector<Entry> entries;
  Entry entry;
  while (std::getline(list, entry.file)) {
    if (entry.file.empty() || entry.file.front() == '#') continue;
    std::getline(list, entry.title);
    std::getline(list, entry.command);
    entries.push_back(entry);
  }
  return entries;
}

int make(const std::string& arguments, const std::string& folder = {}) {
  const std::string command = "TAUT_PROGRAM='" TAUT_PROGRAM "' TAUT_GALLERY='" + folder + "' bash '" +
                              (docs / "make.sh").string() + "' " + arguments + " > /dev/null 2>&1";
  return std::system(command.c_str());
}

TEST(Gallery, HasEveryPictureThatItNames) {
  const std::vector<Entry> entries = gallery();
  ASSERT_GT(entries.size(), 10U);
  for (const Entry& entry : entries) {
    EXPECT_TRUE(fs::exists(docs / entry.file)) << entry.file;
    EXPECT_EQ(entry.command.rfind("taut ", 0), 0U) << entry.command;
    EXPECT_NE(entry.command.find(entry.file), std::string::npos) << entry.command;
  }
}

TEST(Gallery, ItsPageIsTheOneThatTheListMakes) {
  const TemporaryFolder folder;
  ASSERT_EQ(make("--page '" + folder / "page.html" + "'"), 0);
  EXPECT_EQ(read_file(folder / "page.html"), read_file((docs / "gallery.html").string()));
}

// Another processor may round a pixel to the next level; a change of the picture shows in more.
TEST(GalleryPictures, AreMadeAgain) {
  const TemporaryFolder folder;
  const std::array<std::string, 3> sample{"pendulum.png", "heavy-tip.png", "hanging-chain-two-pins.png"};
  for (const std::string& name : sample) {
    ASSERT_EQ(make(name, folder / ""), 0) << name;
    const Pixels there = read_picture((docs / name).string()), again = read_picture(folder / name);
    ASSERT_GT(there.width, 0) << name;
    ASSERT_EQ(there.width, again.width) << name;
    ASSERT_EQ(there.height, again.height) << name;
    std::size_t off = 0;
    for (std::size_t i = 0; i < there.rgb.size(); ++i)
      off += std::abs(there.rgb[i] - again.rgb[i]) > 3 ? 1 : 0;
    EXPECT_LT(static_cast<double>(off), 1e-3 * static_cast<double>(there.rgb.size())) << name;
  }
}

}  // namespace
}  // namespace taut::testing
