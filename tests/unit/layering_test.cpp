#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

// Which folder of src/ may include which: the directions that keep each part ignorant of what it need not
// know.

namespace taut {
namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::set<std::string>> may_use{
    {"base", {}},
    {"host", {"base"}},
    {"view", {"base"}},
    {"model", {"base"}},
    {"methods", {"base", "model"}},
    {"motion", {"base", "model", "methods"}},
    {"measure", {"base", "view", "model", "methods", "motion"}},
    {"meshes", {"base", "model"}},
    {"scene", {"base", "model", "methods", "view", "meshes"}},
    {"render", {"base", "model", "view"}},
    {"output", {"base", "model", "methods", "motion"}},
    {"frames",
     {"base", "host", "view", "model", "methods", "motion", "measure", "scene", "render", "output",
      "meshes"}},
    {"study",
     {"base", "host", "view", "model", "methods", "motion", "measure", "scene", "render", "output", "frames",
      "meshes"}},
};

struct Include {
  fs::path file;
  std::string folder;  // of src/ that the file belongs to
  std::string name;    // between the quotes
};

// Calls visit(file, match) for each line of the source that a pattern is found in.
template <class Visit>
void for_each_match(const std::regex& pattern, const Visit& visit) {
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(TAUT_SOURCE_DIR "/src")) {
    if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
    std::ifstream in(entry.path());
    for (std::string line; std::getline(in, line);) {
      std::smatch match;
      if (std::regex_search(line, match, pattern)) visit(entry.path(), match);
    }
  }
}

std::vector<Include> quoted_includes() {
  const std::regex pattern(R"re(^\s*#\s*include\s*"([^"]*)")re");
  std::vector<Include> found;
  for_each_match(pattern, [&](const fs::path& file, const std::smatch& match) {
    const std::string folder = file.lexically_relative(TAUT_SOURCE_DIR "/src").begin()->string();
    found.push_back({file, folder, match[1]});
  });
  return found;
}

TEST(Layering, EveryFolderOfTheSourceIsKnownHere) {
  std::set<std::string> there, known;
  for (const fs::directory_entry& entry : fs::directory_iterator(TAUT_SOURCE_DIR "/src"))
    if (entry.is_directory()) there.insert(entry.path().filename().string());
  for (const auto& [folder, others] : may_use) known.insert(folder);
  EXPECT_EQ(there, known);
}

TEST(Layering, IncludesGoOnlyWhereTheyMay) {
  const std::vector<Include> includes = quoted_includes();
  EXPECT_GT(includes.size(), 50U) << "the search itself is broken";
  for (const Include& include : includes) {
    EXPECT_EQ(include.name.find("../"), std::string::npos) << include.file << ": " << include.name;
    const std::size_t slash = include.name.find('/');
    if (slash == std::string::npos) continue;  // a private header beside the file
    const std::string target = include.name.substr(0, slash);
    if (fs::exists(fs::path(TAUT_SOURCE_DIR "/src") / include.folder / include.name)) continue;  // private
    EXPECT_TRUE(target == include.folder || may_use.at(include.folder).contains(target))
        << include.file << " may not include " << include.name;
  }
}

// All are in one namespace: of two types of one name in two headers a linker keeps the functions of one.
TEST(Layering, TypesOfHeadersHaveNamesOfTheirOwn) {
  const std::regex pattern(R"re(^(?:class|struct|enum class) (\w+)(?:[ :{][^;<]*)?$)re");
  std::map<std::string, fs::path> first;
  for_each_match(pattern, [&](const fs::path& file, const std::smatch& match) {
    if (file.extension() != ".h") return;
    const auto [known, is_new] = first.emplace(match[1], file);
    EXPECT_TRUE(is_new) << match[1] << " of " << file << " is also in " << known->second;
  });
  EXPECT_GT(first.size(), 200U) << "the search itself is broken";
}

}  // namespace
}  // namespace taut
