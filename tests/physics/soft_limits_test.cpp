// Limits with compliance: springs that push back with excess / compliance.

#include <Eigen/Dense>
#include <functional>
#include <numbers>

#include "fixtures.h"
#include "model/measures.h"
#include "stopped_pendulum.h"

namespace taut::test {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double stop = 20.0 * degree;
constexpr double soft_compliance = 0.01;  // rad/(N m)
constexpr double g = 9.81;                // m/s²

// 1 kg on an arm of 1 m, level at the start, that a limit of each kind meets 20 degrees below.
Description arm_on(LimitKind kind, double compliance) {
  const auto pin = [](std::string name, const Vec3& position) {
    MassSpec mass;
    mass.name = std::move(name);
    mass.position = position;
    mass.pinned = true;
    return mass;
  };
  Description description;
  MassSpec bob;
  bob.name = "bob";
  bob.position = {1.0, 0.0, 0.0};
  description.masses = {pin("far", {-1.0, 0.0, 0.0}), pin("joint", {0.0, 0.0, 0.0}),
                        pin("axle", {0.0, 0.0, 1.0}), bob};
  description.links = {LinkSpec{"joint", "bob", 1.0, {}}};
  AngleSpec angle;
  angle.masses = {"far", "joint", "bob"};
  angle.min = 160.0;
  angle.compliance = compliance;
  HingeSpec hinge;
  hinge.masses = {"far", "joint", "bob"};
  hinge.axis = {"joint", "axle"};
  hinge.min = -20.0;
  hinge.compliance = compliance;
  ConeSpec cone;
  cone.frame = {"joint", "far", "axle"};
  cone.limb = {"joint", "bob"};
  cone.axis = Vec3::UnitX();
  cone.half_angle = 20.0;
  cone.compliance = compliance;
  if (kind == LimitKind::angle) description.angles = {angle};
  if (kind == LimitKind::hinge) description.hinges = {hinge};
  if (kind == LimitKind::cone) description.cones = {cone};
  return description;
}

double below_level(const State& state) {
  return std::atan2(-state.position.y[3], state.position.x[3]);
}

template <class S>
S runge_kutta(S state, double time, int steps, const std::function<S(const S&)>& rate) {
  const double h = time / steps;
  for (int i = 0; i < steps; ++i) {
    const S a = rate(state), b = rate(state + 0.5 * h * a), c = rate(state + 0.5 * h * b),
            d = rate(state + h * c);
    state += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  return state;
}

// The arm's own equation, θ̈ = g cos θ − max(θ − stop, 0)/compliance, by itself.
double exact_arm(double time, int steps) {
  using S = Eigen::Vector2d;
  return runge_kutta<S>({0.0, 0.0}, time, steps, [](const S& s) -> S {
    return {s[1], g * std::cos(s[0]) - std::max(s[0] - stop, 0.0) / soft_compliance};
  })[0];
}

// The stopped pendulum with a soft stop: M q̈ = f − Gᵀ max(q₂ − q₁ − stop, 0)/compliance.
Vec3 exact_hand(double time, int steps) {
  using S = Eigen::Vector4d;
  const double half = 0.5 * std::numbers::pi;
  const S end = runge_kutta<S>({half, half, 0.0, 0.0}, time, steps, [](const S& s) -> S {
    const double sine = std::sin(s[0] - s[1]), cosine = std::cos(s[0] - s[1]);
    const double torque = std::max(s[1] - s[0] - 30.0 * degree, 0.0) / soft_compliance;
    const Eigen::Vector2d force(-sine * s[3] * s[3] - 2.0 * g * std::sin(s[0]) + torque,
                                sine * s[2] * s[2] - g * std::sin(s[1]) - torque);
    const Eigen::Matrix2d inertia{{2.0, cosine}, {cosine, 1.0}};
    const Eigen::Vector2d acceleration = inertia.inverse() * force;
    return {s[2], s[3], acceleration[0], acceleration[1]};
  });
  return {std::sin(end[0]) + std::sin(end[1]), -std::cos(end[0]) - std::cos(end[1]), 0.0};
}

// Of second order with rattle, of first with others; as near as the references are with dop853, whatever the
// rate.
void expect_convergence(const std::string& method, const std::vector<double>& steps,
                        const std::vector<double>& errors, double most) {
  SCOPED_TRACE(method);
  if (method == "dop853") {
    EXPECT_LT(errors.back(), 1e-9);
    return;
  }
  EXPECT_GT(observed_order(steps, errors), method == "rattle" ? 1.7 : 0.8)
      << errors.front() << " … " << errors.back();
  EXPECT_LT(errors.back(), most);
}

class SoftLimits : public ::testing::TestWithParam<std::tuple<std::string, LimitKind>> {
 protected:
  std::string method() const { return std::get<0>(GetParam()); }
  LimitKind kind() const { return std::get<1>(GetParam()); }
};

// The arm comes to rest where the excess is compliance × torque; where velocities hold half a kick drag takes
// its part of that, and relaxation leaves a rest: both go with the step.
TEST_P(SoftLimits, GiveWayByComplianceTimesTorque) {
  Description description = arm_on(kind(), soft_compliance);
  description.drag = 20.0;
  const Built built = build_valid(description);
  std::vector<double> errors;
  for (const double rate : {250.0, 1000.0}) {
    const double excess = below_level(run(built, settings(method(), rate, 20.0), 4.0)) - stop;
    errors.push_back(std::abs(excess - soft_compliance * g * std::cos(stop + excess)));
  }
  if (method() == "rattle" || method() == "newton" || method() == "dop853") {
    EXPECT_LT(errors[0], 1e-7) << "rad";
    EXPECT_LT(errors[1], 1e-7) << "rad";
  } else {
    EXPECT_LT(errors[1], 0.3 * errors[0]) << "rad";
    EXPECT_LT(errors[1], 2e-3) << "rad";
  }
}

// It swings against the limit, is thrown back and swings again.
TEST_P(SoftLimits, ASwingConvergesToTheReference) {
  constexpr double duration = 0.75;  // s: the arm meets the limit at 0.27 s
  const double exact = exact_arm(duration, 100000);
  ASSERT_NEAR(exact_arm(duration, 50000), exact, 1e-9) << "the reference";
  const Built built = build_valid(arm_on(kind(), soft_compliance));
  std::vector<double> steps, errors;
  for (const double rate : {1000.0, 2000.0, 4000.0, 8000.0}) {
    const State end = run(built, settings(method(), rate, 20.0), duration);
    steps.push_back(1.0 / rate);
    errors.push_back(std::abs(below_level(end) - exact));
  }
  expect_convergence(method(), steps, errors, 0.02);
}

// Both bodies at the joint are free to move.
TEST_P(SoftLimits, ALimitBetweenMovingBodiesConvergesToTheReference) {
  if (kind() != LimitKind::angle) GTEST_SKIP() << "the reference is for the angle alone";
  constexpr double duration = 0.75;  // s
  const Vec3 exact = exact_hand(duration, 100000);
  ASSERT_LT((exact_hand(duration, 50000) - exact).norm(), 1e-9) << "the reference";
  Description description = stopped_pendulum();
  description.angles[0].compliance = soft_compliance;
  const Built built = build_valid(description);
  std::vector<double> steps, errors;
  for (const double rate : {1000.0, 2000.0, 4000.0, 8000.0}) {
    const State end = run(built, settings(method(), rate, 20.0), duration);
    steps.push_back(1.0 / rate);
    errors.push_back((end.position.at(2) - exact).norm());
  }
  expect_convergence(method(), steps, errors, 0.02);
}

// Far too stiff for the step: it must hold as a stop does, and not throw anything back harder than it came.
TEST_P(SoftLimits, NearlyHardOnesHoldAtLongSteps) {
  const Built built = build_valid(arm_on(kind(), 1e-9));
  State state = built.start;
  for (int frame = 0; frame < 40; ++frame) {
    const Built now{built.model, state, {}};
    state = run(now, settings(method(), 250.0, 20.0), 0.04);
    EXPECT_LT(below_level(state) - stop, degree) << "at " << state.time << " s";
    EXPECT_LT(energy(built.model, state).kinetic, 1.1 * g * std::sin(stop)) << "at " << state.time << " s";
  }
}

std::string soft_case_name(const ::testing::TestParamInfo<std::tuple<std::string, LimitKind>>& each) {
  const LimitKind kind = std::get<1>(each.param);
  return std::get<0>(each.param) + (kind == LimitKind::angle   ? "_angle"
                                    : kind == LimitKind::hinge ? "_hinge"
                                                               : "_cone");
}

INSTANTIATE_TEST_SUITE_P(Registry, SoftLimits,
                         ::testing::Combine(::testing::ValuesIn(limit_methods()),
                                            ::testing::Values(LimitKind::angle, LimitKind::hinge,
                                                              LimitKind::cone)),
                         soft_case_name);

// What goes into the limit comes out of it again.
TEST(SoftLimitEnergy, IsKeptByRattle) {
  const Built built = build_valid(arm_on(LimitKind::angle, soft_compliance));
  const double before = energy(built.model, built.start).total();
  double deepest = 0.0;
  State state = built.start;
  for (int frame = 0; frame < 30; ++frame) {
    const Built now{built.model, state, {}};
    state = run(now, settings("rattle", 2000.0), 0.05);
    const Energy has = energy(built.model, state);
    deepest = std::max(deepest, has.elastic);
    EXPECT_NEAR(has.total(), before, 2e-3) << "J at " << state.time << " s";
  }
  EXPECT_GT(deepest, 0.5) << "J in the limit: it was never reached";
}

// A range of one angle is a spring to both sides: θ̈ = g cos θ − θ/compliance.
TEST(SoftLimitSpring, SwingsAboutARangeOfOneAngle) {
  using S = Eigen::Vector2d;
  const double exact = runge_kutta<S>({0.0, -2.0}, 0.6, 100000, [](const S& s) -> S {
    return {s[1], g * std::cos(s[0]) - s[0] / soft_compliance};
  })[0];
  Description description = arm_on(LimitKind::hinge, soft_compliance);
  description.hinges[0].min = description.hinges[0].max = 0.0;
  description.masses[3].velocity = {0.0, 2.0, 0.0};
  const Built built = build_valid(description);
  for (const std::string& method : limit_methods()) {
    std::vector<double> steps, errors;
    for (const double rate : {1000.0, 2000.0, 4000.0, 8000.0}) {
      steps.push_back(1.0 / rate);
      errors.push_back(std::abs(below_level(run(built, settings(method, rate, 10.0), 0.6)) - exact));
    }
    expect_convergence(method, steps, errors, 5e-3);
  }
}

}  // namespace
}  // namespace taut::test
