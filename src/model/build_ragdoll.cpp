// A ragdoll: 23 masses, 38 rigid links, 15 limits.
//
// The trunk is an octahedron, which its twelve edges keep rigid: shoulders and hips around, chest and back in
// front and behind, a sixth of its mass at each. An elbow or a knee is two masses on the joint's axis: with
// the segment's other end they make a triangle, so the joint is a true hinge and its axis turns with the
// limb. Shoulders, hips, wrists and ankles are single masses, ball joints held in cones. The head is one mass
// at the height of the ears, linked to both shoulders: it nods about their line.
//
// Each segment's mass is shared by its ends so that its centre of mass lies where the table puts it. Its
// moment of inertia about that centre, m c (1 − c) L², is then more than twice the table's; about the
// segment's own length it is that of the hinge's masses alone.
//
// Lengths are in shares of the height, in the body's frame: x to its left, y up, z forward, from the middle
// of the hips.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "builder.h"
#include "model/anthropometry.h"

namespace taut {
namespace {

constexpr double chest_depth = 0.055, elbow_half_width = 0.020, knee_half_width = 0.030;
constexpr double toe_height = 0.025;
constexpr double head_radius = 1.0 - winter::shoulder_height - winter::head_and_neck.length;
const Vec3 right_hand_side = -Vec3::UnitX();

// The axis of a cone, as flexion forward from hanging down and then a turn outward; the half-angle that goes
// with the first two gives the range of flexion to borrow: shoulder −9 to 144 degrees, hip −9 to 72.
struct ConeAxis {
  double forward, outward;  // degrees
};
constexpr ConeAxis shoulder_axis{67.5, 30.0}, hip_axis{31.5, 10.0};

Eigen::Matrix3d bent(double degrees) {
  return Eigen::AngleAxisd(degrees * degree, right_hand_side).toRotationMatrix();
}

Vec3 axis_direction(const ConeAxis& cone, double side) {
  return Eigen::AngleAxisd(side * cone.outward * degree, Vec3::UnitY()) *
         (bent(cone.forward) * -Vec3::UnitY());
}

// A joint on its way from the trunk outwards: where it is, and how what hangs on it is turned.
struct Place {
  Vec3 at;
  Eigen::Matrix3d turn;
};

Place beyond(const Place& joint, double length, double bend) {
  return {joint.at - length * joint.turn.col(1), joint.turn * bent(bend)};
}

// The two masses of a hinge; left and right as the body sees it.
struct HingeMasses {
  Index left, right;
};

constexpr double standard_gravity = 9.81;  // m/s²

struct Resistance {
  double damping;   // N m s/rad
  double friction;  // N m
};

class RagdollBuilder {
 public:
  RagdollBuilder(Builder& builder, const RagdollSpec& spec, std::size_t index, std::vector<Problem>& problems)
      : builder_(builder), spec_(spec), index_(index), problems_(problems), turn_(turned(spec.turn)) {}

  void add() {
    Model& model = builder_.model;
    Ragdoll ragdoll{
        spec_.name, static_cast<Index>(model.masses.size()), 0, static_cast<Index>(model.links.size()),
        0,          static_cast<Index>(model.bones.size()),  0, static_cast<Index>(model.limits.size()),
        0};
    builder_.begin_body(spec_.collides);
    add_trunk();
    add_head();
    for (const double side : {1.0, -1.0}) {
      add_arm(side);
      add_leg(side);
    }
    set_motion(ragdoll.first_mass);
    ragdoll.mass_count = static_cast<Index>(model.masses.size()) - ragdoll.first_mass;
    ragdoll.link_count = static_cast<Index>(model.links.size()) - ragdoll.first_link;
    ragdoll.bone_count = static_cast<Index>(model.bones.size()) - ragdoll.first_bone;
    ragdoll.limit_count = static_cast<Index>(model.limits.size()) - ragdoll.first_limit;
    model.ragdolls.push_back(std::move(ragdoll));
    builder_.start.static_friction.joints.resize(model.joints.size(), Vec3::Zero());
  }

 private:
  // Masses start without any weight of their own; segments give it to them.
  Index mass(const std::string& name, const Vec3& at, std::string_view handle = "") {
    const bool pinned = std::find(spec_.pinned.begin(), spec_.pinned.end(), handle) != spec_.pinned.end();
    const Vec3 place = spec_.position + spec_.height * (turn_ * at);
    const Index index = builder_.add_mass(spec_.name + "." + name, place, Vec3::Zero(), 1.0, pinned);
    builder_.model.masses.mass[index] = 0.0;
    return index;
  }
  void weigh(Index index, double share) { builder_.model.masses.mass[index] += share * spec_.mass; }

