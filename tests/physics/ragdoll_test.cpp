// The ragdoll: its body against Winter's table, and how it moves.

#include "fixtures.h"
#include "frames/simulation.h"
#include "model/anthropometry.h"
#include "model/measures.h"
#include "scenes_of_the_program.h"

namespace taut::test {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

// Upright, arms hanging, every joint straight.
RagdollSpec standing() {
  RagdollSpec spec;
  spec.name = "doll";
  spec.height = 1.8;
  spec.mass = 80.0;
  spec.position = {0.3, winter::hip_height * 1.8, -0.2};
  spec.ranges.knee = {-90.0, 0.0};
  spec.ranges.elbow = {0.0, 90.0};
  spec.pose = {};
  spec.pose.left_shoulder_out = spec.pose.right_shoulder_out = 0.0;
  spec.pose.left_elbow = spec.pose.right_elbow = 0.0;
  spec.pose.left_hip = spec.pose.right_hip = spec.pose.left_hip_out = spec.pose.right_hip_out = 0.0;
  spec.pose.left_knee = spec.pose.right_knee = 0.0;
  return spec;
}

Built build_doll(const RagdollSpec& spec) {
  Description description;
  description.ragdolls = {spec};
  return build_valid(description);
}

Vec3 place(const Built& built, const std::string& name) {
  const auto& names = built.model.masses.name;
  const auto found = std::find(names.begin(), names.end(), "doll." + name);
  EXPECT_NE(found, names.end()) << name;
  return built.start.position.at(static_cast<std::size_t>(found - names.begin()));
}

Vec3 joint(const Built& built, const std::string& name) {
  return 0.5 * (place(built, name + ".left") + place(built, name + ".right"));
}

TEST(Winter, SharesOfMassSumToOne) {
  using namespace winter;
  const double limbs = upper_arm.mass + forearm.mass + hand.mass + thigh.mass + shank.mass + foot.mass;
  EXPECT_NEAR(2.0 * limbs + trunk.mass + head_and_neck.mass, 1.0, 1e-12);
  EXPECT_NEAR(ankle_height + shank.length + thigh.length, hip_height, 1e-12);
  EXPECT_NEAR(hip_height + trunk.length, shoulder_height, 1e-12);
}

TEST(Ragdoll, HasTheGivenMass) {
  const Built built = build_doll(standing());
  double sum = 0.0;
  for (const double mass : built.model.masses.mass) {
    sum += mass;
    EXPECT_GT(mass, 0.1);
  }
  EXPECT_NEAR(sum, 80.0, 1e-12 * 80.0);
}

TEST(Ragdoll, HasTheLengthsOfTheTable) {
  const Built built = build_doll(standing());
  for (const std::string side : {"left_", "right_"}) {
    const auto share = [&](const Vec3& a, const Vec3& b) { return (a - b).norm() / 1.8; };
    const Vec3 shoulder = place(built, side + "shoulder"), wrist = place(built, side + "wrist"),
               hip = place(built, side + "hip"), ankle = place(built, side + "ankle");
    EXPECT_NEAR(share(shoulder, joint(built, side + "elbow")), winter::upper_arm.length, 1e-12);
    EXPECT_NEAR(share(joint(built, side + "elbow"), wrist), winter::forearm.length, 1e-12);
    EXPECT_NEAR(share(wrist, place(built, side + "hand")), winter::hand.length, 1e-12);
    EXPECT_NEAR(share(hip, joint(built, side + "knee")), winter::thigh.length, 1e-12);
    EXPECT_NEAR(share(joint(built, side + "knee"), ankle), winter::shank.length, 1e-12);
    EXPECT_NEAR(share(ankle, place(built, side + "toe")), winter::foot.length, 1e-12);
    EXPECT_NEAR(ankle.y() / 1.8, winter::ankle_height, 1e-12);
    EXPECT_NEAR(shoulder.y() / 1.8, winter::shoulder_height, 1e-12);
  }
}

TEST(Ragdoll, HasTheGivenHeight) {
  const Built built = build_doll(standing());
  double low = infinity, high = -infinity;
  for (const Bone& bone : built.model.bones)
    for (const Index mass : {bone.from[0], bone.from[1], bone.to[0], bone.to[1]}) {
      low = std::min(low, built.start.position.y[mass] - bone.radius);
      high = std::max(high, built.start.position.y[mass] + bone.radius);
    }
  EXPECT_NEAR(low, 0.0, 1e-12);
  EXPECT_NEAR(high, 1.8, 1e-12);
}

// Standing straight, each segment's centre of mass lies at its share of the way from its upper end.
TEST(Ragdoll, HasItsCentreOfMassWhereTheTablePutsIt) {
  using namespace winter;
  const auto below = [](double top, const Segment& segment) {
    return segment.mass * (top - segment.centre * segment.length);
  };
  double height = trunk.mass * (hip_height + (1.0 - trunk.centre) * trunk.length) +
                  head_and_neck.mass * (shoulder_height + head_and_neck.centre * head_and_neck.length);
  double top = shoulder_height;
  for (const Segment& segment : {upper_arm, forearm, hand}) {
    height += 2.0 * below(top, segment);
    top -= segment.length;
  }
  top = hip_height;
  for (const Segment& segment : {thigh, shank}) {
    height += 2.0 * below(top, segment);
    top -= segment.length;
  }
  const double drop = ankle_height - 0.025;
  height += 2.0 * foot.mass * (ankle_height - foot.centre * drop);
  const double forward = 2.0 * foot.mass * foot.centre * std::sqrt(foot.length * foot.length - drop * drop);
  const Built built = build_doll(standing());
  const Vec3 centre = centre_of_mass(built.model, built.start) - Vec3(0.3, 0.0, -0.2);
  EXPECT_NEAR(centre.x() / 1.8, 0.0, 1e-12);
  EXPECT_NEAR(centre.y() / 1.8, height, 1e-12);
  EXPECT_NEAR(centre.z() / 1.8, forward, 1e-12);
  EXPECT_NEAR(height, 0.56, 0.02) << "of adults it is known to lie at 55 to 57 percent of the height";
}

TEST(Ragdoll, PosesBendJointsByTheirAngles) {
  RagdollSpec spec = standing();
  spec.pose.left_shoulder = 90.0;
  spec.pose.left_elbow = 60.0;
  spec.pose.right_hip = 45.0;
  spec.pose.right_knee = -70.0;
  spec.pose.neck = -30.0;
  const Built built = build_doll(spec);
  EXPECT_NEAR((joint(built, "left_elbow") - place(built, "left_shoulder")).normalized().z(), 1.0, 1e-12)
      << "forward";
  const Vec3 forearm = (place(built, "left_wrist") - joint(built, "left_elbow")).normalized();
  EXPECT_NEAR(std::atan2(forearm.y(), forearm.z()) * degrees, 60.0, 1e-9) << "upwards from there";
  const Vec3 shank = (place(built, "right_ankle") - joint(built, "right_knee")).normalized();
  EXPECT_NEAR(std::atan2(-shank.z(), -shank.y()) * degrees, 25.0, 1e-9) << "backwards";
  EXPECT_GT(place(built, "head").z(), -0.2) << "a nod goes forward";
  std::vector<double> bends;
  for (const Limit& limit : built.model.limits)
    if (limit.kind == LimitKind::hinge) bends.push_back(limit_angle(limit, built.start.position) * degrees);
  ASSERT_EQ(bends.size(), 5U);
  EXPECT_NEAR(bends[0], -30.0, 1e-9) << "neck";
  EXPECT_NEAR(bends[1], 60.0, 1e-9) << "left elbow";
  EXPECT_NEAR(bends[4], -70.0, 1e-9) << "right knee";
}

TEST(Ragdoll, StartsWithinItsLimitsAndWholeWhateverItsTurn) {
  RagdollSpec spec;
  spec.name = "doll";
  spec.turn = {30.0, -70.0, 110.0};
  spec.velocity = {1.0, 2.0, 3.0};
  spec.spin = {0.0, 4.0, 0.0};
  const Built built = build_doll(spec);
  EXPECT_EQ(largest_limit_excess(built.model, built.start), 0.0);
  EXPECT_EQ(link_strain(built.model, built.start).largest, 0.0);
  EXPECT_LT((linear_momentum(built.model, built.start) / 75.0 - spec.velocity).norm(), 1e-12);
}

TEST(Ragdoll, APoseOutsideItsRangesIsAProblemWithItsJoint) {
  RagdollSpec spec = standing();
  spec.pose.left_knee = 10.0;
  Description description;
  description.ragdolls = {spec};
  const std::vector<Problem> problems = build(description).problems;
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].section, "ragdoll");
  EXPECT_EQ(problems[0].key, "pose.left_knee");
  EXPECT_EQ(problems[0].message, "left_knee starts 10 degrees outside the range of knee, -90 to 0 degrees");
}

