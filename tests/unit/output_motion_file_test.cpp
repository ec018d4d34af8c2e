#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "base/failure.h"
#include "output/checkpoint.h"
#include "output/folder_lock.h"
#include "output/motion_file.h"
#include "output/packed.h"
#include "scene/scene.h"
#include "temporary_folder.h"

namespace taut {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view inputs = "0123456789abcdef";

TEST(Packed, ComesBackBitForBit) {
  std::mt19937 random(7);
  for (const std::size_t size : {0U, 1U, 7U, 8U, 9U, 1000U, 100'003U}) {
    std::string bytes(size, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random() % 7);
    const std::string small = packed(bytes);
    EXPECT_EQ(unpacked(small, size), bytes) << size;
    EXPECT_THROW(unpacked(small, size + 1), BadRequest) << size;
    EXPECT_THROW(unpacked(small.substr(0, small.size() - 1), size), BadRequest) << size;
  }
}

TEST(Packed, MakesNumbersThatAreAlikeSmaller) {
  std::string bytes;
  for (int i = 0; i < 4000; ++i) {
    const double number = 1.0 + 1e-4 * i;
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
  EXPECT_LT(packed(bytes).size(), bytes.size() * 8 / 10);
}

class MotionFileTest : public ::testing::Test {
 protected:
  RunState moment(double time) const {
    RunState moment{scene_.start, {}, {}};
    moment.state.time = time;
    moment.state.position.x[1] += time;
    return moment;
  }
  void write(int first, int last) const {
    MotionWriter writer(file_, inputs, false);
    for (int frame = first; frame <= last; ++frame) writer.add(frame, moment(0.1 * (frame - 1)));
  }

  testing::TemporaryFolder folder_;
  std::string file_ = folder_ / "motion.bin";
  Scene scene_ = parse_scene(R"([[chain]]
name = "rope"
from = [0, 2, 0]
to = [2, 2, 0]
links = 10
pinned = ["first"]
)",
                             "test.toml");
};

TEST_F(MotionFileTest, GivesAnyMomentBack) {
  write(1, 5);
  const MotionReader reader(file_);
  EXPECT_EQ(reader.inputs(), inputs);
  EXPECT_EQ(reader.records().size(), 5U);
  for (const int frame : {4, 1, 5}) {
    const RunState read = reader.read(reader.records().at(frame), scene_.model);
    EXPECT_EQ(state_hash(read.state), state_hash(moment(0.1 * (frame - 1)).state));
  }
  EXPECT_EQ(reader.find(0.123), nullptr);
  ASSERT_NE(reader.find(0.1 * 2), nullptr);
  EXPECT_NEAR(reader.between(0.25, scene_.model).position.x[1], scene_.start.position.x[1] + 0.25, 0.02);
}

// Whatever byte the writing ends at, what was whole before is there, and the rest is written again.
TEST_F(MotionFileTest, GoesOnFromEveryCut) {
  write(1, 3);
  const std::string whole = testing::read_file(file_);
  for (std::size_t kept = 0; kept < whole.size(); kept += 37) {
    folder_.write("motion.bin", whole.substr(0, kept));
    MotionWriter writer(file_, inputs, false);
    for (int frame = 1; frame <= 3; ++frame)
      if (!writer.records().contains(frame)) writer.add(frame, moment(0.1 * (frame - 1)));
    ASSERT_EQ(testing::read_file(file_), whole) << kept;
  }
}

TEST_F(MotionFileTest, FindsAFlippedByte) {
  write(1, 3);
  std::string bytes = testing::read_file(file_);
  bytes[bytes.size() - 10] ^= 1;
  folder_.write("motion.bin", bytes);
  const MotionReader reader(file_);
  EXPECT_THROW(reader.read(reader.records().at(3), scene_.model), RunFailure);
  EXPECT_NO_THROW(reader.read(reader.records().at(2), scene_.model));
  EXPECT_EQ(MotionWriter(file_, inputs, false).records().size(), 2U) << "what is damaged is made again";
}

TEST_F(MotionFileTest, OfOtherInputsIsAConflict) {
  write(1, 1);
  EXPECT_THROW(MotionWriter(file_, "fedcba9876543210", false), OutputConflict);
  folder_.write("other.bin", "anything else, and longer than the first line of a file of motion");
  EXPECT_THROW(MotionWriter(folder_ / "other.bin", inputs, false), OutputConflict);
  EXPECT_THROW(MotionReader(folder_ / "other.bin"), BadRequest);
}

TEST(CheckpointFile, ComesBackOrIsNotThere) {
  const testing::TemporaryFolder folder;
  const std::string file = folder / "checkpoint.bin";
  EXPECT_FALSE(read_checkpoint(file, inputs));
  write_checkpoint(file, inputs, {12, "all that it takes"});
  const auto there = read_checkpoint(file, inputs);
  ASSERT_TRUE(there);
  EXPECT_EQ(there->frame, 12);
  EXPECT_EQ(there->state, "all that it takes");
  EXPECT_THROW(read_checkpoint(file, "fedcba9876543210"), OutputConflict);

  const std::string whole = testing::read_file(file);
  for (std::size_t place = 0; place < whole.size(); ++place) {
    std::string flipped = whole;
    flipped[place] ^= 4;
    folder.write("checkpoint.bin", flipped);
    EXPECT_FALSE(read_checkpoint(file, inputs)) << place;
    folder.write("checkpoint.bin", whole.substr(0, place));
    EXPECT_FALSE(read_checkpoint(file, inputs)) << place;
  }
}

TEST(FolderLock, IsHeldOnceAndGoesAway) {
  const testing::TemporaryFolder folder;
  {
    const FolderLock lock(folder.path(), ".lock");
    EXPECT_THROW(FolderLock(folder.path(), ".lock"), RunFailure);
    EXPECT_NO_THROW(FolderLock(folder.path(), ".other"));
  }
  EXPECT_EQ(folder.entries(), 0U);
  EXPECT_NO_THROW(FolderLock(folder.path(), ".lock"));
}

}  // namespace
}  // namespace taut
