// The three matrices behind the direct methods against one dense matrix, put together from the definition
// A = R W Cᵀ + diag.

#include <Eigen/Dense>
#include <memory>
#include <numeric>
#include <random>

#include "direct/link_matrices.h"
#include "direct/link_system.h"
#include "direct/link_topology.h"
#include "physics/fixtures.h"

namespace taut::test {
namespace {

enum class Shape { path, tree, net };

struct Case {
  std::string label;
  Shape shape;
  int masses;
  std::vector<int> pins;
  std::vector<std::pair<int, int>> links;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.label;
}

// Masses of unlike weight at random places.
Built build_case(const Case& c, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1.0, 1.0), exponent(-1.0, 1.0);
  Description description;
  for (int i = 0; i < c.masses; ++i) {
    MassSpec spec;
    spec.name = "m" + std::to_string(i);
    spec.position = {place(random), place(random), place(random)};
    spec.mass = std::pow(10.0, exponent(random));
    spec.pinned = std::find(c.pins.begin(), c.pins.end(), i) != c.pins.end();
    description.masses.push_back(spec);
  }
  for (const auto& [a, b] : c.links)
    description.links.push_back(LinkSpec{"m" + std::to_string(a), "m" + std::to_string(b), std::nullopt, {}});
  return build_valid(description);
}

Eigen::MatrixXd gradients(const SystemLinks& links, const Vectors& along, std::size_t masses) {
  Eigen::MatrixXd rows =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(links.size()), 3 * static_cast<Eigen::Index>(masses));
  for (std::size_t i = 0; i < links.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    rows.block<1, 3>(row, 3 * static_cast<Eigen::Index>(links.a[i])) += along.at(i).transpose();
    rows.block<1, 3>(row, 3 * static_cast<Eigen::Index>(links.b[i])) -= along.at(i).transpose();
  }
  return rows;
}

Eigen::MatrixXd dense_matrix(const Model& model, const SystemLinks& links, const Vectors& rows,
                             const Vectors& columns, const std::vector<double>& diagonal) {
  const std::size_t count = model.masses.size();
  Eigen::VectorXd weights(3 * static_cast<Eigen::Index>(count));
  for (std::size_t i = 0; i < count; ++i)
    weights.segment<3>(3 * static_cast<Eigen::Index>(i)).setConstant(model.masses.inverse_mass[i]);
  Eigen::MatrixXd dense =
      gradients(links, rows, count) * weights.asDiagonal() * gradients(links, columns, count).transpose();
  for (std::size_t i = 0; i < diagonal.size(); ++i)
    dense(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) += diagonal[i];
  return dense;
}

std::vector<double> random_numbers(std::size_t count, double low, double high, std::mt19937& random) {
  std::uniform_real_distribution<double> distribution(low, high);
  std::vector<double> numbers(count);
  for (double& number : numbers) number = distribution(random);
  return numbers;
}

Vectors turned(const Vectors& directions, std::mt19937& random) {
  std::uniform_real_distribution<double> shift(-0.3, 0.3);
  Vectors other = directions;
  for (std::size_t i = 0; i < other.size(); ++i) {
    const double size = directions.at(i).norm();
    other.add(i, size * Vec3(shift(random), shift(random), shift(random)));
  }
  return other;
}

void expect_solves(const Model& model, LinkSystem& system, const Vectors& rows, const Vectors& columns,
                   const std::vector<double>& diagonal, std::mt19937& random) {
  const Eigen::MatrixXd dense = dense_matrix(model, system.links, rows, columns, diagonal);
  const std::vector<double> wanted = random_numbers(system.links.size(), -1.0, 1.0, random);
  const Eigen::Map<const Eigen::VectorXd> right(wanted.data(), static_cast<Eigen::Index>(wanted.size()));
  ASSERT_TRUE(system.matrix->factor(rows, columns, diagonal));
  std::vector<double> solution = wanted;
  system.matrix->solve(solution);
  const Eigen::Map<const Eigen::VectorXd> found(solution.data(), static_cast<Eigen::Index>(solution.size()));
  const Eigen::VectorXd exact = dense.fullPivLu().solve(right);
  EXPECT_LT((found - exact).norm(), 1e-10 * exact.norm());
  std::vector<double> at_once = wanted;
  ASSERT_TRUE(system.matrix->factor_and_solve(rows, columns, diagonal, at_once));
  EXPECT_EQ(at_once, solution) << "bit for bit";
}

class LinkMatrices : public ::testing::TestWithParam<Case> {
 protected:
  void prepare(unsigned seed) {
    built = build_case(GetParam(), seed);
    system = make_link_system(built.model, solvable_links(built.model));
    random.seed(seed + 1000);
    link_vectors(system.links, built.start.position, directions);
  }

