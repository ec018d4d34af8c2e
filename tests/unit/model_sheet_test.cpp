#include <algorithm>
#include <numbers>

#include "model/measures.h"
#include "model/state.h"
#include "physics/fixtures.h"

namespace taut::test {
namespace {

SheetSpec curtain(int hook_every, int pleats, double fullness) {
  SheetSpec spec = cloth(5, pleats * hook_every + 1);
  spec.hooks.every = hook_every;
  spec.fullness = fullness;
  return spec;
}

Built build_sheet(const SheetSpec& spec) {
  Description description;
  description.sheets = {spec};
  return build_valid(description);
}

std::vector<std::string> pinned_names(const Built& built) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < built.model.masses.size(); ++i)
    if (built.model.masses.pinned(i)) names.push_back(built.model.masses.name[i]);
  return names;
}

TEST(Sheet, MassesComeRowAfterRowFromTheTop) {
  const Built built = build_sheet(cloth(3, 4));
  ASSERT_EQ(built.model.masses.size(), 12U);
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column) {
      const std::size_t mass = row * 4 + column;
      EXPECT_EQ(built.model.masses.name[mass], "cloth." + std::to_string(row) + "." + std::to_string(column));
      const Vec3 exact(0.4 * static_cast<double>(column), -0.4 * static_cast<double>(row), 0.0);
      EXPECT_LT((built.start.position.at(mass) - exact).norm(), 1e-15);
      EXPECT_DOUBLE_EQ(built.model.masses.mass[mass], 1.0 / 12.0);
    }
  ASSERT_EQ(built.model.sheets.size(), 1U);
  EXPECT_EQ(built.model.sheets[0].rows, 3U);
  EXPECT_EQ(built.model.sheets[0].columns, 4U);
  EXPECT_EQ(built.model.sheets[0].triangle_count, 12U);
}

TEST(Sheet, LinksAreRowsThenColumns) {
  const Built built = build_sheet(cloth(3, 4));
  const Links& links = built.model.links;
  ASSERT_EQ(links.size(), 3U * 3U + 2U * 4U);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(links.b[i], links.a[i] + 1) << "link " << i;
  for (std::size_t i = 9; i < 17; ++i) EXPECT_EQ(links.b[i], links.a[i] + 4) << "link " << i;
  EXPECT_EQ(links.a[0], 0U);
  EXPECT_EQ(links.a[9], 0U);
}

TEST(Sheet, ExtraLinksHaveTheirOwnLengthsAndProperties) {
  SheetSpec spec = cloth(4, 5);
  spec.properties.break_stretch = 1.5;
  spec.diagonals = LinkProperties{500.0, 0.5, std::nullopt, std::nullopt};
  spec.skip_one = LinkProperties{20.0, 0.0, std::nullopt, std::nullopt};
  const Built built = build_sheet(spec);
  const Links& links = built.model.links;
  const std::size_t structural = 4 * 4 + 5 * 3, diagonal = 2 * 3 * 4, skip = 4 * 3 + 5 * 2;
  ASSERT_EQ(links.size(), structural + diagonal + skip);
  const double across = 1.2 / 4, down = 0.8 / 3;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const double distance = link_distance(built.model, built.start.position, i);
    EXPECT_NEAR(links.length[i], distance, 1e-15) << "link " << i;
    if (i < structural) {
      EXPECT_TRUE(links.rigid(i));
    } else if (i < structural + diagonal) {
      EXPECT_NEAR(links.length[i], std::hypot(across, down), 1e-15);
      EXPECT_EQ(links.stiffness[i], 500.0);
      EXPECT_EQ(links.damping[i], 0.5);
    } else {
      EXPECT_NEAR(links.length[i], i < structural + diagonal + 12 ? 2 * across : 2 * down, 1e-15);
      EXPECT_EQ(links.stiffness[i], 20.0);
    }
  }
  EXPECT_EQ(built.model.breakable_links.size(), structural);
}

TEST(Sheet, PinsEdgesAndCorners) {
  SheetSpec spec = cloth(3, 3);
  spec.pinned = {"top"};
  EXPECT_EQ(pinned_names(build_sheet(spec)),
            (std::vector<std::string>{"cloth.0.0", "cloth.0.1", "cloth.0.2"}));
  spec.pinned = {"bottom-left", "top-right"};
  EXPECT_EQ(pinned_names(build_sheet(spec)), (std::vector<std::string>{"cloth.0.2", "cloth.2.0"}));
  spec.pinned = {"left", "bottom-right", "top-left"};
  EXPECT_EQ(pinned_names(build_sheet(spec)),
            (std::vector<std::string>{"cloth.0.0", "cloth.1.0", "cloth.2.0", "cloth.2.2"}));
  spec.pinned = {"right", "bottom"};
  EXPECT_EQ(pinned_names(build_sheet(spec)).size(), 5U);
}

// Each triangle's edge i goes from mass i to the next, and so does its link; the diagonal of a cell is a link
// only where the sheet has diagonals.
TEST(Sheet, TrianglesKnowTheLinksAlongTheirEdges) {
  for (const bool with_diagonals : {false, true}) {
    SheetSpec spec = cloth(3, 4);
    if (with_diagonals) spec.diagonals = LinkProperties{};
    const Built built = build_sheet(spec);
    ASSERT_EQ(built.model.triangles.size(), 12U);
    std::size_t missing = 0;
    for (const Triangle& triangle : built.model.triangles) {
      for (std::size_t edge = 0; edge < 3; ++edge) {
        const Index from = triangle.masses[edge], to = triangle.masses[(edge + 1) % 3];
        const Index link = triangle.links[edge];
        if (link == no_link) {
          ++missing;
          continue;
        }
        EXPECT_EQ(std::minmax(built.model.links.a[link], built.model.links.b[link]), std::minmax(from, to));
      }
      const auto at = [&](std::size_t i) { return built.start.position.at(triangle.masses[i]); };
      EXPECT_GT((at(1) - at(0)).cross(at(2) - at(0)).z(), 0.0) << "all are wound the same way";
    }
    EXPECT_EQ(missing, with_diagonals ? 0U : 12U);
  }
}