  // Gives a segment's mass to its ends; each is one mass or the two of a hinge.
  void weigh(const Segment& segment, std::initializer_list<Index> near_end,
             std::initializer_list<Index> far_end) {
    for (const Index i : near_end)
      weigh(i, segment.mass * (1.0 - segment.centre) / static_cast<double>(near_end.size()));
    for (const Index i : far_end)
      weigh(i, segment.mass * segment.centre / static_cast<double>(far_end.size()));
  }

  Vec3 place(Index index) const { return builder_.start.position.at(index); }
  void link(Index a, Index b) { builder_.add_link(a, b, (place(a) - place(b)).norm(), {}); }
  void link_all(std::initializer_list<Index> some, std::initializer_list<Index> others) {
    for (const Index a : some)
      for (const Index b : others) link(a, b);
  }
  void bone(std::array<Index, 2> from, std::array<Index, 2> to, double radius) {
    builder_.add_bone({from, to, radius * spec_.height});
  }

  void limit(Limit limit, std::string_view pose_key, std::string_view range_key) {
    const Overshoot beyond = overshoot(limit, limit_angle(limit, builder_.start.position));
    if (beyond.size > 1e-9)
      problems_.push_back(
          {"ragdoll", index_, "pose." + std::string(pose_key),
           fmt::format("{} starts {:.3g} degrees outside the range of {}, {:.4g} to {:.4g} degrees", pose_key,
                       beyond.size / degree, range_key, limit.min / degree, limit.max / degree),
           ""});
    builder_.model.limits.push_back(limit);
  }
  // A limit and a joint that turn about the same axis.
  void hinge(const std::array<Index, 5>& masses, const std::array<double, 2>& range,
             std::string_view pose_key, std::string_view range_key, const Resistance& resistance) {
    Limit made{LimitKind::hinge, 5, {}, Vec3::UnitX(), range[0] * degree, range[1] * degree, 0.0};
    std::copy(masses.begin(), masses.end(), made.masses.begin());
    limit(made, pose_key, range_key);
    joint(JointKind::hinge, made.masses, resistance);
  }
  // A cone about a direction given in the body's frame, as that is turned by `turn` at the start.
  void cone(const std::array<Index, 6>& masses, const Vec3& direction, double half_angle,
            std::string_view pose_key, std::string_view range_key) {
    const Eigen::Matrix3d frame = frame_axes(place(masses[0]), place(masses[1]), place(masses[2]));
    const Vec3 axis = frame.transpose() * (turn_ * direction).normalized();
    limit({LimitKind::cone, 6, masses, axis, 0.0, half_angle * degree, 0.0}, pose_key, range_key);
  }

  // The joint that holds these segments, the first of them nearest, resists as they ask for when stretched
  // out from it in one line.
  Resistance resistance(std::initializer_list<Segment> segments) const {
    double reach = 0.0, moment = 0.0, inertia = 0.0;  // shares of height, mass × height, mass × height²
    const auto put = [&](double mass) {
      moment += mass * reach;
      inertia += mass * reach * reach;
    };
    for (const Segment& segment : segments) {
      put(segment.mass * (1.0 - segment.centre));
      reach += segment.length;
      put(segment.mass * segment.centre);
    }
    return {spec_.joint_damping * inertia * spec_.mass * spec_.height * spec_.height,
            spec_.joint_friction * standard_gravity * moment * spec_.mass * spec_.height};
  }
  void joint(JointKind kind, const std::array<Index, most_limit_masses>& masses,
             const Resistance& resistance) {
    if (resistance.damping > 0.0 || resistance.friction > 0.0)
      builder_.model.joints.push_back({kind, masses, resistance.damping, resistance.friction});
  }
  void ball_joint(const std::array<Index, most_limit_masses>& masses, const Resistance& resistance) {
    joint(JointKind::swing, masses, resistance);
    joint(JointKind::twist, masses, resistance);
  }

