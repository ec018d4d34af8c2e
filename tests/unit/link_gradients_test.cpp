// Gradients and Jacobians against finite differences.

#include <random>

#include "direct/link_system.h"
#include "forces/springs.h"
#include "model/measures.h"
#include "physics/fixtures.h"

namespace taut::test {
namespace {

// A net of masses of unlike weight away from rest, one of them pinned, all moving. Every link is longer than
// its length when `taut`, else some are shorter.
Built shaken_sheet(bool taut, LinkProperties properties) {
  Description description;
  SheetSpec sheet;
  sheet.name = "cloth";
  sheet.rows = 4;
  sheet.columns = 5;
  sheet.to = {1.0, 0.0, 0.0};
  sheet.down = {0.0, -0.8, 0.1};
  sheet.pinned = {"top-left", "right"};
  sheet.properties = properties;
  sheet.diagonals = properties;
  description.sheets = {sheet};
  description.drag = 0.4;
  Built built = build_valid(description);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> shift(-0.03, 0.03), speed(-1.0, 1.0);
  for (std::size_t i = 0; i < built.model.masses.size(); ++i) {
    if (built.model.masses.pinned(i)) continue;
    built.model.masses.mass[i] *= 1.0 + 0.7 * speed(random);
    built.model.masses.inverse_mass[i] = 1.0 / built.model.masses.mass[i];
    built.start.velocity.set(i, {speed(random), speed(random), speed(random)});
  }
  for (std::size_t i = 0; i < built.model.masses.size(); ++i)
    built.start.position.set(i, (taut ? 1.3 : 1.0) * built.start.position.at(i) +
                                    Vec3(shift(random), shift(random), shift(random)));
  return built;
}

LinkProperties springy(double damping) {
  return {200.0, damping, std::nullopt, std::nullopt};
}

// Force on every mass at a configuration.
Vectors spring_forces(const Built& built, const Vectors& position, const Vectors& velocity) {
  const Springs springs = gather_springs(built.model, built.start);
  Vectors kicked;
  kicked.x = kicked.y = kicked.z = std::vector<double>(position.size(), 0.0);
  std::vector<double> tension;
  kick_by_springs(springs, 1.0, position, velocity, kicked, tension);
  for (std::size_t i = 0; i < position.size(); ++i) kicked.set(i, built.model.masses.mass[i] * kicked.at(i));
  return kicked;
}

Vectors at_rest(const Vectors& velocity) {
  Vectors still = velocity;
  for (std::size_t i = 0; i < still.size(); ++i) still.set(i, Vec3::Zero());
  return still;
}

TEST(SpringForces, AreTheNegativeGradientOfTheElasticEnergy) {
  for (const bool taut : {true, false}) {
    const Built built = shaken_sheet(taut, springy(0.0));
    const Vectors forces = spring_forces(built, built.start.position, at_rest(built.start.velocity));
    constexpr double h = 1e-6;
    for (std::size_t i = 0; i < forces.size(); ++i) {
      if (built.model.masses.pinned(i)) continue;
      for (int axis = 0; axis < 3; ++axis) {
        const auto elastic = [&](double shift) {
          State moved = built.start;
          Vec3 x = moved.position.at(i);
          x[axis] += shift;
          moved.position.set(i, x);
          return energy(built.model, moved).elastic;
        };
        EXPECT_NEAR(forces.at(i)[axis], -(elastic(h) - elastic(-h)) / (2.0 * h), 1e-6)
            << "mass " << i << ", axis " << axis;
      }
    }
  }
}

// Damping forces are the negative gradient, by velocities, of Σ c (n·ḋ)²/2.
TEST(SpringForces, DampingIsTheGradientOfTheDissipation) {
  const Built built = shaken_sheet(true, springy(3.0));
  const Vectors damped = spring_forces(built, built.start.position, built.start.velocity);
  const Vectors elastic = spring_forces(built, built.start.position, at_rest(built.start.velocity));
  const auto dissipation = [&](const Vectors& velocity) {
    double sum = 0.0;
    for (std::size_t link = 0; link < built.model.links.size(); ++link) {
      const Index a = built.model.links.a[link], b = built.model.links.b[link];
      const Vec3 n = (built.start.position.at(a) - built.start.position.at(b)).normalized();
      const double rate = n.dot(velocity.at(a) - velocity.at(b));
      sum += 0.5 * built.model.links.damping[link] * rate * rate;
    }
    return sum;
  };
  constexpr double h = 1e-5;
  for (std::size_t i = 0; i < damped.size(); ++i) {
    if (built.model.masses.pinned(i)) continue;
    for (int axis = 0; axis < 3; ++axis) {
      const auto shifted = [&](double shift) {
        Vectors velocity = built.start.velocity;
        Vec3 v = velocity.at(i);
        v[axis] += shift;
        velocity.set(i, v);
        return dissipation(velocity);
      };
      EXPECT_NEAR((damped.at(i) - elastic.at(i))[axis], -(shifted(h) - shifted(-h)) / (2.0 * h), 1e-7);
    }
  }
}

TEST(SpringForces, HighestFrequencyOfAChainBetweenPinsIsExact) {
  for (const int links : {2, 5, 20}) {
    Description description = level_chain(links, 0.1);
    description.chains[0].pinned = {"first", "last"};
    description.chains[0].properties.stiffness = 250.0;
    const Built built = build_valid(description);
    const double exact =
        2.0 * std::sqrt(250.0) * std::sin(0.5 * 3.14159265358979323846 * (links - 1) / links);
    EXPECT_NEAR(highest_frequency(gather_springs(built.model, built.start), built.start.position), exact,
                1e-4 * exact)
        << links << " links";
  }
}

TEST(SpringForces, HighestFrequencyOfTwoFreeMassesIsExact) {
  Description description = spinning_dumbbell();
  description.links[0].properties.stiffness = 90.0;
  const Built built = build_valid(description);
  EXPECT_NEAR(highest_frequency(gather_springs(built.model, built.start), built.start.position),
              std::sqrt(90.0 * (1.0 + 1.0 / 3.0)), 1e-6);
}

// With s added along the start-of-step directions, x(s) = x − W J₀ᵀ s, rattle's Newton matrix J W J₀ᵀ is the
// derivative of −g(x(s)), g = (|d|² − l²)/2: solving with it turns column j of the differences into the unit
// vector.
TEST(RattleMatrix, IsTheDerivativeOfTheConstraints) {
  const Built built = build_valid([] {
    Description description = level_chain(7, 0.3);
    description.chains[0].length = 2.1;
    description.chains[0].to = {1.5, 0.2, 0.3};
    return description;
  }());
  LinkSystem system = make_link_system(built.model, solvable_links(built.model));
  const std::size_t count = system.links.size();
  Vectors start_direction, direction;
  link_vectors(system.links, built.start.position, start_direction);
  Vectors position = built.start.position;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-0.05, 0.05);
  for (std::size_t i = 1; i < position.size(); ++i)
    position.add(i, {shift(random), shift(random), shift(random)});
  link_vectors(system.links, position, direction);
  ASSERT_TRUE(system.matrix->factor(direction, start_direction, std::vector(count, 0.0)));
  constexpr double h = 1e-5;
  for (std::size_t j = 0; j < count; ++j) {
    const auto constraints = [&](double strength) {
      std::vector<double> s(count, 0.0);
      s[j] = -strength;
      Vectors moved = position, difference;
      apply_impulses(system.links, start_direction, s, moved);
      link_vectors(system.links, moved, difference);
      std::vector<double> g(count);
      for (std::size_t i = 0; i < count; ++i)
        g[i] = 0.5 * (difference.at(i).squaredNorm() - system.links.length[i] * system.links.length[i]);
      return g;
    };
    const std::vector<double> after = constraints(h), before = constraints(-h);
    std::vector<double> column(count);
    for (std::size_t i = 0; i < count; ++i) column[i] = -(after[i] - before[i]) / (2.0 * h);
    system.matrix->solve(column);
    for (std::size_t i = 0; i < count; ++i) EXPECT_NEAR(column[i], i == j ? 1.0 : 0.0, 1e-7) << i << " " << j;
  }
}

// The equation that backward Euler solves, F(x₁) = 0 with forces from spring_forces(), holds after a step.
TEST(SpringImplicit, StepSolvesBackwardEuler) {
  for (const bool taut : {true, false}) {
    const Built built = shaken_sheet(taut, springy(2.0));
    const double h = 1.0 / 50.0;
    State state = built.start;
    const StepReport report = simulate(built.model, state, settings("spring-implicit", 50.0), 1).counts;
    ASSERT_EQ(report.status, StepStatus::done);
    EXPECT_EQ(report.halvings, 0);
    const Vectors forces = spring_forces(built, state.position, state.velocity);
    for (std::size_t i = 0; i < forces.size(); ++i) {
      if (built.model.masses.pinned(i)) continue;
      const double mass = built.model.masses.mass[i];
      const Vec3 moved = state.position.at(i) - built.start.position.at(i);
      const Vec3 defect = (1.0 + h * built.model.drag) * mass * moved -
                          h * mass * built.start.velocity.at(i) -
                          h * h * (mass * built.model.gravity + forces.at(i));
      EXPECT_LT(defect.norm() / mass, 1e-11) << "mass " << i;
    }
  }
}

// With every spring stretched and none damped its matrix is the exact Jacobian, and Newton's method doubles
// the digits: from centimetres to rounding in a handful of rounds.
TEST(SpringImplicit, NewtonConvergesQuadraticallyWhereAllIsTaut) {
  const Built built = shaken_sheet(true, springy(0.0));
  State state = built.start;
  EXPECT_LE(simulate(built.model, state, settings("spring-implicit", 100.0), 1).counts.rounds, 6);
}

// What newton solves in every link: C − α̃λ + γ n·(d − d₀) = 0 with λ = h²·tension.
TEST(Newton, StepSolvesItsCompliantLengths) {
  const Built built = shaken_sheet(false, springy(2.0));
  const double h = 1.0 / 200.0;
  State state = built.start;
  const StepReport report = simulate(built.model, state, settings("newton", 200.0), 1).counts;
  ASSERT_EQ(report.status, StepStatus::done);
  EXPECT_EQ(report.halvings, 0);
  for (const Index link : solvable_links(built.model)) {
    const Index a = built.model.links.a[link], b = built.model.links.b[link];
    const Vec3 d = state.position.at(a) - state.position.at(b);
    const Vec3 moved = d - (built.start.position.at(a) - built.start.position.at(b));
    const double pull =
        200.0 * (d.norm() - built.model.links.length[link]) + 2.0 * d.normalized().dot(moved) / h;
    EXPECT_NEAR(state.tension[link], pull, 1e-8) << "link " << link;
  }
}

}  // namespace
}  // namespace taut::test