class PleatedSheet : public ::testing::TestWithParam<std::tuple<int, int, double>> {};

TEST_P(PleatedSheet, StartsWithEveryLinkAtItsExactLength) {
  const auto [every, pleats, fullness] = GetParam();
  const Built built = build_sheet(curtain(every, pleats, fullness));
  EXPECT_LT(link_strain(built.model, built.start).largest, 2e-13);
  EXPECT_NEAR(built.model.links.length[0], fullness * 1.2 / (every * pleats), 1e-15);
}

TEST_P(PleatedSheet, HangsFromTheRailAtEveryHook) {
  const auto [every, pleats, fullness] = GetParam();
  const Built built = build_sheet(curtain(every, pleats, fullness));
  EXPECT_EQ(pinned_names(built).size(), static_cast<std::size_t>(pleats) + 1);
  for (int hook = 0; hook <= pleats; ++hook) {
    const auto mass = static_cast<std::size_t>(hook * every);
    EXPECT_TRUE(built.model.masses.pinned(mass));
    EXPECT_LT((built.start.position.at(mass) - Vec3(1.2 * hook / pleats, 0, 0)).norm(), 1e-12);
  }
}

// The surplus lies on both sides of the rail in one smooth wave.
TEST_P(PleatedSheet, IsOneWaveBetweenHooks) {
  const auto [every, pleats, fullness] = GetParam();
  if (fullness == 1.0) return;
  const Built built = build_sheet(curtain(every, pleats, fullness));
  double highest = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(every); ++i) {
    const double z = built.start.position.z[i], next = built.start.position.z[i + 1];
    highest = std::max(highest, std::abs(z));
    const bool outward = i <= static_cast<std::size_t>(every) / 2;
    EXPECT_EQ(std::abs(next) >= std::abs(z) - 1e-12, outward || std::abs(next - z) < 1e-12) << "column " << i;
  }
  EXPECT_GT(highest, 0.05 * 1.2 / pleats);
}

INSTANTIATE_TEST_SUITE_P(Curtains, PleatedSheet,
                         ::testing::Values(std::tuple{9, 7, 1.67}, std::tuple{21, 3, 1.67},
                                           std::tuple{3, 5, 1.2}, std::tuple{5, 3, 4.0},
                                           std::tuple{9, 2, 1.0}));

double largest_kink_degrees(const Built& built, std::size_t columns) {
  double largest = 0.0;
  for (std::size_t i = 0; i + 2 < columns; ++i) {
    const Vec3 a = built.start.position.at(i + 1) - built.start.position.at(i);
    const Vec3 b = built.start.position.at(i + 2) - built.start.position.at(i + 1);
    largest = std::max(largest, std::atan2(a.cross(b).norm(), a.dot(b)));
  }
  return largest * 180.0 / std::numbers::pi;
}

TEST(Pleats, KinkBetweenLinksFallsWithTheirNumber) {
  EXPECT_NEAR(largest_kink_degrees(build_sheet(curtain(9, 7, 1.67)), 64), 52.0, 1.0);
  EXPECT_NEAR(largest_kink_degrees(build_sheet(curtain(21, 3, 1.67)), 64), 23.0, 1.0);
}

TEST(Hooks, DrawMovesThemAlongTheRail) {
  SheetSpec spec = curtain(4, 2, 1.5);
  spec.hooks.draw = {{0.0, 1.0}, {2.0, 0.4}};
  const Built built = build_sheet(spec);
  ASSERT_EQ(built.model.driven_pins.size(), 3U);
  EXPECT_LT(link_strain(built.model, built.start).largest, 2e-13);
  for (std::size_t hook = 0; hook < 3; ++hook) {
    const DrivenPin& pin = built.model.driven_pins[hook];
    EXPECT_EQ(pin.mass, 4 * hook);
    const double place = 0.5 * static_cast<double>(hook);
    EXPECT_LT((position_at(pin.motion, 0.0) - Vec3(1.2 * place, 0, 0)).norm(), 1e-15);
    EXPECT_LT((position_at(pin.motion, 1.0) - Vec3(1.2 * place * 0.7, 0, 0)).norm(), 1e-15);
    EXPECT_LT((position_at(pin.motion, 9.0) - Vec3(1.2 * place * 0.4, 0, 0)).norm(), 1e-15);
  }
}

// A curtain that starts drawn lies in narrower, deeper pleats, with links just as exact.
TEST(Hooks, FirstShareOfTheDrawIsWhereTheClothStarts) {
  SheetSpec spec = curtain(9, 3, 1.67);
  spec.hooks.draw = {{0.0, 0.35}, {2.0, 1.0}};
  const Built built = build_sheet(spec);
  EXPECT_LT(link_strain(built.model, built.start).largest, 2e-13);
  EXPECT_NEAR(built.start.position.x[27], 1.2 * 0.35, 1e-12);
}

}  // namespace
}  // namespace taut::test
