#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/vectors.h"

namespace taut {

// Joints, and bodies of them, as a person writes it; see description.h.

/// A range for the angle at the second of three masses.
struct AngleSpec {
  std::vector<std::string> masses;  ///< three names
  double min = 0.0, max = 180.0;    ///< degrees
  double compliance = 0.0;          ///< rad/(N m)
};

/// A range for how far the third mass is turned on from straight, about an axis from one mass to another.
struct HingeSpec {
  std::vector<std::string> masses;   ///< three names
  std::vector<std::string> axis;     ///< two names
  double min = -180.0, max = 180.0;  ///< degrees, right-handed about the axis, 0: straight
  double compliance = 0.0;           ///< rad/(N m)
};

/// A half-angle for a limb about an axis that is fixed in the frame of three masses.
struct ConeSpec {
  std::vector<std::string> frame;  ///< three names
  std::vector<std::string> limb;   ///< from the first to the second, or to the middle of the second and third
  Vec3 axis = Vec3::UnitY();       ///< as it points at the start
  double half_angle = 90.0;        ///< degrees
  double compliance = 0.0;         ///< rad/(N m)
};

/// The angles of a ragdoll's joints at the start, in degrees. Bends are about the body's right-hand axis: a
/// limb that hangs swings forward by a positive one. "out" is sideways, away from the body.
struct PoseSpec {
  double neck = 0.0;
  double left_shoulder = 0.0, right_shoulder = 0.0;
  double left_shoulder_out = 10.0, right_shoulder_out = 10.0;
  double left_elbow = 10.0, right_elbow = 10.0;
  double left_hip = 5.0, right_hip = 5.0;
  double left_hip_out = 4.0, right_hip_out = 4.0;
  double left_knee = -8.0, right_knee = -8.0;
};

/// Ranges of a ragdoll's joints in degrees: [least, most] of hinges, half-angles of cones.
struct RangeSpec {
  std::array<double, 2> neck{-54.0, 18.0};
  std::array<double, 2> elbow{1.8, 90.0};
  std::array<double, 2> knee{-90.0, -3.6};
  double shoulder = 76.5;
  double hip = 40.5;
  double hip_twist = 50.0;
  double wrist = 60.0;
  double ankle = 35.0;
};

/// The parts a ragdoll can be held by.
inline constexpr std::array<std::string_view, 5> ragdoll_handles{"left_hand", "right_hand", "left_foot",
                                                                 "right_foot", "head"};

/// A body of a given height and mass, its segments by Winter's table.
struct RagdollSpec {
  std::string name;
  double height = 1.75;          ///< m
  double mass = 75.0;            ///< kg
  Vec3 position = Vec3::Zero();  ///< m, of the middle of the hips at the start
  Vec3 turn = Vec3::Zero();      ///< degrees about x, then y, then z; unturned it stands and looks along +z
  Vec3 velocity = Vec3::Zero();  ///< m/s
  Vec3 spin = Vec3::Zero();      ///< rad/s, about its centre of mass
  PoseSpec pose;
  RangeSpec ranges;
  double joint_damping = 0.0;   ///< 1/s: each joint's damping over the moment of inertia, about the joint, of
                                ///< all that is beyond it, stretched out
  double joint_friction = 0.0;  ///< share of the torque that holds all that is beyond a joint out level
                                ///< against 9.81 m/s²
  std::vector<std::string> pinned;  ///< out of ragdoll_handles
  bool collides = false;            ///< whether it touches other bodies that do so
};

}  // namespace taut