  void add_trunk() {
    const double hips = 0.5 * winter::hip_width, shoulders = 0.5 * winter::shoulder_width,
                 top = winter::trunk.length;
    left_shoulder_ = mass("left_shoulder", {shoulders, top, 0.0});
    right_shoulder_ = mass("right_shoulder", {-shoulders, top, 0.0});
    left_hip_ = mass("left_hip", {hips, 0.0, 0.0});
    right_hip_ = mass("right_hip", {-hips, 0.0, 0.0});
    const Index chest = mass("chest", {0.0, 0.5 * top, chest_depth});
    const Index back = mass("back", {0.0, 0.5 * top, -chest_depth});
    for (const Index i : {left_shoulder_, right_shoulder_, left_hip_, right_hip_, chest, back})
      weigh(i, winter::trunk.mass / 6.0);
    link(left_shoulder_, right_shoulder_);
    link(left_hip_, right_hip_);
    link(left_shoulder_, left_hip_);
    link(right_shoulder_, right_hip_);
    link_all({chest, back}, {left_shoulder_, right_shoulder_, left_hip_, right_hip_});
    bone({left_shoulder_, left_shoulder_}, {right_shoulder_, right_shoulder_}, 0.042);
    bone({left_hip_, left_hip_}, {right_hip_, right_hip_}, 0.052);
    bone({left_shoulder_, left_shoulder_}, {left_hip_, left_hip_}, 0.050);
    bone({right_shoulder_, right_shoulder_}, {right_hip_, right_hip_}, 0.050);
    bone({left_shoulder_, right_shoulder_}, {left_hip_, right_hip_}, 0.066);
  }

  void add_head() {
    const Vec3 neck{0.0, winter::trunk.length, 0.0};
    const Index head =
        mass("head", neck + winter::head_and_neck.length * bent(spec_.pose.neck).col(1), "head");
    weigh(head, winter::head_and_neck.mass);
    link_all({head}, {left_shoulder_, right_shoulder_});
    hinge({left_hip_, left_shoulder_, head, left_shoulder_, right_shoulder_}, spec_.ranges.neck, "neck",
          "neck", resistance({winter::head_and_neck}));
    bone({left_shoulder_, right_shoulder_}, {head, head}, 0.030);
    bone({head, head}, {head, head}, head_radius);
  }

  HingeMasses hinge_masses(const std::string& name, const Place& joint, double half_width) {
    const Vec3 across = half_width * joint.turn.col(0);
    const HingeMasses masses{mass(name + ".left", joint.at + across),
                             mass(name + ".right", joint.at - across)};
    link(masses.left, masses.right);
    return masses;
  }

  void add_arm(double side) {
    const bool left = side > 0.0;
    const std::string prefix = left ? "left_" : "right_";
    const PoseSpec& pose = spec_.pose;
    const Index shoulder = left ? left_shoulder_ : right_shoulder_;
    const Vec3 shoulder_at(0.5 * side * winter::shoulder_width, winter::trunk.length, 0.0);
    const double out = left ? pose.left_shoulder_out : pose.right_shoulder_out;
    const Place hanging{shoulder_at, bent(left ? pose.left_shoulder : pose.right_shoulder) *
                                         Eigen::AngleAxisd(side * out * degree, Vec3::UnitZ())};
    const Place elbow = beyond(hanging, winter::upper_arm.length, left ? pose.left_elbow : pose.right_elbow);
    // The hinge's axis is not turned by its own bend.
    const HingeMasses elbows = hinge_masses(prefix + "elbow", elbow, elbow_half_width);
    const Place wrist = beyond(elbow, winter::forearm.length, 0.0);
    const Index wrist_mass = mass(prefix + "wrist", wrist.at);
    const Index hand = mass(prefix + "hand", beyond(wrist, winter::hand.length, 0.0).at, prefix + "hand");

    link_all({elbows.left, elbows.right}, {shoulder, wrist_mass});
    link(wrist_mass, hand);
    weigh(winter::upper_arm, {shoulder}, {elbows.left, elbows.right});
    weigh(winter::forearm, {elbows.left, elbows.right}, {wrist_mass});
    weigh(winter::hand, {wrist_mass}, {hand});
    bone({shoulder, shoulder}, {elbows.left, elbows.right}, 0.027);
    bone({elbows.left, elbows.right}, {wrist_mass, wrist_mass}, 0.022);
    bone({wrist_mass, wrist_mass}, {hand, hand}, 0.020);

    const Index other = left ? right_shoulder_ : left_shoulder_, hip = left ? left_hip_ : right_hip_;
    const std::array upper_arm{shoulder, other, hip, shoulder, elbows.left, elbows.right},
        hand_at_wrist{elbows.left, elbows.right, wrist_mass, wrist_mass, hand, hand};
    cone(upper_arm, axis_direction(shoulder_axis, side), spec_.ranges.shoulder, prefix + "shoulder",
         "shoulder");
    ball_joint(upper_arm, resistance({winter::upper_arm, winter::forearm, winter::hand}));
    hinge({shoulder, elbows.left, wrist_mass, elbows.left, elbows.right}, spec_.ranges.elbow,
          prefix + "elbow", "elbow", resistance({winter::forearm, winter::hand}));
    cone(hand_at_wrist, -wrist.turn.col(1), spec_.ranges.wrist, prefix + "elbow", "wrist");
    joint(JointKind::swing, hand_at_wrist, resistance({winter::hand}));
  }

