// Columns of stability maps against what theory says of them.

#include <gtest/gtest.h>

#include <cmath>

#include "base/failure.h"
#include "measure/stability_column.h"
#include "physics/fixtures.h"

namespace taut::test {
namespace {

MapColumn column_of(const Description& description, const char* axes, double value, const char* method,
                    std::vector<double> rows) {
  const MapGrid grid{&find_map_axes(axes), {value}, std::move(rows), 0.6};
  const Built variant = map_variant(description, grid.axes->columns, value, *find_method(method));
  const auto column = map_column(grid, value, variant, column_truth(variant, grid.duration), {method, {}});
  EXPECT_TRUE(column.has_value());
  return column.value_or(MapColumn{});
}

Description hanging_chain() {
  Description hanging = level_chain(10, 0.1);
  hanging.chains[0].to = {0.0, -1.0, 0.0};
  return hanging;
}

TEST(MapColumn, OfExplicitSpringsHasItsEdgeWhereTheFrequencySaysSo) {
  const MapColumn column = column_of(hanging_chain(), "step,stiffness", 1e4, "spring-explicit",
                                     spread_values(1e-4, 0.1, 8, false));
  ASSERT_TRUE(column.edge && column.predicted);
  EXPECT_LE(column.edge->fails / column.edge->holds, 1.02);
  EXPECT_NEAR(column.edge->value() / column.predicted->value, 1.0, 0.03);
  EXPECT_EQ(column.cells.front().fate, Fate::held);
  EXPECT_EQ(column.cells.back().fate, Fate::diverged);
  EXPECT_LT(column.cells.front().error, 1e-2);
}

TEST(MapColumn, OfRattleOnStiffSpringsIsRefusedBeyondTheLimit) {
  const MapColumn column = column_of(level_chain(10, 0.1), "step,stiffness", 1e4, "rattle", {1e-3, 0.05});
  EXPECT_EQ(column.cells[0].fate, Fate::held);
  EXPECT_LT(column.cells[0].error, 1e-3);
  EXPECT_EQ(column.cells[1].fate, Fate::refused);
}

TEST(MapColumn, OfAMethodThatCantSaysWhy) {
  const MapColumn column = column_of(level_chain(10, 0.1), "step,stiffness", 1e4, "verlet", {1e-3});
  EXPECT_TRUE(column.cells.empty());
  EXPECT_NE(column.refusal.find("stiffness"), std::string::npos) << column.refusal;
}

// About 2.9 n² passes for equal masses; in coloured order it takes a tenth more.
TEST(MapColumn, PassesFollowTheSquareOfTheLinks) {
  double last = 0.0;
  for (const double links : {10.0, 20.0, 40.0}) {
    const MapColumn column = column_of(level_chain(10, 0.1), "passes,links", links, "xpbd", {1.0, 10.0});
    ASSERT_TRUE(column.edge);
    EXPECT_NEAR(column.edge->value() / (2.9 * links * links), 1.0, 0.15);
    if (last > 0.0) {
      EXPECT_NEAR(column.edge->value() / last, 4.0, 0.25);
    }
    last = column.edge->value();
  }
}

// Masses that hang gain m (g t)²/2, less what they sag by in a step.
TEST(MapColumn, KeptVelocitiesGainEnergyAsTheSquareOfTime) {
  const Built built = build_valid(hanging_chain());
  const double predicted = kept_velocity_gain(built.model, built.start, 1.0);
  for (const double rate : {1000.0, 10000.0}) {
    const RunOutcome outcome =
        run_unguarded(built.model, built.start, settings("euler", rate), std::llround(rate));
    EXPECT_EQ(outcome.fate, Fate::drifted);
    EXPECT_NEAR(outcome.energy_drift / predicted, 1.0, 20.0 / rate);
  }
}

TEST(MapVariant, ChangesWhatTheColumnsStandFor) {
  const Description chain = level_chain(10, 0.1);
  const Method& rigid = *find_method("rattle");
  const Built heavy = map_variant(chain, MapColumns::mass_ratio, 50.0, rigid);
  EXPECT_DOUBLE_EQ(heavy.model.masses.mass.back(), 50.0 * heavy.model.masses.mass[3]);
  EXPECT_DOUBLE_EQ(heavy.model.masses.inverse_mass.back() * heavy.model.masses.mass.back(), 1.0);
  const Built longer = map_variant(chain, MapColumns::links, 30.0, rigid);
  EXPECT_EQ(longer.model.links.size(), 30U);
  EXPECT_NEAR(longer.model.links.length[7], 0.1, 1e-12);
  EXPECT_NEAR(longer.model.masses.mass[7], heavy.model.masses.mass[3], 1e-12);
  EXPECT_DOUBLE_EQ(map_variant(chain, MapColumns::gravity, 2.5, rigid).model.gravity.y(), -2.5);
  EXPECT_DOUBLE_EQ(map_variant(chain, MapColumns::stiffness, 7.0, rigid).model.links.stiffness[4], 7.0);
  // 10 free masses of 1 kg stretch a link of 0.1 m by 1 mm.
  const Built springs = map_variant(chain, MapColumns::gravity, 10.0, *find_method("spring-explicit"));
  EXPECT_NEAR(springs.model.links.stiffness[0], 10.0 * 10.0 / 1e-3, 1e-6);
  EXPECT_THROW(map_variant(pendulum(), MapColumns::links, 3.0, rigid), BadRequest);
  EXPECT_THROW(map_variant(pendulum(), MapColumns::mass_ratio, 3.0, rigid), BadRequest);
}

}  // namespace
}  // namespace taut::test
