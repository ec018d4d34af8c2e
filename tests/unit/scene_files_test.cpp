#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "base/failure.h"
#include "scene/scene.h"
#include "temporary_folder.h"

namespace taut {
namespace {

const std::string rope = "[[chain]]\nname = \"rope\"\nfrom = [0, 2, 0]\nto = [2, 2, 0]\n";

class SceneFiles : public ::testing::Test {
 protected:
  std::string errors_of_file(const std::filesystem::path& file) const {
    try {
      load_scene(file);
      return {};
    } catch (const BadRequest& failure) {
      return failure.what();
    }
  }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    return folder_.write(name, text);
  }

  testing::TemporaryFolder folder_;
};

TEST_F(SceneFiles, AreReadAndNamedAfterTheFile) {
  const Scene scene = load_scene(write("long.rope.toml", rope));
  EXPECT_EQ(scene.name, "long.rope");
  EXPECT_EQ(scene.title, "long.rope");
  EXPECT_EQ(scene.model.masses.size(), 2U);
}

TEST_F(SceneFiles, ThatCannotBeRead) {
  const std::filesystem::path missing = folder_.path() / "missing.toml";
  EXPECT_EQ(errors_of_file(missing), missing.string() + ": no such file");
  EXPECT_EQ(errors_of_file(folder_.path()), folder_.path().string() + ": a directory, not a scene file");
  const std::filesystem::path empty = write("empty.toml", "");
  EXPECT_EQ(errors_of_file(empty), empty.string() + ": the file is empty");
}

TEST_F(SceneFiles, MayHaveEightMebibytes) {
  constexpr std::size_t most = 8 << 20;
  const std::string text = rope + "#";
  const std::filesystem::path full = write("full.toml", text + std::string(most - text.size(), '#'));
  EXPECT_EQ(errors_of_file(full), "");
  const std::filesystem::path over = write("over.toml", text + std::string(most + 1 - text.size(), '#'));
  EXPECT_EQ(errors_of_file(over), over.string() + ": larger than 8 MiB, the most a scene may have");
}

}  // namespace
}  // namespace taut