// Thrown without gravity: no limb goes beyond its limits, nothing comes apart, momentum stays.
TEST(Ragdoll, TumblesFreelyAsOneBody) {
  RagdollSpec spec;
  spec.name = "doll";
  spec.velocity = {1.0, 2.0, 0.0};
  spec.spin = {6.0, 1.0, 3.0};
  Description description;
  description.gravity = Vec3::Zero();
  description.ragdolls = {spec};
  const Built built = build_valid(description);
  const State end = run(built, settings("xpbd", 2400.0, 3.0), 2.0);
  EXPECT_LT(largest_limit_excess(built.model, end) * degrees, 1.0);
  EXPECT_LT(link_strain(built.model, end).largest, 0.01);
  const Vec3 before = linear_momentum(built.model, built.start);
  EXPECT_LT((linear_momentum(built.model, end) - before).norm(), 1e-9 * before.norm());
}

// Friction holds contacts and joints from one step to the next: a run that is taken up again has to know.
TEST(Ragdoll, ARunTakenUpAgainIsTheSameToTheLastBit) {
  Scene scene = scene_called("ragdoll-pile");
  Built built{scene.model, scene.start, {}};
  built.start = run(built, settings("xpbd", 2400.0, 2.0), 1.0);
  EXPECT_FALSE(built.start.static_friction.bodies.empty());
  EXPECT_FALSE(built.start.static_friction.solids.empty());
  const State whole = run(built, settings("xpbd", 2400.0, 2.0), 0.25);
  built.start = run(built, settings("xpbd", 2400.0, 2.0), 0.125);
  EXPECT_EQ(state_hash(run(built, settings("xpbd", 2400.0, 2.0), 0.125)), state_hash(whole));
}