  void add_leg(double side) {
    const bool left = side > 0.0;
    const std::string prefix = left ? "left_" : "right_";
    const PoseSpec& pose = spec_.pose;
    const Index hip = left ? left_hip_ : right_hip_, other = left ? right_hip_ : left_hip_;
    const double out = left ? pose.left_hip_out : pose.right_hip_out;
    const Place hanging{
        Vec3(0.5 * side * winter::hip_width, 0.0, 0.0),
        bent(left ? pose.left_hip : pose.right_hip) * Eigen::AngleAxisd(side * out * degree, Vec3::UnitZ())};
    const Place knee = beyond(hanging, winter::thigh.length, left ? pose.left_knee : pose.right_knee);
    const HingeMasses knees = hinge_masses(prefix + "knee", knee, knee_half_width);
    const Place ankle = beyond(knee, winter::shank.length, 0.0);
    const Index ankle_mass = mass(prefix + "ankle", ankle.at);
    // The toes' lower side is as low as the sole, ankle_height below the ankle.
    const double drop = winter::ankle_height - toe_height;
    const Vec3 along =
        std::sqrt(winter::foot.length * winter::foot.length - drop * drop) * ankle.turn.col(2) -
        drop * ankle.turn.col(1);
    const Index toe = mass(prefix + "toe", ankle.at + along, prefix + "foot");

    link_all({knees.left, knees.right}, {hip, ankle_mass});
    link(ankle_mass, toe);
    weigh(winter::thigh, {hip}, {knees.left, knees.right});
    weigh(winter::shank, {knees.left, knees.right}, {ankle_mass});
    weigh(winter::foot, {ankle_mass}, {toe});
    bone({hip, hip}, {knees.left, knees.right}, 0.042);
    bone({knees.left, knees.right}, {ankle_mass, ankle_mass}, 0.030);
    bone({ankle_mass, ankle_mass}, {toe, toe}, toe_height);

    const Index shoulder = left ? left_shoulder_ : right_shoulder_;
    const std::array thigh{hip, other, shoulder, hip, knees.left, knees.right},
        foot_at_ankle{knees.left, knees.right, ankle_mass, ankle_mass, toe, toe};
    cone(thigh, axis_direction(hip_axis, side), spec_.ranges.hip, prefix + "hip", "hip");
    cone({hip, other, shoulder, knees.left, knees.right, knees.right}, right_hand_side,
         spec_.ranges.hip_twist, prefix + "hip_out", "hip_twist");
    ball_joint(thigh, resistance({winter::thigh, winter::shank, winter::foot}));
    hinge({hip, knees.left, ankle_mass, knees.left, knees.right}, spec_.ranges.knee, prefix + "knee", "knee",
          resistance({winter::shank, winter::foot}));
    cone(foot_at_ankle, along, spec_.ranges.ankle, prefix + "knee", "ankle");
    joint(JointKind::swing, foot_at_ankle, resistance({winter::foot}));
  }

  // Weights are now known; all masses move as one rigid body.
  void set_motion(Index first) {
    Masses& masses = builder_.model.masses;
    Vec3 centre = Vec3::Zero();
    for (Index i = first; i < masses.size(); ++i) centre += masses.mass[i] / spec_.mass * place(i);
    for (Index i = first; i < masses.size(); ++i) {
      if (masses.pinned(i)) continue;
      masses.inverse_mass[i] = 1.0 / masses.mass[i];
      builder_.start.velocity.set(i, spec_.velocity + spec_.spin.cross(place(i) - centre));
    }
  }

  Builder& builder_;
  const RagdollSpec& spec_;
  std::size_t index_;
  std::vector<Problem>& problems_;
  Eigen::Matrix3d turn_;
  Index left_shoulder_ = 0, right_shoulder_ = 0, left_hip_ = 0, right_hip_ = 0;
};

}  // namespace

Counts count(const RagdollSpec&) {
  return {23.0, 38.0, 0.0, 0.0};
}

void add_ragdoll(Builder& builder, const RagdollSpec& spec, std::size_t index,
                 std::vector<Problem>& problems) {
  RagdollBuilder(builder, spec, index, problems).add();
}

}  // namespace taut
