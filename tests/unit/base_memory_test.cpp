#include <gtest/gtest.h>

#include <vector>

#include "base/memory.h"

namespace taut {
namespace {

TEST(FormatBytes, UsesTheUnitThatLeavesLessThanAThousand) {
  EXPECT_EQ(format_bytes(0.0), "0 B");
  EXPECT_EQ(format_bytes(999.0), "999 B");
  EXPECT_EQ(format_bytes(1000.0), "1 kB");
  EXPECT_EQ(format_bytes(3.2e9), "3.2 GB");
  EXPECT_EQ(format_bytes(123456.0), "123 kB");
}

TEST(FormatBytes, LargestUnitTakesTheRest) {
  EXPECT_EQ(format_bytes(5e20), "500 EB");
  EXPECT_EQ(format_bytes(5e21), "5e+03 EB");
}

TEST(PhysicalMemory, IsThatOfARealMachine) {
  EXPECT_GT(physical_memory(), 64e6);
  EXPECT_LT(physical_memory(), 1e15);
}

TEST(UsableMemory, IsNoMoreThanThereIs) {
  EXPECT_GT(usable_memory(), 0.0);
  EXPECT_LE(usable_memory(), physical_memory());
}

TEST(MemoryLeft, IsLessByWhatIsTaken) {
  const double before = memory_left();
  EXPECT_LT(before, usable_memory());
  const std::vector<char> block(64'000'000, 'x');
  EXPECT_LT(memory_left(), before - 50e6);
  EXPECT_EQ(block.back(), 'x');
}

}  // namespace
}  // namespace taut