  Built built;
  LinkSystem system;
  Vectors directions;
  std::mt19937 random;
};

TEST_P(LinkMatrices, IsOfTheKindThatItsShapeAllows) {
  prepare(1);
  const std::vector<Index> links = solvable_links(built.model);
  EXPECT_EQ(path_order(built.model, links).has_value(), GetParam().shape == Shape::path);
  if (GetParam().shape != Shape::path) {
    EXPECT_EQ(tree_order(built.model, links).has_value(), GetParam().shape == Shape::tree);
  }
  EXPECT_EQ(system.matrix->takes_unsymmetric(), GetParam().shape != Shape::net);
  std::vector<Index> sorted = system.links.link;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(sorted, links) << "every link once";
}

TEST_P(LinkMatrices, SymmetricAgreesWithTheDenseSolve) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    prepare(seed);
    const std::size_t count = system.links.size();
    expect_solves(built.model, system, directions, directions, random_numbers(count, 0.5, 1.0, random),
                  random);
    if (count <= 9)
      expect_solves(built.model, system, directions, directions, std::vector(count, 0.0), random);
  }
}

TEST_P(LinkMatrices, UnsymmetricAgreesWithTheDenseSolve) {
  if (GetParam().shape == Shape::net) return;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    prepare(seed);
    const Vectors columns = turned(directions, random);
    expect_solves(built.model, system, directions, columns,
                  random_numbers(system.links.size(), 0.5, 1, random), random);
  }
}

TEST_P(LinkMatrices, FactorsAgainAndAgain) {
  prepare(3);
  for (int round = 0; round < 3; ++round) {
    const Vectors rows = turned(directions, random);
    expect_solves(built.model, system, rows, rows, random_numbers(system.links.size(), 0.1, 1.0, random),
                  random);
  }
}

TEST_P(LinkMatrices, RefusesWhatIsNotFinite) {
  prepare(4);
  directions.x[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(system.matrix->factor(directions, directions, std::vector(system.links.size(), 0.0)));
}

TEST_P(LinkMatrices, ImpulsesAreTheTransposedGradients) {
  prepare(5);
  const std::size_t masses = built.model.masses.size();
  const std::vector<double> strength = random_numbers(system.links.size(), -1.0, 1.0, random);
  Vectors moved = built.start.position;
  apply_impulses(system.links, directions, strength, moved);
  const Eigen::Map<const Eigen::VectorXd> s(strength.data(), static_cast<Eigen::Index>(strength.size()));
  const Eigen::VectorXd pull = gradients(system.links, directions, masses).transpose() * s;
  for (std::size_t i = 0; i < masses; ++i) {
    const Vec3 exact = built.start.position.at(i) +
                       built.model.masses.inverse_mass[i] * pull.segment<3>(3 * static_cast<Eigen::Index>(i));
    EXPECT_LT((moved.at(i) - exact).norm(), 1e-13 * (1.0 + exact.norm())) << "mass " << i;
  }
}

std::vector<std::pair<int, int>> grid_links(int rows, int columns, bool diagonals) {
  std::vector<std::pair<int, int>> links;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const int mass = row * columns + column;
      if (column + 1 < columns) links.emplace_back(mass, mass + 1);
      if (row + 1 < rows) links.emplace_back(mass + columns, mass);
      if (diagonals && row + 1 < rows && column + 1 < columns) links.emplace_back(mass, mass + columns + 1);
    }
  return links;
}

std::vector<std::pair<int, int>> row_links(int masses) {
  std::vector<std::pair<int, int>> links;
  for (int mass = 1; mass < masses; ++mass) links.emplace_back(mass - 1, mass);
  return links;
}

std::vector<Case> cases() {
  const std::vector<std::pair<int, int>> row{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}};
  const std::vector<std::pair<int, int>> mixed_ends{{3, 4}, {1, 0}, {2, 1}, {2, 3}, {5, 4}};
  const std::vector<std::pair<int, int>> branches{{0, 1}, {2, 1}, {1, 3}, {4, 3}, {3, 5}, {6, 5}};
  return {
      {"one_link", Shape::path, 2, {}, {{0, 1}}},
      {"free_path", Shape::path, 6, {}, row},
      {"hanging_path", Shape::path, 6, {0}, row},
      {"long_path", Shape::path, 41, {0, 20}, row_links(41)},
      {"very_long_path", Shape::path, 151, {0}, row_links(151)},
      {"path_between_pins", Shape::path, 6, {0, 5}, row},
      {"path_out_of_order", Shape::path, 6, {5}, mixed_ends},
      {"two_paths_at_one_pin", Shape::path, 6, {2}, row},
      {"two_free_paths", Shape::path, 7, {}, {{0, 1}, {4, 5}, {1, 2}, {6, 5}}},
      {"free_tree", Shape::tree, 7, {}, branches},
      {"hanging_tree", Shape::tree, 7, {0}, branches},
      {"tree_hung_by_a_leaf", Shape::tree, 7, {6}, branches},
      {"trees_at_one_pin", Shape::tree, 9, {1}, {{1, 0}, {0, 2}, {0, 3}, {4, 1}, {4, 5}, {4, 6}, {7, 8}}},
      {"ring", Shape::net, 5, {}, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}}},
      {"tree_between_pins", Shape::net, 7, {0, 6}, branches},
      {"grid", Shape::net, 12, {0, 3}, grid_links(3, 4, false)},
      {"grid_with_diagonals", Shape::net, 12, {0}, grid_links(3, 4, true)},
      {"large_grid", Shape::net, 81, {0, 8, 40}, grid_links(9, 9, true)},
  };
}

