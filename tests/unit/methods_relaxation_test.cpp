// A pass over a large sheet, whose masses and links lie in any order, against the same links visited one by
// one, colour by colour.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <set>
#include <tuple>

#include "model/parts.h"
#include "relax/link_layout.h"
#include "relax/relaxation.h"

namespace taut {
namespace {

enum class Listed { in_rows, links_at_random, all_at_random };

struct SheetKind {
  Listed listed = Listed::in_rows;
  Index rows = 40, columns = 45;
  bool upwards = false;  // links from the later mass to the earlier one
};

template <class T>
void shuffle(std::vector<T>& values, std::mt19937& random) {
  for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[random() % i]);
}

// A sheet with diagonals and with links over one mass, some of whose masses are pinned. Links are
// listed, or masses numbered, too, as sheets have them or at random.
Model sheet(const SheetKind& kind, std::mt19937& random) {
  const auto [listed, rows, columns, upwards] = kind;
  std::vector<Index> number(rows * columns);
  for (Index i = 0; i < number.size(); ++i) number[i] = i;
  if (listed == Listed::all_at_random) shuffle(number, random);
  std::vector<std::pair<Index, Index>> ends;
  for (const std::pair<int, int>& step : {std::pair(0, 1), {1, 0}, {1, 1}, {1, -1}, {0, 2}, {2, 0}})
    for (int row = 0, down = step.first, right = step.second; row + down < static_cast<int>(rows); ++row)
      for (int column = std::max(0, -right); column + std::max(0, right) < static_cast<int>(columns);
           ++column) {
        const auto place = [&](int of_row, int of_column) {
          return number[static_cast<Index>(of_row) * kind.columns + static_cast<Index>(of_column)];
        };
        const Index one = place(row, column), other = place(row + down, column + right);
        ends.emplace_back(upwards ? other : one, upwards ? one : other);
      }
  if (listed != Listed::in_rows) shuffle(ends, random);
  Model model;
  for (Index i = 0; i < rows * columns; ++i) {
    const bool pinned = i % 97 == 0;
    model.masses.name.push_back("m");
    model.masses.mass.push_back(1.0);
    model.masses.inverse_mass.push_back(pinned ? 0.0 : 1.0);
    model.masses.radius.push_back(0.0);
  }
  for (const auto& [a, b] : ends) {
    model.links.a.push_back(a);
    model.links.b.push_back(b);
    model.links.length.push_back(0.5);
    model.links.stiffness.push_back(infinity);
    model.links.damping.push_back(0.0);
    model.links.break_stretch.push_back(infinity);
    model.links.break_tension.push_back(infinity);
  }
  return model;
}

// Greedy colours in this order of the links, and a pass colour by colour.
void plain_pass(const Model& model, const State& state, const std::vector<Index>& order, Vectors& position) {
  std::vector<std::set<int>> used(model.masses.size());
  std::vector<int> colour(model.links.size(), -1);
  int colours = 0;
  for (const Index link : order) {
    if (state.broken(link)) continue;
    const Index a = model.links.a[link], b = model.links.b[link];
    int free = 0;
    while (used[a].contains(free) || used[b].contains(free)) ++free;
    for (const Index mass : {a, b})
      if (!model.masses.pinned(mass)) used[mass].insert(free);
    colour[link] = free;
    colours = std::max(colours, free + 1);
  }
  for (int now = 0; now < colours; ++now)
    for (std::size_t link = 0; link < model.links.size(); ++link) {
      const Index a = model.links.a[link], b = model.links.b[link];
      const double weight_a = model.masses.inverse_mass[a], weight_b = model.masses.inverse_mass[b];
      if (colour[link] != now || weight_a + weight_b == 0.0) continue;
      const Vec3 d = position.at(a) - position.at(b);
      const double distance = std::sqrt(d.x() * d.x() + d.y() * d.y() + d.z() * d.z());
      const double shift = (model.links.length[link] - distance) * (1.0 / distance);
      const double factor = 1.0 / (weight_a + weight_b);
      position.add(a, (weight_a * factor * shift) * d);
      position.add(b, -((weight_b * factor * shift) * d));
    }
}

class AnyOrder : public ::testing::TestWithParam<std::tuple<SheetKind, int>> {};

TEST_P(AnyOrder, GivesTheBitsOfColourByColour) {
  const auto& [kind, threads] = GetParam();
  const Listed listed = kind.listed;
  const Index masses = kind.rows * kind.columns;
  std::mt19937 random(3);
  const Model model = sheet(kind, random);
  State state;
  state.broken_at.assign(model.links.size(), infinity);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (Index i = 0; i < masses; ++i) state.position.push_back({number(), number(), number()});
  for (Index i = 0; i < masses; i += 11) state.position.z[i] = -0.0;
  Relaxation<double> relaxation(model, {std::make_shared<Workers>(threads)});
  relaxation.links_changed(state);
  EXPECT_EQ(relaxation.places().layout, listed == Listed::all_at_random ? Layout::packed : Layout::split);
  EXPECT_EQ(relaxation.size(), static_cast<std::int64_t>(solvable_links(model).size()));
  for (Index link = 0; link < model.links.size(); link += 53) state.broken_at[link] = 0.0;
  relaxation.links_changed(state);
  auto packed = relaxation.places().room(), start = packed;
  Vectors relaxed = state.position, expected = state.position;
  relaxation.places().load(relaxed, packed);
  relaxation.begin_step(1.0, 1.0);
  std::vector<Index> order(model.links.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto place_in_sheets = [&](Index link) {
    const std::int64_t a = model.links.a[link], b = model.links.b[link];
    return std::pair(b - a, a);
  };
  if (listed == Listed::links_at_random) std::ranges::stable_sort(order, {}, place_in_sheets);
  for (int pass = 0; pass < 2; ++pass) {
    EXPECT_TRUE(relaxation.pass(start, packed, {pass == 0, pass == 1}));
    plain_pass(model, state, order, expected);
  }
  relaxation.places().give(packed, relaxed);
  EXPECT_EQ(relaxed, expected);
  // No −0 is left, to which it would matter that nothing is added.
  relaxation.places().load(state.position, packed);
  relaxation.places().give(packed, relaxed);
  for (Index mass = 0; mass < masses; ++mass)
    EXPECT_TRUE(model.masses.pinned(mass) || !std::signbit(relaxed.z[mass])) << mass;
  // Wherever a mass is that is no longer a number, it is found.
  for (Index mass = 0; mass < masses; mass += 7) {
    if (model.masses.pinned(mass)) continue;
    Vectors lost = state.position;
    lost.y[mass] = infinity;
    relaxation.places().load(lost, packed);
    EXPECT_FALSE(relaxation.pass(start, packed, {true, true})) << mass;
  }
}

INSTANTIATE_TEST_SUITE_P(Threads, AnyOrder,
                         ::testing::Combine(::testing::Values(SheetKind{}, SheetKind{Listed::links_at_random},
                                                              SheetKind{Listed::all_at_random},
                                                              SheetKind{Listed::in_rows, 45, 40, true}),
                                            ::testing::Values(1, 2, 3, 8)));

// Slots without a link write back what lies at their ends.
TEST(LinkLayout, GapsLieApartAndOverMassesOfTheirThread) {
  constexpr std::size_t lanes = links_at_once<double>;
  int gaps = 0;
  for (const Index columns : {2U, 3U, 4U, 5U, 7U, 9U, 45U})
    for (const bool upwards : {false, true})
      for (const std::size_t threads : {std::size_t{1}, std::size_t{3}}) {
        std::mt19937 random(3);
        const Model model = sheet({Listed::in_rows, 400 / columns, columns, upwards}, random);
        const std::vector<Index> links = solvable_links(model);
        const LinkLayout<double> layout = lay_out_links<double>(
            model, visit_order(model, links, row_order(model, links, lanes)), Layout::split, 1.0, threads);
        for (const LinkSection& section : layout.sections)
          for (std::size_t i = section.begin; i < section.end; ++i) {
            const LinkStretch& stretch = layout.stretches[i];
            if (stretch.stride == 0) continue;
            for (std::size_t slot = stretch.begin; slot < stretch.end; ++slot) {
              if (layout.visited[slot] != no_link) continue;
              ++gaps;
              const std::size_t vector = stretch.ends + (slot - stretch.begin) / lanes,
                                a = layout.a[vector] / sizeof(double), b = layout.b[vector] / sizeof(double);
              const auto [low, high] = std::minmax(a, b);
              EXPECT_GE(high - low, lanes) << columns << ' ' << upwards;
              EXPECT_GE(low, section.masses.begin);
              EXPECT_LE(high + lanes, section.masses.end == 0 ? layout.masses.size() : section.masses.end);
            }
          }
      }
  EXPECT_GT(gaps, 1000);
}

}  // namespace
}  // namespace taut
