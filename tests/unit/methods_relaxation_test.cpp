// A pass over a large sheet, whose masses and links lie in any order, against the same links visited one by
// one, colour by colour.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "relax/relaxation.h"

namespace taut {
namespace {

constexpr Index side = 40;

// A sheet with diagonals whose masses are numbered and whose links are listed at random.
Model shuffled_sheet(std::mt19937& random) {
  std::vector<Index> number(side * side);
  for (Index i = 0; i < number.size(); ++i) number[i] = i;
  for (std::size_t i = number.size(); i > 1; --i) std::swap(number[i - 1], number[random() % i]);
  std::vector<std::pair<Index, Index>> ends;
  for (Index row = 0; row < side; ++row)
    for (Index column = 0; column < side; ++column) {
      const auto add = [&](Index other_row, Index other_column) {
        if (other_row < side && other_column < side)
          ends.emplace_back(number[row * side + column], number[other_row * side + other_column]);
      };
      add(row, column + 1);
      add(row + 1, column);
      add(row + 1, column + 1);
      if (column > 0) add(row + 1, column - 1);
    }
  for (std::size_t i = ends.size(); i > 1; --i) std::swap(ends[i - 1], ends[random() % i]);
  Model model;
  for (Index i = 0; i < side * side; ++i) {
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

// Greedy colours in the order of the links, and a pass colour by colour.
void plain_pass(const Model& model, Vectors& position) {
  std::vector<std::set<int>> used(model.masses.size());
  std::vector<int> colour;
  int colours = 0;
  for (std::size_t link = 0; link < model.links.size(); ++link) {
    const Index a = model.links.a[link], b = model.links.b[link];
    int free = 0;
    while (used[a].contains(free) || used[b].contains(free)) ++free;
    for (const Index mass : {a, b})
      if (!model.masses.pinned(mass)) used[mass].insert(free);
    colour.push_back(free);
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

class AnyOrder : public ::testing::TestWithParam<int> {};

TEST_P(AnyOrder, GivesTheBitsOfColourByColour) {
  std::mt19937 random(3);
  const Model model = shuffled_sheet(random);
  State state;
  state.broken_at.assign(model.links.size(), infinity);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (Index i = 0; i < side * side; ++i) state.position.push_back({number(), number(), number()});
  Relaxation<double> relaxation(model, {std::make_shared<Workers>(GetParam())});
  relaxation.links_changed(state);
  EXPECT_EQ(relaxation.size(), static_cast<std::int64_t>(solvable_links(model).size()));
  auto packed = relaxation.room(), start = packed;
  Vectors relaxed = state.position, expected = state.position;
  relaxation.load(relaxed, packed);
  relaxation.begin_step(1.0, 1.0);
  for (int pass = 0; pass < 2; ++pass) {
    EXPECT_TRUE(relaxation.pass(start, packed, {pass == 0, pass == 1}));
    plain_pass(model, expected);
  }
  relaxation.give(packed, relaxed);
  EXPECT_EQ(relaxed, expected);
  // Wherever a mass is that is no longer a number, it is found.
  for (Index mass = 0; mass < side * side; mass += 7) {
    if (model.masses.pinned(mass)) continue;
    Vectors lost = state.position;
    lost.y[mass] = infinity;
    relaxation.load(lost, packed);
    EXPECT_FALSE(relaxation.pass(start, packed, {true, true})) << mass;
  }
}

INSTANTIATE_TEST_SUITE_P(Threads, AnyOrder, ::testing::Values(1, 2, 3, 8));

}  // namespace
}  // namespace taut
