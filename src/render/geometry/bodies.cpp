#include "geometry/bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>

#include "geometry/lattice.h"
#include "geometry/view_matrices.h"
#include "model/orientation.h"

namespace taut {
namespace {

Colour mixed(const Colour& a, const Colour& b, double share) {
  return {std::lerp(a[0], b[0], share), std::lerp(a[1], b[1], share), std::lerp(a[2], b[2], share)};
}

Vec3 middle(const State& state, const std::array<Index, 2>& masses) {
  return 0.5 * (state.position.at(masses[0]) + state.position.at(masses[1]));
}

double mean_of(const std::vector<double>& values, const std::array<Index, 2>& masses) {
  return 0.5 * (values[masses[0]] + values[masses[1]]);
}

RodRecord rod(const Vec3& start, const Vec3& end, double radius, const Colour& colour) {
  return {to_glm(start), static_cast<float>(radius), to_glm(end), opaque(colour)};
}

BoxRecord box_record(const Box& box, const Colour& colour) {
  BoxRecord record{to_glm(box.centre), {}, opaque(colour)};
  for (int axis = 0; axis < 3; ++axis) record.edges[axis] = to_glm(box.half_size[axis] * box.axes.col(axis));
  return record;
}

void add(Bodies& /*bodies*/, const HalfSpace& /*plane*/, const Colour& /*colour*/) {}
void add(Bodies& bodies, const Sphere& sphere, const Colour& colour) {
  bodies.rods.push_back(rod(sphere.centre, sphere.centre, sphere.radius, colour));
}
void add(Bodies& bodies, const Capsule& capsule, const Colour& colour) {
  bodies.rods.push_back(rod(capsule.a, capsule.b, capsule.radius, colour));
}
void add(Bodies& bodies, const Box& box, const Colour& colour) {
  bodies.boxes.push_back(box_record(box, colour));
}

// Joints stand out a little from the bones that meet in them: in colour, and by a hair in size.
constexpr double joint_swell = 1.06;

Colour bone_colour(const Look& look, const Bone& bone, const Quantity& quantity, const ColourScale& scale) {
  constexpr Colour neutral{0.66, 0.67, 0.69};
  if (look.colour_by == ColourBy::plain) return look.bone_colour;
  if (look.colour_by == ColourBy::limit) return neutral;
  return scale.at(0.5 * (mean_of(quantity.of_mass, bone.from) + mean_of(quantity.of_mass, bone.to)));
}

// A ball at the end of a bone.
struct JointBall {
  std::array<Index, 2> masses;
  double radius;  // m
  Colour colour;

  auto operator<=>(const JointBall&) const = default;
};

Colour joint_colour(const Look& look, const std::array<Index, 2>& joint, const Colour& bone,
                    const Quantity& quantity, const ColourScale& scale) {
  if (look.colour_by == ColourBy::limit)
    return scale.at(std::max(quantity.of_mass[joint[0]], quantity.of_mass[joint[1]]));
  return mixed(bone, {0.0, 0.0, 0.0}, 0.22);
}

}  // namespace

void add_bones(Bodies& bodies, const Model& model, const State& state, const Look& look,
               const Quantity& quantity, const ColourScale& scale) {
  std::vector<JointBall> joints;
  for (const Bone& bone : model.bones) {
    const Colour colour = bone_colour(look, bone, quantity, scale);
    bodies.rods.push_back(rod(middle(state, bone.from), middle(state, bone.to), bone.radius, colour));
    if (bone.from == bone.to) continue;
    for (const auto& masses : {bone.from, bone.to})
      joints.push_back(
          {masses, joint_swell * bone.radius, joint_colour(look, masses, colour, quantity, scale)});
  }
  // Of bones that meet in a joint each brings a ball; most are the same.
  std::ranges::sort(joints);
  joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  for (const JointBall& joint : joints) {
    const Vec3 at = middle(state, joint.masses);
    bodies.rods.push_back(rod(at, at, joint.radius, joint.colour));
  }
}

void add_shape(Bodies& bodies, const Shape& shape, const Colour& colour) {
  std::visit([&](const auto& kind) { add(bodies, kind, colour); }, shape);
}

void add_mass_boxes(Bodies& bodies, const Model& model, const State& start, const State& state,
                    const Look& look, const Radii& radii, const Quantity& quantity,
                    const ColourScale& scale) {
  const std::vector<Eigen::Quaterniond> turns = orientations(model, start, state);
  const std::vector<bool> boned = in_ragdoll(model);
  for (std::size_t i = 0; i < model.masses.size(); ++i) {
    if (boned[i]) continue;
    const double half =
        model.masses.radius[i] > 0.0 ? std::max(model.masses.radius[i], radii.mass) : radii.of_mass[i];
    bodies.boxes.push_back(
        box_record({state.position.at(i), Vec3::Constant(half), turns[i].toRotationMatrix()},
                   mass_colour(model, look, radii, quantity, scale, i)));
  }
}

}  // namespace taut
