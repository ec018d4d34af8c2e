// Which links of a model make lines.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <string>

#include "model/description.h"
#include "relax/lines.h"

namespace taut {
namespace {

// Free masses but for some pins, and links between them by their numbers.
Model model_of(Index masses, const std::vector<std::pair<Index, Index>>& ends,
               const std::set<Index>& pins = {}) {
  Model model;
  for (Index i = 0; i < masses; ++i) {
    model.masses.name.push_back("m");
    model.masses.mass.push_back(1.0);
    model.masses.inverse_mass.push_back(pins.contains(i) ? 0.0 : 1.0);
    model.masses.radius.push_back(0.0);
  }
  for (const auto& [a, b] : ends) {
    model.links.a.push_back(a);
    model.links.b.push_back(b);
    model.links.length.push_back(1.0);
    model.links.stiffness.push_back(infinity);
    model.links.damping.push_back(0.0);
    model.links.break_stretch.push_back(infinity);
    model.links.break_tension.push_back(infinity);
  }
  return model;
}

std::vector<Index> all_links(const Model& model) {
  return solvable_links(model);
}

// The masses of each line, from the lower end to the higher one, sorted.
std::vector<std::vector<Index>> ways(const LinkLines& lines) {
  std::vector<std::vector<Index>> all;
  for (const LinkLine& line : lines.lines) {
    const auto masses = lines.masses_of(line);
    all.emplace_back(masses.begin(), masses.end());
    if (all.back().front() > all.back().back()) std::ranges::reverse(all.back());
  }
  std::ranges::sort(all);
  return all;
}

// What holds of the lines of any model.
void expect_sound(const Model& model, const std::vector<Index>& links, const LinkLines& lines) {
  std::multiset<Index> found;
  Index before = 0;
  std::map<std::size_t, std::set<Index>> of_colour;
  for (const LinkLine& line : lines.lines) {
    const auto of_line = lines.links_of(line), masses = lines.masses_of(line);
    ASSERT_GE(line.count, 1U);
    found.insert(of_line.begin(), of_line.end());
    EXPECT_EQ(line.lowest, std::ranges::min(of_line));
    EXPECT_GE(line.lowest, before) << "lines are in the order of their lowest links";
    before = line.lowest;
    EXPECT_LT(line.colour, lines.colours);
    for (std::size_t i = 0; i < of_line.size(); ++i) {
      const Index a = model.links.a[of_line[i]], b = model.links.b[of_line[i]];
      EXPECT_EQ(std::minmax(a, b), std::minmax(masses[i], masses[i + 1])) << "link " << of_line[i];
    }
    for (std::size_t i = 0; i < masses.size(); ++i) {
      if (model.masses.pinned(masses[i])) {
        EXPECT_TRUE(i == 0 || i + 1 == masses.size()) << "a pin within a line";
        continue;
      }
      EXPECT_TRUE(of_colour[line.colour].insert(masses[i]).second)
          << "mass " << masses[i] << " twice in colour " << line.colour;
    }
  }
  EXPECT_EQ(std::vector<Index>(found.begin(), found.end()), links);
}

LinkLines sound_lines(const Model& model, const std::vector<Index>& links) {
  LinkLines lines = lines_of(model, links);
  expect_sound(model, links, lines);
  return lines;
}

TEST(Lines, OfASheetAreItsRowsColumnsAndDiagonals) {
  const int rows = 7, columns = 9;
  Description description;
  SheetSpec sheet;
  sheet.name = "cloth";
  sheet.rows = rows;
  sheet.columns = columns;
  sheet.to = {0.8, 0.0, 0.0};
  sheet.down = {0.0, -0.6, 0.0};
  sheet.diagonals = LinkProperties{};
  sheet.skip_one = LinkProperties{};
  description.sheets = {sheet};
  const Built built = build(description);
  ASSERT_TRUE(built.problems.empty());
  const LinkLines lines = sound_lines(built.model, all_links(built.model));
  std::vector<std::vector<Index>> expected;
  // Masses from (row, column) on in steps, as long as they are in the sheet.
  const auto add = [&](int row, int column, int down, int right) {
    std::vector<Index> masses;
    for (; row < rows && column >= 0 && column < columns; row += down, column += right)
      masses.push_back(static_cast<Index>(row * columns + column));
    if (masses.size() > 1) expected.push_back(std::move(masses));
  };
  for (int row = 0; row < rows; ++row) {
    add(row, 0, 0, 1);
    add(row, 0, 0, 2);
    add(row, 1, 0, 2);
    add(row, 0, 1, 1);
    add(row, columns - 1, 1, -1);
  }
  for (int column = 0; column < columns; ++column) {
    add(0, column, 1, 0);
    add(0, column, 2, 0);
    add(1, column, 2, 0);
    if (column > 0) add(0, column, 1, 1);
    if (column < columns - 1) add(0, column, 1, -1);
  }
  std::ranges::sort(expected);
  EXPECT_EQ(ways(lines), expected);
  EXPECT_EQ(lines.colours, 6U) << "rows, columns, two kinds of diagonals and two of skip-one links";
}

TEST(Lines, AChainIsOneLineHoweverItIsNumbered) {
  std::mt19937 random(7);
  std::vector<Index> number(40);
  for (Index i = 0; i < number.size(); ++i) number[i] = i;
  for (const bool shuffled : {false, true}) {
    if (shuffled)
      for (std::size_t i = number.size(); i > 1; --i) std::swap(number[i - 1], number[random() % i]);
    std::vector<std::pair<Index, Index>> ends;
    for (std::size_t i = 0; i + 1 < number.size(); ++i) ends.emplace_back(number[i], number[i + 1]);
    if (shuffled)
      for (std::size_t i = ends.size(); i > 1; --i) std::swap(ends[i - 1], ends[random() % i]);
    const Model model = model_of(40, ends);
    const LinkLines lines = sound_lines(model, all_links(model));
    std::vector<Index> expected = number;
    if (expected.front() > expected.back()) std::ranges::reverse(expected);
    EXPECT_EQ(ways(lines), std::vector<std::vector<Index>>{expected});
    EXPECT_EQ(lines.colours, 1U);
  }
}

// A line goes round the ring until the mass that it began at, which the last link is left for.
TEST(Lines, ARingIsCutAheadOfItsLowestLink) {
  const Model model = model_of(5, {{3, 1}, {1, 4}, {4, 0}, {0, 2}, {2, 3}});
  const LinkLines lines = sound_lines(model, all_links(model));
  EXPECT_EQ(ways(lines), (std::vector<std::vector<Index>>{{2, 0, 4, 1, 3}, {2, 3}}));
  EXPECT_EQ(lines.colours, 2U);
}

TEST(Lines, EndAtPins) {
  const Model model = model_of(6, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}}, {0, 3});
  const LinkLines lines = sound_lines(model, all_links(model));
  EXPECT_EQ(ways(lines), (std::vector<std::vector<Index>>{{0, 1, 2, 3}, {3, 4, 5}}));
  EXPECT_EQ(lines.colours, 1U) << "lines that meet in a pin don't disturb each other";
}

