#include "contact/collider_tree.h"

#include <gtest/gtest.h>

#include <random>

namespace taut {
namespace {

// Solids of every shape, strewn about.
std::vector<Shape> strewn(int count) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-3.0, 3.0), size(0.05, 0.8), angle(0.0, 6.0);
  const auto anywhere = [&] { return Vec3(place(random), place(random), place(random)); };
  std::vector<Shape> solids;
  for (int i = 0; i < count; ++i) {
    Shape shape = Sphere{anywhere(), size(random)};
    if (i % 4 == 1) shape = Capsule{anywhere(), anywhere(), size(random)};
    if (i % 4 == 2)
      shape = Box{anywhere(),
                  {size(random), size(random), size(random)},
                  Eigen::AngleAxisd(angle(random), anywhere().normalized()).toRotationMatrix()};
    if (i % 40 == 3) shape = HalfSpace{anywhere(), anywhere().normalized()};
    solids.push_back(shape);
  }
  return solids;
}

TEST(ColliderTree, FindsEverySolidThatIsNear) {
  const std::vector<Shape> solids = strewn(200);
  const ColliderTree tree(solids);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-4.0, 4.0);
  std::vector<std::uint32_t> found;
  std::size_t looked_at = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec3 at(place(random), place(random), place(random));
    found.clear();
    tree.find(at, 0.1, found);
    looked_at += found.size();
    std::ranges::sort(found);
    for (std::uint32_t solid = 0; solid < solids.size(); ++solid)
      if (nearest_surface(solids[solid], at).distance < 0.1) {
        EXPECT_TRUE(std::ranges::binary_search(found, solid))
            << "solid " << solid << " at " << at.transpose();
      }
  }
  EXPECT_LT(looked_at, 300U * 60U) << "of 200 each time";
}

TEST(ColliderTree, OfNoSolidsFindsNone) {
  std::vector<std::uint32_t> found;
  ColliderTree(std::vector<Shape>{}).find(Vec3::Zero(), 1.0, found);
  EXPECT_TRUE(found.empty());
}

TEST(ColliderTree, OfSomeSolidsFindsThoseAlone) {
  const std::vector<Shape> solids(50, Sphere{Vec3::UnitX(), 0.5});
  std::vector<std::uint32_t> found{7};
  ColliderTree(solids, {3, 30}).find(Vec3::Zero(), 0.6, found);
  std::ranges::sort(found);
  EXPECT_EQ(found, (std::vector<std::uint32_t>{3, 7, 30}));
}

TEST(ColliderTree, SolidsInOnePlaceAreAllFound) {
  const std::vector<Shape> solids(50, Sphere{Vec3::UnitX(), 0.5});
  std::vector<std::uint32_t> found;
  ColliderTree(solids).find(Vec3::Zero(), 0.6, found);
  EXPECT_EQ(found.size(), 50U);
}

}  // namespace
}  // namespace taut