INSTANTIATE_TEST_SUITE_P(Shapes, LinkMatrices, ::testing::ValuesIn(cases()),
                         [](const auto& one) { return one.param.label; });

// Links that say the same twice make the matrix singular. Where the right side can be met (it is A times
// something), it is met, although the solution is not unique.
void expect_consistent_solve(const Built& built) {
  LinkSystem system = make_link_system(built.model, solvable_links(built.model));
  const std::size_t count = system.links.size();
  Vectors directions;
  link_vectors(system.links, built.start.position, directions);
  const std::vector<double> none(count, 0.0);
  const Eigen::MatrixXd dense = dense_matrix(built.model, system.links, directions, directions, none);
  Eigen::FullPivLU<Eigen::MatrixXd> lu(dense);
  lu.setThreshold(1e-10);
  EXPECT_LT(lu.rank(), static_cast<Eigen::Index>(count)) << "the case is not singular";

  std::mt19937 random(11);
  const std::vector<double> some = random_numbers(count, -1.0, 1.0, random);
  const Eigen::VectorXd right =
      dense * Eigen::Map<const Eigen::VectorXd>(some.data(), static_cast<Eigen::Index>(count));
  std::vector<double> solution(right.begin(), right.end());
  ASSERT_TRUE(system.matrix->factor(directions, directions, none));
  system.matrix->solve(solution);
  const Eigen::Map<const Eigen::VectorXd> found(solution.data(), static_cast<Eigen::Index>(count));
  EXPECT_LT((dense * found - right).norm(), 1e-5 * right.norm());
  EXPECT_LT(found.norm(), 1e3 * right.norm() / dense.norm() * static_cast<double>(count));
}

TEST(RedundantLinks, TautRowBetweenTwoPins) {
  Description description = level_chain(6, 0.2);
  description.chains[0].pinned = {"first", "last"};
  expect_consistent_solve(build_valid(description));
}

TEST(RedundantLinks, FlatPlateWithRigidDiagonals) {
  Description description;
  SheetSpec sheet;
  sheet.name = "plate";
  sheet.rows = sheet.columns = 5;
  sheet.to = {0.4, 0.0, 0.0};
  sheet.down = {0.0, -0.4, 0.0};
  sheet.pinned = {"top"};
  sheet.diagonals = LinkProperties{};
  description.sheets = {sheet};
  expect_consistent_solve(build_valid(description));
}

// Long rows are eliminated in groups, by products of pivots that numbers may not hold.
TEST(LongPaths, SolveAlikeAtAnyScale) {
  const Case row{"row", Shape::path, 101, {0}, row_links(101)};
  const Built built = build_case(row, 5);
  LinkSystem system = make_link_system(built.model, solvable_links(built.model));
  const std::size_t count = system.links.size();
  Vectors directions;
  link_vectors(system.links, built.start.position, directions);
  std::mt19937 random(6);
  const std::vector<double> diagonal = random_numbers(count, 0.5, 1.0, random);
  const std::vector<double> right = random_numbers(count, -1.0, 1.0, random);
  const auto solve = [&](double scale) {
    Vectors scaled = directions;
    for (auto* axis : {&scaled.x, &scaled.y, &scaled.z})
      for (double& value : *axis) value *= scale;
    std::vector<double> on_diagonal = diagonal, solution = right;
    for (double& value : on_diagonal) value *= scale * scale;
    EXPECT_TRUE(system.matrix->factor_and_solve(scaled, scaled, on_diagonal, solution)) << scale;
    for (double& value : solution) value *= scale * scale;
    return solution;
  };
  const std::vector<double> at_one = solve(1.0);
  for (const double scale : {1e-70, 1e-20, 1e-9, 1e9, 1e20, 1e70}) {
    const std::vector<double> solution = solve(scale);
    for (std::size_t i = 0; i < count; ++i)
      EXPECT_NEAR(solution[i], at_one[i], 1e-11 * std::abs(at_one[i])) << "link " << i << " at " << scale;
  }
}