// A ring that hangs by one pin is a line from the pin to itself.
TEST(Lines, BothEndsMayBeOnePin) {
  const Model model = model_of(4, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, {0});
  EXPECT_EQ(ways(sound_lines(model, all_links(model))), (std::vector<std::vector<Index>>{{0, 1, 2, 3, 0}}));
}

// Of three arms that meet those two go on into each other whose numbers go straight on; where none do, none.
TEST(Lines, OfAJunctionGoStraightOn) {
  const Model straight = model_of(6, {{0, 1}, {1, 2}, {2, 3}, {2, 5}});
  EXPECT_EQ(ways(sound_lines(straight, all_links(straight))),
            (std::vector<std::vector<Index>>{{0, 1, 2, 3}, {2, 5}}));
  const Model crooked = model_of(10, {{0, 3}, {3, 4}, {3, 9}});
  EXPECT_EQ(ways(sound_lines(crooked, all_links(crooked))),
            (std::vector<std::vector<Index>>{{0, 3}, {3, 4}, {3, 9}}));
}

// Round a loop and past its own beginning: cut before the link that comes back.
TEST(Lines, NeverComeBackToAMass) {
  // 2 is between 1 and 3, and between 0 and 4; 3 – 5 – 4 closes the loop.
  const Model model = model_of(6, {{1, 2}, {2, 3}, {3, 5}, {5, 4}, {4, 2}, {2, 0}});
  const LinkLines lines = sound_lines(model, all_links(model));
  EXPECT_EQ(ways(lines), (std::vector<std::vector<Index>>{{0, 2, 4}, {1, 2, 3, 5, 4}}));
}

TEST(Lines, TwoLinksBetweenTwoMassesAreTwoLines) {
  const Model model = model_of(2, {{0, 1}, {1, 0}});
  EXPECT_EQ(ways(sound_lines(model, all_links(model))), (std::vector<std::vector<Index>>{{0, 1}, {0, 1}}));
}

TEST(Lines, ABrokenLinkCutsOne) {
  const Model model = model_of(6, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}});
  EXPECT_EQ(ways(sound_lines(model, {0, 1, 3, 4})), (std::vector<std::vector<Index>>{{0, 1, 2}, {3, 4, 5}}));
}

TEST(Lines, OfAnyTangleAreSound) {
  std::mt19937 random(11);
  for (int tangle = 0; tangle < 200; ++tangle) {
    const auto masses = static_cast<Index>(2 + random() % 30);
    std::vector<std::pair<Index, Index>> ends;
    for (std::size_t i = 0; i < random() % 80; ++i) {
      const auto a = static_cast<Index>(random() % masses), b = static_cast<Index>(random() % masses);
      if (a != b) ends.emplace_back(a, b);
    }
    const Model model = model_of(masses, ends, {static_cast<Index>(random() % masses)});
    sound_lines(model, all_links(model));
  }
}

}  // namespace
}  // namespace taut
