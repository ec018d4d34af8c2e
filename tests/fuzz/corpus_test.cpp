#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "flags_target.h"
#include "scene_target.h"

// Everything that the fuzzers began from or found is tried again: what goes wrong ends the program.

namespace taut::testing {
namespace {

std::vector<std::filesystem::path> corpus(const std::string& kind) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(TAUT_TEST_DATA "/fuzz/corpus/" + kind))
    files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

void try_each(const std::string& kind, const std::function<void(const std::string&)>& try_text) {
  for (const std::filesystem::path& file : corpus(kind)) {
    SCOPED_TRACE(file.string());
    std::ifstream in(file, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    EXPECT_TRUE(in);
    try_text(text);
  }
}

TEST(FuzzCorpus, ScenesAreDrawnOrRefused) {
  EXPECT_GE(corpus("scene").size(), 40U);
  try_each("scene", [](const std::string& text) { try_scene(text, Depth::picture); });
}

TEST(FuzzCorpus, FlagsAreReadOrRefused) {
  EXPECT_GE(corpus("flags").size(), 40U);
  try_each("flags", try_flag);
}

}  // namespace
}  // namespace taut::testing