// A path of masses at random, and what its matrix is asked to solve.
struct RandomPath {
  Built built;
  LinkSystem system;
  Vectors rows, columns;
  std::vector<double> diagonal, right;

  RandomPath(int links, unsigned seed)
      : built(build_case({"row", Shape::path, links + 1, {0}, row_links(links + 1)}, seed)),
        system(make_link_system(built.model, solvable_links(built.model))) {
    std::mt19937 random(seed + 7);
    link_vectors(system.links, built.start.position, rows);
    columns = turned(rows, random);
    diagonal = random_numbers(system.links.size(), 0.5, 1.0, random);
    right = random_numbers(system.links.size(), -1.0, 1.0, random);
  }
};

// Lengths about those of blocks, and of groups in them.
const std::vector<int> lengths_of_paths{1,   2,   3,   15,  16,  31,  32,  33,  34,  35,  127, 128, 255, 256,
                                        257, 258, 259, 273, 288, 289, 290, 511, 512, 513, 514, 515, 700};

TEST(LongPaths, AreSolvedAtEveryLength) {
  for (const int links : lengths_of_paths) {
    SCOPED_TRACE(links);
    RandomPath path(links, 8);
    for (const Vectors* columns : {&path.rows, &path.columns}) {
      std::vector<double> solution = path.right, answer;
      ASSERT_TRUE(path.system.matrix->factor_and_solve(path.rows, *columns, path.diagonal, solution));
      Vectors moved;
      moved.resize(path.built.model.masses.size());
      apply_impulses(path.system.links, *columns, solution, moved);
      along_links(path.system.links, path.rows, moved, answer);
      for (std::size_t i = 0; i < answer.size(); ++i)
        EXPECT_NEAR(answer[i] + path.diagonal[i] * solution[i], path.right[i], 1e-11) << "link " << i;
    }
  }
}

// Right sides are only asked for when they are about to be read, each once, and solutions are whole when they
// are shown.
TEST(LongPaths, VisitLinksWhileTheyAreAtHand) {
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  for (const int links : lengths_of_paths) {
    SCOPED_TRACE(links);
    RandomPath path(links, 9);
    LinkMatrix& matrix = *path.system.matrix;
    std::vector<double> expected = path.right;
    ASSERT_TRUE(matrix.factor_and_solve(path.rows, path.columns, path.diagonal, expected));
    for (const bool factor : {true, false}) {
      std::vector<double> b(path.right.size(), unknown);
      std::vector<int> times_asked(b.size(), 0);
      Extent shown;
      const auto write = [&](Extent some) {
        for (std::size_t i = some.begin; i < some.end; ++i) {
          b[i] = path.right[i];
          ++times_asked[i];
        }
      };
      const auto look = [&](Extent solved) {
        EXPECT_TRUE(shown.empty() || (solved.begin <= shown.begin && shown.end <= solved.end));
        shown = solved;
        for (std::size_t i = solved.begin; i < solved.end; ++i) EXPECT_EQ(b[i], expected[i]) << "link " << i;
      };
      if (factor)
        ASSERT_TRUE(
            matrix.factor_and_solve_by_blocks(path.rows, path.columns, path.diagonal, b, {write, look}));
      else
        matrix.solve_by_blocks(b, {write, look});
      EXPECT_EQ(times_asked, std::vector(b.size(), 1));
      EXPECT_EQ(shown.begin, 0U);
      EXPECT_EQ(shown.end, b.size());
      EXPECT_EQ(b, expected);
    }
  }
}

TEST(LongPaths, RefuseWhatIsNotFiniteWhereverItIs) {
  for (const std::size_t bad : {0U, 1U, 127U, 128U, 199U, 200U, 201U, 271U, 272U, 399U, 400U}) {
    RandomPath path(401, 10);
    path.diagonal[bad] = std::numeric_limits<double>::infinity();  // which no other row hears of
    EXPECT_FALSE(path.system.matrix->factor_and_solve(path.rows, path.rows, path.diagonal, path.right))
        << bad;
  }
}

// Their pivots vanish in the midst of others.
TEST(RedundantLinks, TautRowsBetweenPinsOfALongRow) {
  Built built = build_valid(level_chain(100, 0.2));
  for (const std::size_t pin : {5U, 70U, 88U}) built.model.masses.inverse_mass[pin] = 0.0;
  expect_consistent_solve(built);
}

TEST(RedundantLinks, TwoLinksBetweenTheSameMasses) {
  Description description = spinning_dumbbell();
  description.links.push_back(LinkSpec{"heavy", "light", 1.0, {}});
  expect_consistent_solve(build_valid(description));
}

}  // namespace
}  // namespace taut::test
