#include "model/measures.h"
#include "model/state.h"
#include "physics/fixtures.h"

namespace taut::test {
namespace {

// Masses come in the order chains, sheets, masses; links in the order chains, sheets, links.
TEST(Build, OrderIsChainsThenSheetsThenMasses) {
  Description description;
  MassSpec single;
  single.name = "ball";
  single.position = {0.0, 5.0, 0.0};
  description.masses = {single};
  description.links = {LinkSpec{"ball", "cloth.0.0", 2.0, {}}};
  description.sheets = {cloth(2, 2)};
  ChainSpec chain;
  chain.name = "rope";
  chain.to = {0.0, 0.0, 3.0};
  chain.links = 2;
  description.chains = {chain};
  const Built built = build_valid(description);
  EXPECT_EQ(built.model.masses.name,
            (std::vector<std::string>{"rope.0", "rope.1", "rope.2", "cloth.0.0", "cloth.0.1", "cloth.1.0",
                                      "cloth.1.1", "ball"}));
  ASSERT_EQ(built.model.links.size(), 7U);
  EXPECT_EQ(built.model.links.a[6], 7U);
  EXPECT_EQ(built.model.links.b[6], 3U);
  EXPECT_EQ(built.model.links.length[6], 2.0);
  EXPECT_EQ(built.model.sheets[0].first_mass, 3U);
  EXPECT_NEAR(total_link_length(built.model), 3.0 + 2 * 1.2 + 2 * 0.8 + 2.0, 1e-14);
}

TEST(Build, LinkWithoutLengthHasTheDistanceAtTheStart) {
  Description description = pendulum();
  description.masses[1].position = {0.3, -0.4, 1.2};
  description.links[0].length.reset();
  EXPECT_NEAR(build_valid(description).model.links.length[0], 1.3, 1e-15);
}

TEST(Build, PinnedMassesHaveNoVelocityAndNoInverseMass) {
  Description description = pendulum();
  description.masses[0].velocity = {1.0, 2.0, 3.0};
  description.masses[1].velocity = {0.0, -1.0, 0.0};
  const Built built = build_valid(description);
  EXPECT_EQ(built.start.velocity.at(0), Vec3::Zero());
  EXPECT_EQ(built.start.velocity.at(1), Vec3(0.0, -1.0, 0.0));
  EXPECT_TRUE(built.model.masses.pinned(0));
  EXPECT_FALSE(built.model.masses.pinned(1));
}

TEST(SolvableLinks, LeaveOutThoseBetweenTwoPins) {
  SheetSpec spec = cloth(2, 3);
  spec.pinned = {"top"};
  Description description;
  description.sheets = {spec};
  const Built built = build_valid(description);
  const std::vector<Index> solvable = solvable_links(built.model);
  EXPECT_EQ(solvable, (std::vector<Index>{2, 3, 4, 5, 6})) << "links 0 and 1 lie along the top";
}

TEST(Load, RampsUpLinearlyAndStays) {
  const Load load{{}, {0.0, -2.0, 0.0}, 1.0, 3.0};
  EXPECT_EQ(load.share(0.0), 0.0);
  EXPECT_EQ(load.share(1.0), 0.0);
  EXPECT_DOUBLE_EQ(load.share(1.5), 0.25);
  EXPECT_EQ(load.share(3.0), 1.0);
  EXPECT_EQ(load.share(9.0), 1.0);
  const Load sudden{{}, {0.0, -2.0, 0.0}, 1.0, 1.0};
  EXPECT_EQ(sudden.share(0.999), 0.0);
  EXPECT_EQ(sudden.share(1.0), 1.0);
}

TEST(Load, StarStandsForOnePartOfAName) {
  Description description;
  description.sheets = {cloth(3, 3)};
  description.loads = {LoadSpec{{"cloth.2.*"}, {0, -1, 0}, 0.0, 1.0},
                       LoadSpec{{"cloth.*.0", "cloth.1.2"}, {0, -1, 0}, 0.0, 1.0}};
  const Built built = build_valid(description);
  EXPECT_EQ(built.model.loads[0].masses, (std::vector<Index>{6, 7, 8}));
  EXPECT_EQ(built.model.loads[1].masses, (std::vector<Index>{0, 3, 5, 6}));
}

}  // namespace
}  // namespace taut::test
