// What steps that take a chain block by block are made of.

#include "direct/chain_blocks.h"

#include <limits>
#include <random>

#include "forces/forces.h"
#include "forces/mass_kernels.h"
#include "model/measures.h"
#include "physics/fixtures.h"

namespace taut::test {
namespace {

std::vector<std::pair<std::size_t, std::size_t>> growth(GrowingExtent& extent, Extent larger) {
  std::vector<std::pair<std::size_t, std::size_t>> more;
  extent.grow(larger, [&](Extent some) { more.emplace_back(some.begin, some.end); });
  return more;
}

using Extents = std::vector<std::pair<std::size_t, std::size_t>>;

TEST(GrowingExtents, AreVisitedWhereTheyGrow) {
  GrowingExtent extent;
  EXPECT_TRUE(extent.empty());
  EXPECT_EQ(growth(extent, {5, 5}), Extents{}) << "nothing";
  EXPECT_EQ(growth(extent, {6, 5}), Extents{}) << "less than nothing";
  EXPECT_EQ(growth(extent, {5, 7}), (Extents{{5, 7}}));
  EXPECT_EQ(growth(extent, {5, 7}), Extents{});
  EXPECT_EQ(growth(extent, {3, 10}), (Extents{{3, 5}, {7, 10}}));
  EXPECT_EQ(growth(extent, {0, 10}), (Extents{{0, 3}}));
  EXPECT_EQ(growth(extent, {0, 11}), (Extents{{10, 11}}));
  EXPECT_FALSE(extent.empty());
}

ChainBlocks blocks_of(const Built& built) {
  return {built.model, make_link_system(built.model, whole_rigid_links(built.model, built.start)).links};
}

// Every mass once all its links are there, every link once both its masses are.
TEST(ChainBlocksOf, AChainThatFallsAreSeveral) {
  const ChainBlocks blocks = blocks_of(build_valid(level_chain(600, 0.1)));
  ASSERT_TRUE(blocks.several());
  std::size_t next_link = 0, next_mass = 0;
  blocks.visit([&](Extent links) {
    EXPECT_EQ(links.begin, next_link);
    next_link = links.end;
  });
  blocks.visit_masses([&](Extent masses) {
    EXPECT_EQ(masses.begin, next_mass);
    next_mass = masses.end;
  });
  EXPECT_EQ(next_link, 600U);
  EXPECT_EQ(next_mass, 601U);
  const auto same = [](Extent a, Extent b) { return a.begin == b.begin && a.end == b.end; };
  EXPECT_TRUE(same(blocks.masses_among({0, 9}), {0, 9}));
  EXPECT_TRUE(same(blocks.masses_among({4, 9}), {5, 9}));
  EXPECT_TRUE(same(blocks.masses_among({4, 600}), {5, 601}));
  EXPECT_TRUE(same(blocks.masses_at({4, 9}), {4, 10}));
  EXPECT_TRUE(same(blocks.links_among({0, 9}), {0, 8}));
  EXPECT_TRUE(same(blocks.links_among({5, 601}), {5, 600}));
}

TEST(ChainBlocksOf, AllElseAreOne) {
  const auto expect_one = [](const Built& built, const char* why) {
    const ChainBlocks blocks = blocks_of(built);
    EXPECT_FALSE(blocks.several()) << why;
    int visits = 0;
    blocks.visit([&](Extent) { ++visits; });
    EXPECT_EQ(visits, 1) << why;
  };
  const Description chain = level_chain(600, 0.1);
  Built built = build_valid(chain);
  built.start.broken_at[300] = 0.0;
  expect_one(built, "a broken link");
  built = build_valid(chain);
  built.model.loads.push_back({{3}, Vec3::Zero(), 0.0, 0.0});
  expect_one(built, "a load");
  built = build_valid(chain);
  built.model.wind = Wind{};
  expect_one(built, "wind");
  Description changed = chain;
  changed.chains[0].first_motion.sinusoid = SinusoidSpec{{0.0, 0.1, 0.0}, 1.0, 0.0};
  expect_one(build_valid(changed), "a driven pin");
  changed = chain;
  changed.masses.push_back(MassSpec{});
  changed.masses.back().name = "loose";
  expect_one(build_valid(changed), "another mass");
  changed = chain;
  changed.chains.push_back(changed.chains[0]);
  changed.chains[1].name = "other";
  changed.chains[1].from.z() = changed.chains[1].to.z() = 1.0;
  expect_one(build_valid(changed), "another chain");
  expect_one(build_valid(mixed_chain()), "a spring");
  expect_one(build_valid(spinning_dumbbell()), "few links");
}

// Positions and velocities at random, the second mass a pin.
struct RandomMasses {
  Built built;
  Vectors position, velocity;

  explicit RandomMasses(int links) : built(build_valid(level_chain(links, 0.1))) {
    built.model.masses.inverse_mass[1] = 0.0;
    std::mt19937 random(4);
    std::uniform_real_distribution<double> number(-2.0, 2.0);
    for (int i = 0; i <= links; ++i) {
      position.push_back({number(random), number(random), number(random)});
      velocity.push_back({number(random), number(random), number(random)});
    }
  }
  double energy(Extent masses) const { return energy_of_some(built.model, position, velocity, masses); }
};

TEST(MassesOfAChain, HaveTheEnergyOfTheState) {
  for (int links = 1; links < 40; ++links) {
    const RandomMasses masses(links);
    State state = masses.built.start;
    state.position = masses.position;
    state.velocity = masses.velocity;
    const Extent all{0, masses.position.size()};
    EXPECT_NEAR(masses.energy(all), energy_of_masses(masses.built.model, state).total(), 1e-12 * links);
    EXPECT_NEAR(masses.energy({0, 1}) + masses.energy({1, all.end}), masses.energy(all), 1e-12 * links);
  }
}

TEST(MassesOfAChain, HaveAFiniteEnergyOnlyWhereAllIsFinite) {
  RandomMasses masses(20);
  const Extent all{0, masses.position.size()};
  for (const double bad : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()})
    for (std::size_t i = 0; i < all.end; ++i)
      for (Vectors* vectors : {&masses.position, &masses.velocity})
        for (std::vector<double>* axis : {&vectors->x, &vectors->y, &vectors->z}) {
          const double good = std::exchange((*axis)[i], bad);
          EXPECT_FALSE(std::isfinite(masses.energy(all))) << "mass " << i << " = " << bad;
          (*axis)[i] = good;
        }
  EXPECT_TRUE(std::isfinite(masses.energy(all)));
}

TEST(MassesOfAChain, KnowTheirLargestCoordinate) {
  for (std::size_t count = 1; count < 20; ++count)
    for (std::size_t i = 0; i < count; ++i) {
      Vectors vectors;
      vectors.resize(count);
      vectors.set(i, {0.5, -3.0, 2.0});
      EXPECT_EQ(largest_of(count, to_read(vectors)), 3.0) << i << " of " << count;
    }
}

}  // namespace
}  // namespace taut::test
