#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "program.h"

// The formats of `taut export` through the program: read back by NumPy and pandas, and all that may be asked
// for wrongly. What Assimp makes of them is in unit/export_assimp_test.cpp, VTK and Blender in
// foreign/read_back.sh.

namespace taut::testing {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const std::string foreign = TAUT_TEST_DATA "/foreign/";

class ExportFormatsTest : public ::testing::Test {
 protected:
  // `taut export` of the scene with all that breaks, ten frames a second, five of them.
  Ran export_shapes(const Words& more) const {
    Words words{"export", foreign + "shapes.toml", "--fps", "10"};
    words.insert(words.end(), more.begin(), more.end());
    return taut(words, {}, folder_.path());
  }

  std::set<std::string> names_in(const std::string& folder) const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_ / folder)) names.insert(entry.path().filename());
    return names;
  }

  void expect_checked(const std::string& script, const std::string& folder) const {
    const Ran ran = run_program(TAUT_PYTHON, {foreign + script, folder, "cloth"});
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_NE(ran.out.find("as the CSV says"), std::string::npos) << ran.out;
  }

  TemporaryFolder folder_;
};

TEST_F(ExportFormatsTest, ReadBackByOthers) {
  const std::string out = folder_ / "out";
  const Ran ran =
      run_program("/bin/bash", {foreign + "export_all.sh", TAUT_PROGRAM, foreign + "shapes.toml", out, "10"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  expect_checked("check_arrays.py", out);
  expect_checked("check_usda.py", out);
}

// What was simulated before, and now: the same bytes.
TEST_F(ExportFormatsTest, AStoredMotionIsTheSame) {
  ASSERT_EQ(
      taut({"simulate", foreign + "shapes.toml", "--fps", "10", "-o", "motion"}, {}, folder_.path()).status,
      0);
  for (const std::string file : {"m.csv", "m.npz", "m.usda", "m.glb"}) {
    ASSERT_EQ(export_shapes({"-o", file}).status, 0) << file;
    const Ran ran = taut({"export", "--motion", "motion", "-o", "again-" + file}, {}, folder_.path());
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(read_file(folder_ / file) == read_file(folder_ / ("again-" + file))) << file;
  }
  const Ran energies = taut({"export", "--motion", "motion", "--table", "energy"}, {}, folder_.path());
  EXPECT_EQ(energies.out, export_shapes({"--table", "energy"}).out);
  const Ran between = taut({"export", "--motion", "motion", "--times", "0.15"}, {}, folder_.path());
  EXPECT_EQ(between.status, 2);
  EXPECT_NE(between.err.find("has no moment at 0.15 s"), std::string::npos) << between.err;
}

TEST_F(ExportFormatsTest, AFolderHoldsItsFilesAndNoOthers) {
  const Words vtp{"--format", "vtp", "-o", "vtp"};
  ASSERT_EQ(export_shapes(vtp).status, 0);
  EXPECT_EQ(names_in("vtp").size(), 5U + 5U + 2U);
  // Fewer frames the second time: those of the first don't stay.
  ASSERT_EQ(export_shapes({"--format", "vtp", "-o", "vtp", "--every", "2"}).status, 0);
  EXPECT_EQ(
      names_in("vtp"),
      (std::set<std::string>{"frame-000001.vtp", "frame-000003.vtp", "frame-000005.vtp", "links-000001.vtp",
                             "links-000003.vtp", "links-000005.vtp", "links.pvd", "motion.pvd"}));
  folder_.write("vtp/notes.txt", "mine");
  const Ran refused = export_shapes(vtp);
  EXPECT_EQ(refused.status, 4);
  EXPECT_NE(refused.err.find("notes.txt"), std::string::npos) << refused.err;
  EXPECT_EQ(names_in("vtp").size(), 9U) << "and nothing was touched";
}

TEST_F(ExportFormatsTest, TheEndingSaysWhichFormat) {
  for (const auto& [file, begin] : {std::pair<std::string, std::string>{"m.npz", "PK"},
                                    {"m.usda", "#usda 1.0"},
                                    {"m.glb", "glTF"},
                                    {"m.csv", "frame,"},
                                    {"m.txt", "frame,"}}) {
    ASSERT_EQ(export_shapes({"-o", file}).status, 0) << file;
    EXPECT_EQ(read_file(folder_ / file).substr(0, begin.size()), begin);
  }
}

TEST_F(ExportFormatsTest, OneFileMayGoToStandardOutput) {
  for (const std::string format : {"csv", "npz", "usda", "glb"}) {
    ASSERT_EQ(export_shapes({"--format", format, "-o", "file"}).status, 0);
    const Ran ran = export_shapes({"--format", format, "-o", "-"});
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(ran.out == read_file(folder_ / "file")) << format;
  }
}

TEST_F(ExportFormatsTest, WhatDoesNotShowIsSaid) {
  const std::string note = "14 links are broken at 0.4 s, and glb shows none of it";
  EXPECT_NE(export_shapes({"-o", "m.glb"}).err.find(note), std::string::npos);
  EXPECT_EQ(export_shapes({"-o", "m.glb", "--quiet"}).err, "");
  EXPECT_EQ(export_shapes({"-o", "m.glb", "--times", "0,0.1"}).err.find("broken"), std::string::npos);
  EXPECT_EQ(export_shapes({"-o", "m.usda"}).err.find("broken"), std::string::npos);
}

TEST_F(ExportFormatsTest, WhatDoesNotGoTogetherIsRefused) {
  fs::create_directory(folder_ / "folder");
  folder_.write("a-file", "mine");
  struct Case {
    Words words;
    std::string reason;
  };
  const std::vector<Case> cases{
      {{"--format", "vtx", "-o", "x"}, "did you mean \"vtp\"?"},
      {{"--format", "vtp", "-o", "x", "--table", "links"}, "--table goes with csv and npz"},
      {{"--table", "link"}, "did you mean \"links\"?"},
      {{"--format", "vtp"}, "vtp is a folder of files: -o FOLDER"},
      {{"--format", "obj", "-o", "-"}, "obj is a folder of files: -o FOLDER"},
      {{"--format", "obj", "-o", "x.obj"}, "-o names the folder, without .obj"},
      {{"--format", "ply", "-o", "a-file"}, "a-file is a file; ply is a folder of files"},
      {{"--format", "npz"}, "npz is no text"},
      {{"-o", "folder"}, "folder is a folder, and csv is one file"},
      {{"--format", "npz", "-o", "x.csv"}, "x.csv has the ending of csv, and --format says npz"},
      {{"--format", "pc2", "-o", "x", "--times", "0,0.1,0.3"},
       "pc2 takes instants that are an equal time apart"},
      {{"--every", "0"}, "--every is a whole number from 1"},
      {{"--every", "1.5"}, "--every is a whole number from 1"},
      {{"--every", "2", "--times", "0.1"}, "--every is of frames, and --times names instants"},
      {{"--motion", "folder"}, "a SCENE and --motion are two things to export"},
      {{"-o", "x.glb", "--set", "world.duration=250"}, "glb keeps every instant as a morph target"}};
  for (const Case& wrong : cases) {
    const Ran ran = export_shapes(wrong.words);
    EXPECT_EQ(ran.status, 2) << wrong.reason << "\n" << ran.err;
    EXPECT_NE(ran.err.find(wrong.reason), std::string::npos) << wrong.reason << "\n" << ran.err;
    EXPECT_EQ(ran.out, "");
  }
  EXPECT_EQ(folder_.entries(), 2U) << "nothing was written";
  EXPECT_EQ(taut({"export"}).status, 2);
  EXPECT_NE(taut({"export", "--motion", folder_ / "folder"}).err.find("holds no motion"), std::string::npos);
  EXPECT_NE(taut({"export", "--motion", folder_ / "folder", "--certify"}).err.find("nothing is simulated"),
            std::string::npos);
}

// Frames that are whole stay, and can be opened by their times.
TEST_F(ExportFormatsTest, AnInterruptedSeriesIsOfUse) {
  const std::string script = fmt::format(
      "'{}' export '{}shapes.toml' --set world.duration=3000 --fps 100 --format vtp -o '{}' & process=$!; "
      "for i in $(seq 500); do [ -e '{}' ] && break; sleep 0.02; done; kill -INT $process; wait $process",
      TAUT_PROGRAM, foreign, folder_ / "vtp", folder_ / "vtp/frame-000003.vtp");
  const Ran ran = run_program("/bin/sh", {"-c", script});
  EXPECT_EQ(ran.status, 130) << ran.err;
  EXPECT_NE(ran.err.find("300000 frames are there"), std::string::npos) << ran.err;
  std::size_t frames = 0;
  const std::string list = read_file(folder_ / "vtp/motion.pvd");
  for (const std::string& name : names_in("vtp")) {
    EXPECT_FALSE(name.starts_with('.')) << name;
    if (!name.starts_with("frame-")) continue;
    ++frames;
    EXPECT_NE(list.find(name), std::string::npos) << name;
  }
  EXPECT_GE(frames, 3U);
}

TEST_F(ExportFormatsTest, AreListed) {
  const Ran ran = taut({"list", "formats", "--json"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const nlohmann::json formats = nlohmann::json::parse(ran.out);
  std::set<std::string> names;
  const std::string help = taut({"export", "--help"}).out;
  for (const nlohmann::json& format : formats) {
    const std::string name = format.at("name");
    names.insert(name);
    EXPECT_EQ(format.at("ending"), "." + name);
    EXPECT_NE(format.at("summary"), "");
    EXPECT_NE(help.find(name), std::string::npos) << name;
  }
  EXPECT_EQ(names, (std::set<std::string>{"csv", "npz", "vtp", "obj", "ply", "pc2", "usda", "glb"}));
  EXPECT_NE(taut({"list", "formats"}).out.find("for ParaView"), std::string::npos);
}

}  // namespace
}  // namespace taut::testing
