// Joints that resist: damping and Coulomb friction against what their formulas give.

#include "fixtures.h"
#include "model/measures.h"

namespace taut::test {
namespace {

// A limb on a pinned shoulder that turns about z: a rigid tetrahedron of the shoulder, two elbows and a hand.
// Its joint only sees the hand, so that the elbows' share of the inertia has to come through the links.
constexpr double length = 0.6;                       // m
constexpr double hand_mass = 1.3, elbow_mass = 1.0;  // kg, of each
constexpr Index hand_index = 6;
constexpr double limb_inertia = hand_mass * length * length + 2.0 * elbow_mass * (0.09 + 0.01);  // kg m²
constexpr double level_torque = 9.81 * (hand_mass * length + 2.0 * elbow_mass * 0.3);            // N m
constexpr double start_rate = 2.0;                                                               // rad/s

Built limb(double damping, double friction, double rate, const Vec3& gravity = Vec3::Zero()) {
  Description description;
  description.gravity = gravity;
  const auto mass = [&](const char* name, const Vec3& at, double kilograms) {
    MassSpec spec;
    spec.name = name;
    spec.position = at;
    spec.pinned = kilograms == 0.0;
    if (!spec.pinned) {
      spec.mass = kilograms;
      spec.velocity = rate * Vec3::UnitZ().cross(at);
    }
    description.masses.push_back(spec);
  };
  mass("trunk", {-0.5, 0.0, 0.0}, 0.0);
  mass("shoulder", {0.0, 0.0, 0.0}, 0.0);
  mass("axis_back", {0.0, 0.0, -0.2}, 0.0);
  mass("axis_front", {0.0, 0.0, 0.2}, 0.0);
  mass("elbow_back", {0.3, -0.1, -0.2}, elbow_mass);
  mass("elbow_front", {0.3, -0.1, 0.2}, elbow_mass);
  mass("hand", {length, 0.0, 0.0}, hand_mass);
  const std::array corners{"shoulder", "elbow_back", "elbow_front", "hand"};
  for (std::size_t a = 0; a < corners.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) description.links.push_back({corners[a], corners[b], {}, {}});
  Built built = build_valid(description);
  built.model.joints = {{JointKind::hinge, {0, 1, hand_index, 2, 3}, damping, friction}};
  built.start.static_friction.joints.resize(1, Vec3::Zero());
  return built;
}

double angle_of(const State& state) {
  return std::atan2(state.position.y[hand_index], state.position.x[hand_index]);
}

double rate_of(const State& state) {
  return state.velocity.at(hand_index).norm() / length;
}

class JointMethods : public ::testing::TestWithParam<std::string> {};

// I ω' = −c ω:  the angle goes to ω₀ I/c as exp(−c t/I).
TEST_P(JointMethods, DampingSlowsALimbAtItsRateEverCloserWithTheStep) {
  constexpr double damping = 2.0, time = 0.5;  // N m s/rad, s
  const double exact = start_rate * limb_inertia / damping * (1.0 - std::exp(-damping * time / limb_inertia));
  std::vector<double> steps, errors;
  for (const double rate : {200.0, 800.0, 3200.0}) {
    const State end = run(limb(damping, 0.0, start_rate), settings(GetParam(), rate, 30.0), time);
    steps.push_back(1.0 / rate);
    errors.push_back(std::abs(angle_of(end) - exact) / exact);
  }
  EXPECT_LT(errors[1], 0.01);
  EXPECT_GT(observed_order(steps, errors), 0.8);
}

// I ω' = −τ:  it stops at t = I ω₀/τ, having turned by I ω₀²/(2 τ), and stays there.
TEST_P(JointMethods, CoulombFrictionStopsALimbInItsTimeAndOnItsWay) {
  constexpr double friction = 1.2;  // N m
  const double stop = limb_inertia * start_rate / friction;
  const Built built = limb(0.0, friction, start_rate);
  const Settings how = settings(GetParam(), 2000.0, 30.0);
  const auto at = [&](double share) { return run(built, how, std::round(share * stop * 2000.0) / 2000.0); };
  EXPECT_NEAR(rate_of(at(0.5)), 0.5 * start_rate, 0.01 * start_rate);
  EXPECT_GT(rate_of(at(0.98)), 0.005 * start_rate);
  const State end = at(1.05);
  EXPECT_LT(rate_of(end), 1e-5 * start_rate);
  EXPECT_NEAR(angle_of(end), 0.5 * limb_inertia * start_rate * start_rate / friction, 0.01 * angle_of(end));
}

// A joint that is loaded at once gives way by about h² τ/(β m L²), β = 0.2, and then by nothing more, however
// long.
TEST_P(JointMethods, FrictionHoldsWhatItCanHoldAndDoesNotCreep) {
  constexpr double rate = 600.0;
  const Settings how = settings(GetParam(), rate, 30.0);
  const Built holding = limb(0.0, 1.03 * level_torque, 0.0, {0.0, -9.81, 0.0});
  const State soon = run(holding, how, 0.5), late = run(holding, how, 5.0);
  const double give = level_torque / (rate * rate * 0.2 * hand_mass * length * length);
  EXPECT_LT(std::abs(angle_of(soon)), 2.0 * give);
  EXPECT_LT(std::abs(angle_of(late) - angle_of(soon)), 1e-7);
  const State falling = run(limb(0.0, 0.9 * level_torque, 0.0, {0.0, -9.81, 0.0}), how, 0.2);
  EXPECT_NEAR(-angle_of(falling), 0.5 * 0.1 * level_torque / limb_inertia * 0.04, 0.1 * -angle_of(falling));
}

// Thrown and spinning: what joints take from one part they give to the other. How methods keep angular
// momentum without joints is another matter; rattle keeps it to rounding.
TEST_P(JointMethods, AFreeBodyKeepsItsMomentum) {
  Description description;
  description.gravity = Vec3::Zero();
  RagdollSpec spec;
  spec.name = "doll";
  spec.velocity = {1.0, 2.0, 0.0};
  spec.spin = {3.0, 1.0, 2.0};
  spec.joint_damping = 3.0;
  spec.joint_friction = 0.2;
  description.ragdolls = {spec};
  const Built built = build_valid(description);
  const Vec3 before = linear_momentum(built.model, built.start);
  const Vec3 spin = angular_momentum(built.model, built.start);
  const State end = run(built, settings(GetParam(), 2400.0, 8.0), 0.5);
  EXPECT_LT((linear_momentum(built.model, end) - before).norm(), 1e-9 * before.norm());
  const double lost = (angular_momentum(built.model, end) - spin).norm() / spin.norm();
  EXPECT_LT(lost, GetParam() == "rattle" ? 1e-9 : 0.01);
}

// Its trunk held, its arms stretched out level: with a friction of 1 they would just stay.
TEST_P(JointMethods, AShareOfOneHoldsArmsOutLevel) {
  const auto sinks = [&](double share) {
    Description description;
    RagdollSpec spec;
    spec.name = "doll";
    spec.joint_friction = share;
    spec.pose.left_shoulder = spec.pose.right_shoulder = 90.0;
    spec.pose.left_shoulder_out = spec.pose.right_shoulder_out = 0.0;
    spec.pose.left_elbow = spec.pose.right_elbow = 0.0;
    spec.ranges.elbow = {0.0, 90.0};
    description.ragdolls = {spec};
    Built built = build_valid(description);
    const auto& names = built.model.masses.name;
    for (std::size_t i = 0; i < names.size(); ++i)
      for (const char* part : {"doll.left_shoulder", "doll.right_shoulder", "doll.left_hip", "doll.right_hip",
                               "doll.chest", "doll.back"})
        if (names[i] == part) built.model.masses.inverse_mass[i] = 0.0;
    const auto wrist =
        static_cast<std::size_t>(std::find(names.begin(), names.end(), "doll.left_wrist") - names.begin());
    const State end = run(built, settings(GetParam(), 2400.0, 8.0), 0.5);
    return built.start.position.y[wrist] - end.position.y[wrist];
  };
  EXPECT_LT(sinks(1.02), 0.002);
  EXPECT_GT(sinks(0.9), 0.02);
}

INSTANTIATE_TEST_SUITE_P(
    Registry, JointMethods,
    ::testing::ValuesIn(methods_that([](const Capabilities& can) { return can.joints; })), case_name);

}  // namespace
}  // namespace taut::test