class HoldingMethods : public ::testing::TestWithParam<std::string> {};

// A body that lies on a slope of 25 degrees; friction could hold it up to 31.
TEST_P(HoldingMethods, ABodyOnASlopeDoesNotCreepWhereFrictionHoldsIt) {
  Description description;
  RagdollSpec spec;
  spec.name = "doll";
  spec.turn = {-90.0, 0.0, 25.0};
  spec.position = {0.0, 0.25, 0.0};
  spec.joint_damping = 2.0;
  spec.joint_friction = 0.1;
  description.ragdolls = {spec};
  PlaneSpec slope;
  slope.normal = {-std::sin(25.0 / degrees), std::cos(25.0 / degrees), 0.0};
  slope.friction = 0.6;
  description.planes = {slope};
  const Built built = build_valid(description);
  for (const double passes : {1.0, 4.0}) {
    const Settings how = settings(GetParam(), 1200.0, passes);
    const Built settled{built.model, run(built, how, 5.0), {}};
    const Built later{built.model, run(settled, how, 5.0), {}};
    for (const char* part : {"left_shoulder", "right_shoulder", "left_hip", "right_hip", "back"})
      EXPECT_LT((place(later, part) - place(settled, part)).norm(), 1e-6)
          << part << ", m in 5 s, passes: " << passes;
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, HoldingMethods,
                         ::testing::ValuesIn(methods_that([](const Capabilities& can) {
                           return can.limits && can.colliders;
                         })),
                         case_name);

class RagdollScenes : public ::testing::TestWithParam<std::string> {};

TEST_P(RagdollScenes, EveryFrameKeepsLimitsJointsAndGround) {
  const Scene scene = scene_called(GetParam());
  Simulation simulation(scene);
  constexpr double frames_per_second = 30.0;
  double excess = 0.0, depth = 0.0, strain = 0.0;
  for (int frame = 0; frame <= static_cast<int>(scene.duration * frames_per_second); ++frame) {
    const State state = *simulation.at(frame / frames_per_second);
    excess = std::max(excess, largest_limit_excess(scene.model, state));
    depth = std::max(depth, deepest_penetration(scene.model, state));
    strain = std::max(strain, link_strain(scene.model, state).largest);
  }
  EXPECT_LT(excess * degrees, 1.0) << "beyond a limit, degrees";
  EXPECT_LT(depth, 1e-3) << "inside a solid, m";
  EXPECT_LT(strain, 0.05) << "of a link";
}

INSTANTIATE_TEST_SUITE_P(Folder, RagdollScenes,
                         ::testing::Values("ragdoll-drop", "ragdoll-hang", "ragdoll-pile"),
                         [](const auto& each) {
                           std::string name = each.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// What few passes leave of an impact is not made good by short steps: at a quarter of a second, after the
// feet have slid on the landing, one pass a step is more than a hundredth of the scene's size away from what
// many passes agree on, however short the steps.
TEST(Impacts, OfOnePassAStepConvergeToAnotherMotion) {
  const Scene scene = scene_called("ragdoll-drop");
  const Built built{scene.model, scene.start, {}};
  const auto end = [&](double passes, double rate) {
    return run(built, settings("verlet", rate, passes), 0.25);
  };
  const auto apart = [&](const State& a, const State& b) {
    return position_error(a, b) / scene_size(scene.model, scene.start);
  };
  const State many = end(64.0, 30720.0);
  EXPECT_LT(apart(many, end(16.0, 30720.0)), 2e-3);
  EXPECT_LT(apart(many, end(64.0, 15360.0)), 2e-3);
  for (const double rate : {15360.0, 30720.0, 61440.0}) EXPECT_GT(apart(many, end(1.0, rate)), 1e-2) << rate;
}

}  // namespace
}  // namespace taut::test
