#include <gtest/gtest.h>

#include "base/vector_operations.h"

namespace taut {
namespace {

Vectors two(const Vec3& first, const Vec3& second) {
  Vectors vectors;
  vectors.push_back(first);
  vectors.push_back(second);
  return vectors;
}

TEST(VectorOperations, AddSubtractAndSquare) {
  const Vectors a = two({1.0, 2.0, 3.0}, {-1.0, 0.5, 4.0}), b = two({0.5, -1.0, 2.0}, {3.0, 0.0, -2.0});
  Vectors result = a;
  add_scaled(a, 2.0, b, result);
  EXPECT_EQ(result, two({2.0, 0.0, 7.0}, {5.0, 0.5, 0.0}));
  add_scaled(result, -2.0, b, result);
  EXPECT_EQ(result, a) << "in place";
  scaled_difference(2.0, a, b, result);
  EXPECT_EQ(result, two({1.0, 6.0, 2.0}, {-8.0, 1.0, 12.0}));
  EXPECT_EQ(squared_norm(a), 1.0 + 4.0 + 9.0 + 1.0 + 0.25 + 16.0);
}

}  // namespace
}  // namespace taut
