#include <gtest/gtest.h>

#include "base/failure.h"
#include "output/manifest.h"
#include "temporary_folder.h"

namespace taut {
namespace {

Manifest example() {
  Manifest manifest;
  manifest.inputs = "0123456789abcdef";
  manifest.scene = "chain";
  manifest.scene_toml = "title = \"Ein „Seil“\"\n[world]\nduration = 0.1\n";
  manifest.method = "xpbd";
  manifest.settings = {{"passes", 3.0}, {"steps_per_second", 0.1}, {"velocities", std::string("kept")}};
  manifest.size = {640, 360};
  manifest.frames_per_second = 29.97;
  manifest.frame_rate = "2997/100";
  manifest.frame_count = 180;
  manifest.colour_range = 0.1;
  manifest.picture = "4 samples";
  manifest.build = "taut 0";
  manifest.frames = {{1, {"aa", "11"}}, {7, {"bb", "22"}}, {123456, {"cc", "33"}}};
  manifest.films = {{"../chain.mp4", "1-7", 123'456'789'012, "dd"}};
  return manifest;
}

TEST(Manifest, ComesBackAsItWasWritten) {
  const testing::TemporaryFolder folder;
  write_manifest(folder / "manifest.json", example());
  const auto read = read_manifest(folder / "manifest.json");
  ASSERT_TRUE(read);
  EXPECT_EQ(manifest_text(*read), manifest_text(example()));
  EXPECT_EQ(read->frames, example().frames);
  EXPECT_EQ(read->settings, example().settings);
  EXPECT_EQ(read->films.at(0).bytes, 123'456'789'012U);
}

TEST(Manifest, IsNothingWhereThereIsNone) {
  const testing::TemporaryFolder folder;
  EXPECT_FALSE(read_manifest(folder / "manifest.json"));
}

TEST(Manifest, OfAnotherKindIsAConflict) {
  const testing::TemporaryFolder folder;
  for (const char* text : {"", "{", "[]", "{\"name\": \"an app\"}", "{\"taut_manifest\": 999}"}) {
    const std::string file = folder.write("manifest.json", text);
    EXPECT_THROW(read_manifest(file), OutputConflict) << text;
  }
}

}  // namespace
}  // namespace taut
