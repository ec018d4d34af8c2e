// Momentum of free bodies, energy over many periods, and velocities at driven pins.

#include <numbers>

#include "fixtures.h"
#include "methods/projected_velocities.h"
#include "model/measures.h"
#include "scenes_of_the_program.h"

namespace taut::test {
namespace {

// Three unequal masses on cords from a light knot, spinning and drifting without gravity.
Description bola() {
  Description description;
  description.gravity = Vec3::Zero();
  const Vec3 drift(0.4, -0.3, 0.2), turning(1.0, 2.0, 6.0);  // m/s, rad/s
  const auto add = [&](const std::string& name, const Vec3& position, double mass) {
    MassSpec spec;
    spec.name = name;
    spec.position = position;
    spec.velocity = drift + turning.cross(position);
    spec.mass = mass;
    description.masses.push_back(spec);
    if (name != "knot") description.links.push_back(LinkSpec{"knot", name, std::nullopt, {}});
  };
  add("knot", Vec3::Zero(), 0.1);
  add("one", {0.8, 0.0, 0.1}, 0.3);
  add("two", {-0.5, 0.6, -0.1}, 0.4);
  add("three", {-0.3, -0.7, 0.0}, 0.5);
  return description;
}

constexpr double flight = 0.5;                             // s, about half a turn
constexpr double coarse_rate = 960.0, fine_rate = 1920.0;  // steps/s

// What half the step does to an error of first order.
void expect_halved(double at_coarse, double at_fine) {
  EXPECT_GT(at_coarse, 1e-4) << "nothing is lost that could be halved";
  EXPECT_NEAR(at_coarse / at_fine, 2.0, 0.2) << at_coarse << " and " << at_fine;
}

void expect_as_said(Keeping keeping, double at_coarse, double at_fine) {
  switch (keeping) {
    case Keeping::kept:
      EXPECT_LT(at_coarse, 1e-10);
      EXPECT_LT(at_fine, 1e-10);
      break;
    case Keeping::within_tolerance:
      EXPECT_LT(at_fine, 1e-6);
      break;
    case Keeping::lost_with_step:
      expect_halved(at_coarse, at_fine);
      break;
    case Keeping::not_kept:
      EXPECT_GT(at_fine, 0.01);
      EXPECT_GT(at_fine, 0.9 * at_coarse) << "half the step would mend it";
      break;
  }
}

class Conserving : public ::testing::TestWithParam<std::string> {
 protected:
  const Capabilities& can() const { return find_method(GetParam())->can; }

  Built build_for_method(Description description, double stiffness) const {
    if (!can().rigid)
      for (LinkSpec& link : description.links) link.properties.stiffness = stiffness;
    return build_valid(description);
  }

  // Share of the angular momentum about the centre that is lost or gained.
  double spin_error(double rate) const {
    const Built built = build_for_method(bola(), 1e4);
    const State end = run(built, settings(GetParam(), rate, 20.0), flight);
    return (spin(built.model, end) - spin(built.model, built.start)).norm() /
           spin(built.model, built.start).norm();
  }

  // How far the centre of the masses is from where its momentum would have taken it, as a share of the way:
  // velocities alone would hide masses that are moved whatever they weigh.
  double course_error(double rate) const {
    const Built built = build_for_method(bola(), 1e4);
    const State end = run(built, settings(GetParam(), rate, 20.0), flight);
    const Vec3 way = linear_momentum(built.model, built.start) * (flight / free_mass(built.model));
    return (centre_of_mass(built.model, end) - centre_of_mass(built.model, built.start) - way).norm() /
           way.norm();
  }

