// Passes over the lines of a large sheet, whose masses and links lie in any order, against the same lines
// solved one by one, colour by colour, by a general solver.

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "relax/line_relaxation.h"
#include "relax/relaxation.h"

namespace taut {
namespace {

constexpr Index line_sheet_side = 40;
constexpr double line_step = 0.01, line_answer = 0.8;

// A sheet with diagonals and pins, its links listed at random and some of them soft or damped; its masses are
// numbered row by row, or at random.
Model sheet_of_all_links(std::mt19937& random, bool in_rows) {
  std::vector<Index> number(line_sheet_side * line_sheet_side);
  for (Index i = 0; i < number.size(); ++i) number[i] = i;
  if (!in_rows)
    for (std::size_t i = number.size(); i > 1; --i) std::swap(number[i - 1], number[random() % i]);
  std::vector<std::pair<Index, Index>> ends;
  for (Index row = 0; row < line_sheet_side; ++row)
    for (Index column = 0; column < line_sheet_side; ++column) {
      const auto add = [&](Index other_row, Index other_column) {
        if (other_row < line_sheet_side && other_column < line_sheet_side)
          ends.emplace_back(number[row * line_sheet_side + column],
                            number[other_row * line_sheet_side + other_column]);
      };
      add(row, column + 1);
      add(row + 1, column);
      add(row + 1, column + 1);
    }
  for (std::size_t i = ends.size(); i > 1; --i) std::swap(ends[i - 1], ends[random() % i]);
  Model model;
  for (Index i = 0; i < line_sheet_side * line_sheet_side; ++i) {
    const double mass = 1.0 + 0.5 * (i % 5);
    model.masses.name.push_back("m");
    model.masses.mass.push_back(mass);
    model.masses.inverse_mass.push_back(i % 97 == 0 ? 0.0 : 1.0 / mass);
    model.masses.radius.push_back(0.0);
  }
  for (const auto& [a, b] : ends) {
    const auto kind = random() % 60;
    model.links.a.push_back(a);
    model.links.b.push_back(b);
    model.links.length.push_back(0.5);
    model.links.stiffness.push_back(kind < 2 ? 2000.0 : infinity);
    model.links.damping.push_back(kind < 1 ? 3.0 : 0.0);
    model.links.break_stretch.push_back(infinity);
    model.links.break_tension.push_back(infinity);
  }
  return model;
}

// Solves one line by what line_relaxation.h says, with a general solver.
void plain_line(const Model& model, std::span<const Index> links, std::span<const Index> masses,
                const Vectors& start, Vectors& position, std::vector<double>& multiplier) {
  const auto count = static_cast<Eigen::Index>(links.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd right(count);
  std::vector<Vec3> normal;
  const auto moves = [&](std::size_t i) { return line_answer * model.masses.inverse_mass[masses[i]]; };
  const bool between_pins =
      links.size() > 1 && model.masses.pinned(masses.front()) && model.masses.pinned(masses.back());
  for (std::size_t i = 0; i < links.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const Index link = links[i];
    const Vec3 d = position.at(masses[i]) - position.at(masses[i + 1]);
    const Vec3 d0 = start.at(masses[i]) - start.at(masses[i + 1]);
    normal.push_back(d / d.norm());
    const double scaled = model.links.compliance(link) / (line_step * line_step);
    const double gamma = model.links.compliance(link) * model.links.damping[link] / line_step;
    right[row] =
        (model.links.length[link] - d.norm() - scaled * multiplier[link] - gamma * normal[i].dot(d - d0)) /
        (1.0 + gamma);
    matrix(row, row) = moves(i) + moves(i + 1) + scaled / (1.0 + gamma);
    if (between_pins) matrix(row, row) *= 1.0 + 1e-3 / static_cast<double>(links.size());
    if (i > 0) matrix(row, row - 1) = matrix(row - 1, row) = -moves(i) * normal[i - 1].dot(normal[i]);
  }
  const Eigen::VectorXd change = matrix.partialPivLu().solve(right);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Vec3 push = change[static_cast<Eigen::Index>(i)] * normal[i];
    position.add(masses[i], moves(i) * push);
    position.add(masses[i + 1], -moves(i + 1) * push);
    multiplier[links[i]] += change[static_cast<Eigen::Index>(i)];
  }
}

// From random places near where masses should be.
State scattered_state(const Model& model, std::mt19937& random) {
  State state;
  state.broken_at.assign(model.links.size(), infinity);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (Index i = 0; i < line_sheet_side * line_sheet_side; ++i)
    state.position.push_back({number(), number(), number()});
  return state;
}

class LinesInAnyOrder : public ::testing::TestWithParam<int> {};

TEST_P(LinesInAnyOrder, AreSolvedExactly) {
  for (const bool in_rows : {true, false}) {
    std::mt19937 random(3);
    const Model model = sheet_of_all_links(random, in_rows);
    const State state = scattered_state(model, random);
    LineRelaxation relaxation(model, {std::make_shared<Workers>(GetParam())});
    LineRelaxation alone(model, {});
    relaxation.links_changed(state);
    alone.links_changed(state);
    EXPECT_EQ(relaxation.size(), static_cast<std::int64_t>(solvable_links(model).size()));
    const LinkLines lines = lines_of(model, solvable_links(model));
    Vectors expected = state.position, relaxed = state.position, alone_relaxed = state.position;
    std::vector<double> multiplier(model.links.size(), 0.0);
    auto start = relaxation.places().room(), packed = start, alone_packed = start;
    relaxation.places().load(state.position, start);
    relaxation.places().load(state.position, packed);
    relaxation.places().load(state.position, alone_packed);
    relaxation.begin_step(line_step, line_answer);
    alone.begin_step(line_step, line_answer);
    for (int pass = 0; pass < 2; ++pass) {
      EXPECT_TRUE(relaxation.pass(start, packed, {pass == 0, pass == 1}));
      EXPECT_TRUE(alone.pass(start, alone_packed, {pass == 0, pass == 1}));
      for (std::size_t colour = 0; colour < lines.colours; ++colour)
        for (const LinkLine& line : lines.lines)
          if (line.colour == colour)
            plain_line(model, lines.links_of(line), lines.masses_of(line), state.position, expected,
                       multiplier);
    }
    relaxation.places().give(packed, relaxed);
    alone.places().give(alone_packed, alone_relaxed);
    EXPECT_EQ(relaxed, alone_relaxed) << "other bits with threads";
    double off = 0.0, wrong = 0.0;
    for (Index i = 0; i < line_sheet_side * line_sheet_side; ++i)
      off = std::max(off, (relaxed.at(i) - expected.at(i)).norm() / (1.0 + expected.at(i).norm()));
    for (const Index link : relaxation.links()) {
      EXPECT_EQ(relaxation.multiplier(link), alone.multiplier(link));
      wrong = std::max(wrong, std::abs(relaxation.multiplier(link) - multiplier[link]) /
                                  (1.0 + std::abs(multiplier[link])));
    }
    EXPECT_LT(off, 1e-9) << (in_rows ? "numbered in rows" : "numbered at random");
    EXPECT_LT(wrong, 1e-9) << (in_rows ? "numbered in rows" : "numbered at random");
    // Wherever a mass is that is no longer a number, it is found.
    for (Index mass = 1; mass < line_sheet_side * line_sheet_side; mass += 97) {
      Vectors lost = state.position;
      lost.y[mass] = infinity;
      relaxation.places().load(lost, packed);
      EXPECT_FALSE(relaxation.pass(start, packed, {true, true})) << mass;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Threads, LinesInAnyOrder, ::testing::Values(1, 2, 3, 8));

// Every other link of a chain, soft or not: each a line of its own, for which there is a simpler formula.
TEST(LinesOfOneLink, AreRelaxedAsLinksAre) {
  std::mt19937 random(5);
  Model model = sheet_of_all_links(random, true);
  const State state = [&] {
    State all = scattered_state(model, random);
    std::vector<bool> met(line_sheet_side * line_sheet_side, false);
    for (Index link = 0; link < model.links.size(); ++link) {
      const Index a = model.links.a[link], b = model.links.b[link];
      if (met[a] || met[b])
        all.broken_at[link] = 0.0;
      else
        met[a] = met[b] = true;
    }
    return all;
  }();
  LineRelaxation by_lines(model, {});
  Relaxation<double> by_links(model, {});
  Vectors relaxed = state.position, expected = state.position;
  const auto relax = [&](auto& relaxation, Vectors& to) {
    relaxation.links_changed(state);
    auto start = relaxation.places().room(), packed = start;
    relaxation.places().load(state.position, start);
    relaxation.places().load(state.position, packed);
    relaxation.begin_step(line_step, line_answer);
    for (int pass = 0; pass < 3; ++pass) relaxation.pass(start, packed, {pass == 0, pass == 2});
    relaxation.places().give(packed, to);
  };
  relax(by_lines, relaxed);
  relax(by_links, expected);
  EXPECT_GT(by_lines.size(), 500);
  for (Index i = 0; i < line_sheet_side * line_sheet_side; ++i)
    EXPECT_LT((relaxed.at(i) - expected.at(i)).norm(), 1e-14) << "mass " << i;
  for (const Index link : by_links.links())
    EXPECT_NEAR(by_lines.multiplier(link), by_links.multiplier(link), 1e-13) << "link " << link;
}

}  // namespace
}  // namespace taut
