#include <algorithm>

#include "model/state.h"
#include "physics/fixtures.h"

namespace taut::test {
namespace {

ChainSpec rope(int links, double length, const Vec3& to) {
  ChainSpec spec;
  spec.name = "rope";
  spec.to = to;
  spec.links = links;
  spec.length = length;
  return spec;
}

Built build_chain(const ChainSpec& spec) {
  Description description;
  description.chains = {spec};
  return build_valid(description);
}

Vec3 chord(const Built& built, std::size_t link) {
  return built.start.position.at(link + 1) - built.start.position.at(link);
}

TEST(Chain, StraightHasEqualLinksNamesAndMasses) {
  ChainSpec spec = rope(4, 0.0, {2.0, 0.0, 0.0});
  spec.mass = 1.0;
  spec.pinned = {"first"};
  const Built built = build_chain(spec);
  ASSERT_EQ(built.model.masses.size(), 5U);
  ASSERT_EQ(built.model.links.size(), 4U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(built.model.masses.name[i], "rope." + std::to_string(i));
    EXPECT_LT((built.start.position.at(i) - Vec3(0.5 * static_cast<double>(i), 0, 0)).norm(), 1e-15);
    EXPECT_DOUBLE_EQ(built.model.masses.mass[i], 0.2);
    EXPECT_DOUBLE_EQ(built.model.masses.inverse_mass[i], i == 0 ? 0.0 : 5.0);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(built.model.links.a[i], i);
    EXPECT_EQ(built.model.links.b[i], i + 1);
    EXPECT_DOUBLE_EQ(built.model.links.length[i], 0.5);
    EXPECT_TRUE(built.model.links.rigid(i));
    EXPECT_EQ(built.model.links.compliance(i), 0.0);
  }
  ASSERT_EQ(built.model.chains.size(), 1U);
  EXPECT_EQ(built.model.chains[0].link_count, 4U);
}

TEST(Chain, LastMassIsExtraAndTheOthersKeepTheirShare) {
  ChainSpec spec = rope(9, 1.0, {1.0, 0.0, 0.0});
  spec.last_mass = 100.0;
  const Built built = build_chain(spec);
  EXPECT_DOUBLE_EQ(built.model.masses.mass[8], 0.1);
  EXPECT_DOUBLE_EQ(built.model.masses.mass[9], 100.0);
}

TEST(Chain, ShorterThanItsDistanceStartsStretched) {
  const Built built = build_chain(rope(4, 1.0, {2.0, 0.0, 0.0}));
  EXPECT_DOUBLE_EQ(built.model.links.length[0], 0.25);
  EXPECT_NEAR(link_distance(built.model, built.start.position, 2), 0.5, 1e-15);
}

class ArcChain : public ::testing::TestWithParam<ChainSpec> {};

// Equal chords that turn by equal angles in one plane lie on a circle.
TEST_P(ArcChain, IsACircularArcWithExactChordsAndEnds) {
  const ChainSpec& spec = GetParam();
  const Built built = build_chain(spec);
  const auto links = static_cast<std::size_t>(spec.links);
  EXPECT_EQ(built.start.position.at(0), spec.from);
  EXPECT_EQ(built.start.position.at(links), spec.to);
  const double length = spec.length / spec.links;
  for (std::size_t i = 0; i < links; ++i)
    EXPECT_NEAR(chord(built, i).norm() / length, 1.0, 1e-12) << "link " << i;
  const Vec3 turn = chord(built, 0).cross(chord(built, 1)) / (length * length);
  for (std::size_t i = 1; i + 1 < links; ++i)
    EXPECT_LT((chord(built, i).cross(chord(built, i + 1)) / (length * length) - turn).norm(), 1e-11)
        << "link " << i;
}

// The arc bends along gravity: its lowest point is below both ends wherever the chord is not vertical.
TEST_P(ArcChain, SagsAlongGravity) {
  const ChainSpec& spec = GetParam();
  const Built built = build_chain(spec);
  const Vec3 span = spec.to - spec.from;
  const Vec3 middle = built.start.position.at(static_cast<std::size_t>(spec.links) / 2);
  const bool vertical = span.cross(Vec3::UnitY()).norm() < 1e-12;
  if (!vertical) {
    EXPECT_LT(middle.y(), spec.from.y() + 0.5 * span.y());
  }
  for (const double value : built.start.position.x) EXPECT_TRUE(std::isfinite(value));
}

INSTANTIATE_TEST_SUITE_P(Shapes, ArcChain,
                         ::testing::Values(rope(20, 2.0, {1.2, 0.0, 0.0}), rope(21, 2.0, {1.2, 0.4, -0.7}),
                                           rope(2, 2.0, {1.0, 0.0, 0.0}), rope(7, 9.0, {0.1, 0.0, 0.0}),
                                           rope(40, 2.0, {1.9999, 0.0, 0.0}),
                                           rope(1000, 3.0, {0.0, 0.0, 1.0}),
                                           rope(12, 2.0, {0.0, -1.0, 0.0})));

TEST(Chain, WithBothEndsAtOnePointIsARing) {
  const Built built = build_chain(rope(6, 1.2, Vec3::Zero()));
  Vec3 centre = Vec3::Zero();
  for (std::size_t i = 0; i < 6; ++i) centre += built.start.position.at(i) / 6.0;
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR((built.start.position.at(i) - centre).norm(), 0.2, 1e-12) << "a hexagon's radius is its side";
}

TEST(Chain, OfOneLinkLongerThanItsDistanceStartsSlack) {
  const Built built = build_chain(rope(1, 2.0, {1.0, 0.0, 0.0}));
  EXPECT_DOUBLE_EQ(built.model.links.length[0], 2.0);
  EXPECT_EQ(built.start.position.at(1), Vec3(1.0, 0.0, 0.0));
}

TEST(Chain, DrivenEndStartsWhereItsMotionBegins) {
  ChainSpec spec = rope(4, 0.0, {2.0, 0.0, 0.0});
  spec.pinned = {"first", "last"};
  spec.first_motion.sinusoid = SinusoidSpec{{0.0, 0.1, 0.0}, 2.0, 0.0};
  spec.last_motion.path = {{0.0, {2.0, 0.5, 0.0}}, {1.0, {2.0, 1.0, 0.0}}};
  const Built built = build_chain(spec);
  ASSERT_EQ(built.model.driven_pins.size(), 2U);
  EXPECT_EQ(built.model.driven_pins[0].mass, 0U);
  EXPECT_EQ(built.model.driven_pins[1].mass, 4U);
  EXPECT_EQ(built.start.position.at(0), Vec3::Zero());
  EXPECT_NEAR(built.start.velocity.y[0], 0.2, 1e-15);
  EXPECT_EQ(built.start.position.at(4), Vec3(2.0, 0.5, 0.0));
}

TEST(Chain, LinkPropertiesReachEveryLink) {
  ChainSpec spec = rope(3, 0.0, {3.0, 0.0, 0.0});
  spec.properties = {2000.0, 1.5, 1.25, 40.0};
  const Built built = build_chain(spec);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(built.model.links.stiffness[i], 2000.0);
    EXPECT_EQ(built.model.links.compliance(i), 1.0 / 2000.0);
    EXPECT_EQ(built.model.links.damping[i], 1.5);
    EXPECT_EQ(built.model.links.break_stretch[i], 1.25);
    EXPECT_EQ(built.model.links.break_tension[i], 40.0);
    EXPECT_EQ(built.model.breakable_links[i], i);
  }
}

}  // namespace
}  // namespace taut::test