  // Energy of the pendulum, as a share of its scale, at every eighth of a second.
  std::vector<double> energies(double rate, double duration) const {
    const Built built = build_for_method(pendulum(), 2000.0);
    State state = built.start;
    std::vector<double> shares;
    for (double time = 0.125; time <= duration; time += 0.125) {
      EXPECT_EQ(simulate(built.model, state, settings(GetParam(), rate, 20.0), std::llround(0.125 * rate))
                    .counts.status,
                StepStatus::done);
      State shown = state;
      if (can().half_kicked) shown.velocity = projected_velocities(built.model, state);
      shares.push_back((energy(built.model, shown).total() - energy(built.model, built.start).total()) /
                       energy_scale(built.model, built.start));
    }
    return shares;
  }
};

TEST_P(Conserving, LinearMomentumAsItsCapabilitySays) {
  expect_as_said(can().keeps.linear_momentum, course_error(coarse_rate), course_error(fine_rate));
}

TEST_P(Conserving, AngularMomentumAsItsCapabilitySays) {
  expect_as_said(can().keeps.angular_momentum, spin_error(coarse_rate), spin_error(fine_rate));
}

// Where energy is kept it may swing, but not farther after many periods than in the first ones.
TEST_P(Conserving, EnergyAsItsCapabilitySays) {
  const Keeping keeping = can().keeps.energy;
  if (keeping == Keeping::within_tolerance) {
    const double loose = std::abs(energies(60.0, 40.0).back()),
                 tight = std::abs(energies(120.0, 40.0).back());
    EXPECT_LT(tight, 0.05 * loose) << "a tolerance 256 times as tight";
    EXPECT_LT(tight, 1e-3);
    return;
  }
  if (keeping != Keeping::kept) {
    expect_as_said(keeping, std::abs(energies(coarse_rate, 1.0).back()),
                   std::abs(energies(fine_rate, 1.0).back()));
    return;
  }
  const std::vector<double> shares = energies(coarse_rate, 40.0);
  const auto largest = [](auto begin, auto end) {
    double most = 0.0;
    for (; begin != end; ++begin) most = std::max(most, std::abs(*begin));
    return most;
  };
  const auto begin = shares.begin(), end = shares.end();
  const double first = largest(begin, begin + 80), last = largest(end - 80, end);  // 10 s, four periods
  EXPECT_LT(first, 0.01);
  EXPECT_LT(last, 1.5 * first) << "a loss that goes on would be four times as large";
}

INSTANTIATE_TEST_SUITE_P(Registry, Conserving, ::testing::ValuesIn(every_method()), case_name);

// The scene of the documents: what is left of the spin after 3 s.
TEST(Bola, SpinsOnWithMethodsThatKeepIt) {
  const Scene scene = scene_called("bola");
  ASSERT_TRUE(flies_freely(scene.model));
  const Built built{scene.model, scene.start, {}};
  const auto share_left = [&](const std::string& method) {
    const State end = run(built, settings(method, 600.0), scene.duration);
    return spin(built.model, end).norm() / spin(built.model, built.start).norm();
  };
  EXPECT_NEAR(share_left("rattle"), 1.0, 1e-10);
  EXPECT_NEAR(share_left("shake"), 1.0, 1e-10);
  EXPECT_LT(share_left("xpbd"), 0.9);
  EXPECT_LT(share_left("newton"), 0.9);
}

// The largest energy error over the last 10 of 1000 periods is no larger than over the first 10, but for
// rounding.
TEST(Rattle, EnergyDoesNotDriftOverAThousandPeriods) {
  const Built built = build_valid(pendulum());
  const double at_start = energy(built.model, built.start).total();
  State state = built.start;
  const auto worst_of_ten_periods = [&] {
    double worst = 0.0;
    for (int step = 0; step < 2368; ++step) {
      EXPECT_EQ(simulate(built.model, state, settings("rattle", 100.0), 1).end, RunEnd::none);
      worst = std::max(worst, std::abs(energy(built.model, state).total() - at_start));
    }
    return worst;
  };
  const double first = worst_of_ten_periods();
  EXPECT_EQ(simulate(built.model, state, settings("rattle", 100.0), 236800 - 2 * 2368).end, RunEnd::none);
  EXPECT_LT(worst_of_ten_periods(), 1.05 * first);
}

// A link's end must move along with a pin that is driven fast: d·(v_bob − v_pin) = 0 with the pin's exact
// velocity.
TEST(Rattle, VelocitiesMeetAFastPin) {
  Description description = pendulum();
  description.masses[0].motion.sinusoid =
      SinusoidSpec{{0.05, 0.1, 0.0}, 60.0, 0.5 * std::numbers::pi};  // from rest
  const Built built = build_valid(description);
  const State end = run(built, settings("rattle", 4000.0), 0.5);
  const Vec3 pin = velocity_at(built.model.driven_pins[0].motion, 0.5);
  EXPECT_GT(pin.norm(), 1.0);
  const Vec3 d = end.position.at(1) - end.position.at(0);
  EXPECT_NEAR(d.dot(end.velocity.at(1) - pin), 0.0, 1e-11);
}

}  // namespace
}  // namespace taut::test
