// What turns at a joint, and that its resistance is made of pairs.

#include "model/joints.h"

#include <gtest/gtest.h>

#include <random>

#include "contact/joint_resistance.h"

namespace taut {
namespace {

// A limb from mass 3 to the middle of 4 and 5 in the frame of 0, 1 and 2; for a hinge: 0, 3, 4 about 1 – 2.
Vectors places() {
  Vectors x;
  for (const Vec3& at : {Vec3(0.1, 0.2, -0.1), Vec3(0.5, 0.1, 0.0), Vec3(0.0, 0.7, 0.2), Vec3(0.2, -0.1, 0.1),
                         Vec3(0.3, -0.6, 0.2), Vec3(0.2, -0.5, 0.5)})
    x.push_back(at);
  return x;
}

Eigen::Vector2d rates(const Joint& joint, const Vectors& x, const Vectors& v) {
  const JointAngles angles = joint_angles(joint, x);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (std::size_t k = 0; k < angles.count; ++k) {
    const LimitAngle along = limit_gradients(angles.angles[k], x);
    for (std::size_t i = 0; i < angles.angles[k].count; ++i)
      sum[static_cast<Eigen::Index>(k)] += along.gradient[i].dot(v.at(angles.angles[k].masses[i]));
  }
  return sum;
}

// The limb's masses turn by ω about its near end while the frame turns by another rate.
Vectors turning(const Vectors& x, const Vec3& frame, const Vec3& limb) {
  Vectors v;
  for (std::size_t i = 0; i < 4; ++i) v.push_back(frame.cross(x.at(i)));
  for (std::size_t i = 4; i < 6; ++i) v.push_back(frame.cross(x.at(i)) + limb.cross(x.at(i) - x.at(3)));
  return v;
}

TEST(JointAngles, ASwingIsTheRateAcrossTheLimb) {
  const Vectors x = places();
  const Joint joint{JointKind::swing, {0, 1, 2, 3, 4, 5}, 0.0, 0.0};
  const Vec3 limb = (0.5 * (x.at(4) + x.at(5)) - x.at(3)).normalized();
  const Vec3 turn(0.7, -0.4, 1.1);
  const Vec3 across = turn - turn.dot(limb) * limb;
  EXPECT_NEAR(rates(joint, x, turning(x, {0.3, 2.0, -1.0}, turn)).norm(), across.norm(), 1e-12);
  EXPECT_NEAR(rates(joint, x, turning(x, {0.3, 2.0, -1.0}, 3.0 * limb)).norm(), 0.0, 1e-12);
}

TEST(JointAngles, ATwistIsTheRateAboutTheLimb) {
  Vectors x = places();
  const Vec3 limb(0.0, -1.0, 0.0), width(0.1, 0.0, 0.05);  // at right angles, as in an elbow
  x.set(4, x.at(3) + 0.5 * limb - width);
  x.set(5, x.at(3) + 0.5 * limb + width);
  const Joint joint{JointKind::twist, {0, 1, 2, 3, 4, 5}, 0.0, 0.0};
  EXPECT_NEAR(rates(joint, x, turning(x, {0.3, 2.0, -1.0}, 1.7 * limb)).norm(), 1.7, 1e-12);
  EXPECT_NEAR(rates(joint, x, turning(x, {0.3, 2.0, -1.0}, limb.cross(width))).norm(), 0.0, 1e-12);
}

TEST(JointAngles, AHingeIsTheRateAboutItsAxis) {
  const Vectors x = places();
  const Joint joint{JointKind::hinge, {0, 3, 4, 1, 2}, 0.0, 0.0};
  const Vec3 axis = (x.at(2) - x.at(1)).normalized();
  EXPECT_NEAR(rates(joint, x, turning(x, {0.3, 2.0, -1.0}, 1.7 * axis))[0], 1.7, 1e-12);
}

TEST(JointResistance, TakesFromOnePartWhatItGivesToTheOther) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (const JointKind kind : {JointKind::hinge, JointKind::swing, JointKind::twist})
    for (int round = 0; round < 50; ++round) {
      Model model;
      State state;
      Vec3 momentum = Vec3::Zero(), spin = Vec3::Zero();
      for (int i = 0; i < 6; ++i) {
        state.position.push_back(Vec3(any(random), any(random), any(random)));
        state.velocity.push_back(5.0 * Vec3(any(random), any(random), any(random)));
        model.masses.mass.push_back(1.5 + any(random));
        model.masses.inverse_mass.push_back(1.0 / model.masses.mass.back());
      }
      model.joints = {{kind, {0, 1, 2, 3, 4, 5}, 0.4, 0.3}};
      state.static_friction.joints = {Vec3::Zero()};
      Vectors after = state.velocity;
      JointResistance(model).act(state, 0.01, 1.0, after);
      double changed = 0.0, energy = 0.0;
      for (std::size_t i = 0; i < 6; ++i) {
        const Vec3 impulse = model.masses.mass[i] * (after.at(i) - state.velocity.at(i));
        momentum += impulse;
        spin += state.position.at(i).cross(impulse);
        changed += impulse.norm();
        energy +=
            0.5 * model.masses.mass[i] * (after.at(i).squaredNorm() - state.velocity.at(i).squaredNorm());
      }
      EXPECT_GT(changed, 0.0);
      EXPECT_LT(momentum.norm(), 1e-13 + 1e-12 * changed);
      EXPECT_LT(spin.norm(), 1e-13 + 1e-12 * changed);
      EXPECT_LT(energy, 0.0);
    }
}

}  // namespace
}  // namespace taut
