#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "builder.h"

namespace taut {
namespace {

HalfSpace shape_of(const PlaneSpec& spec) {
  return {spec.point, spec.normal.normalized()};
}
Sphere shape_of(const SphereSpec& spec) {
  return {spec.centre, spec.radius};
}
Capsule shape_of(const CapsuleSpec& spec) {
  return {spec.from, spec.to, spec.radius};
}
Box shape_of(const BoxSpec& spec) {
  return {spec.centre, 0.5 * spec.size, turned(spec.turn)};
}

MeshSolid shape_of(const MeshSolidSpec& spec) {
  return {spec.data->mesh, spec.data->middle, Eigen::Matrix3d::Identity()};
}

// What a solid turns about and is carried by, unless said otherwise.
Vec3 centre_of(const PlaneSpec& spec) {
  return spec.point;
}
Vec3 centre_of(const SphereSpec& spec) {
  return spec.centre;
}
Vec3 centre_of(const CapsuleSpec& spec) {
  return 0.5 * (spec.from + spec.to);
}
Vec3 centre_of(const BoxSpec& spec) {
  return spec.centre;
}
Vec3 centre_of(const MeshSolidSpec& spec) {
  return spec.position;
}

Path turning_path(const std::vector<std::array<double, 2>>& angles) {
  std::vector<Knot> knots;
  knots.reserve(angles.size());
  for (const auto& [time, angle] : angles) knots.push_back({time, Vec3(angle * degree, 0.0, 0.0)});
  return make_path(std::move(knots));
}

template <typename Spec>
std::optional<SolidMotion> motion_of(const Spec& spec) {
  const WaySpec& way = spec.moves.motion;
  if (!spec.moves.rotation && way.empty()) return std::nullopt;
  SolidMotion motion;
  motion.from = motion.centre = centre_of(spec);
  if (way.sinusoid)
    motion.way =
        Sinusoid{motion.from, way.sinusoid->amplitude, way.sinusoid->angular_frequency, way.sinusoid->phase};
  else if (!way.path.empty())
    motion.way = make_path(way.path);
  if (!spec.moves.rotation) return motion;
  motion.axis = spec.moves.rotation->axis.normalized();
  motion.centre = spec.moves.rotation->through.value_or(motion.from);
  if (spec.moves.rotation->rate)
    motion.turn = SteadyTurn{*spec.moves.rotation->rate * degree, spec.moves.rotation->rise};
  else
    motion.turn = turning_path(spec.moves.rotation->angle);
  return motion;
}

template <typename Spec>
void add_colliders(Builder& builder, const std::vector<Spec>& specs) {
  for (const Spec& spec : specs) {
    builder.model.colliders.push_back({shape_of(spec), spec.friction, spec.restitution, motion_of(spec)});
    if (!spec.moves.name.empty())
      builder.solid_motions.emplace(spec.moves.name, motion_of(spec).value_or(SolidMotion{}));
  }
}

ContactPoint ball_on(Index mass, double radius, Index body) {
  return {{mass, mass, mass, mass}, {1.0, 0.0, 0.0, 0.0}, radius, body, false};
}

// Lets a mass that the point already rides on carry more, or takes up one more.
void add_weight(ContactPoint& point, Index mass, double weight) {
  for (std::size_t i = 0; i < point.masses.size(); ++i) {
    const bool is_free = i > 0 && point.weights[i] == 0.0;
    if (point.masses[i] != mass && !is_free) continue;
    point.masses[i] = mass;
    point.weights[i] += weight;
    return;
  }
}

// Balls along a bone, close enough together that an edge between two of them sinks in by a sixth of the
// radius at most.
void add_bone_contacts(Builder& builder, const Bone& bone, Index body) {
  const Vectors& x = builder.start.position;
  const Vec3 from = 0.5 * (x.at(bone.from[0]) + x.at(bone.from[1]));
  const Vec3 to = 0.5 * (x.at(bone.to[0]) + x.at(bone.to[1]));
  const int pieces = static_cast<int>(std::ceil((to - from).norm() / (1.1 * bone.radius)));
  for (int i = 0; i <= pieces; ++i) {
    const double share = pieces == 0 ? 0.0 : static_cast<double>(i) / pieces;
    ContactPoint point = ball_on(bone.from[0], bone.radius, body);
    point.static_friction = true;
    point.weights[0] = 0.0;
    for (const Index end : bone.from) add_weight(point, end, 0.5 * (1.0 - share));
    for (const Index end : bone.to) add_weight(point, end, 0.5 * share);
    builder.model.contacts.push_back(point);
  }
}

// To be called while contact points are those of single masses.
void mark_corners(Model& model, const SheetFaces& faces) {
  const Sheet& sheet = model.sheets[faces.sheet];
  for (ContactPoint& point : model.contacts)
    if (point.masses[0] >= sheet.first_mass && point.masses[0] - sheet.first_mass < sheet.mass_count)
      point.of_faces = true;
}

// Every mass that no bone holds is a ball of its own.
void add_contacts(Builder& builder) {
  Model& model = builder.model;
  const std::vector<bool> in_bone = in_ragdoll(model);
  for (std::size_t i = 0; i < model.masses.size(); ++i) {
    if (in_bone[i]) continue;
    const auto mass = static_cast<Index>(i);
    model.contacts.push_back(ball_on(mass, model.masses.radius[i], builder.body_of_mass[i]));
  }
  for (const SheetFaces& faces : model.faces) mark_corners(model, faces);
  for (std::size_t i = 0; i < model.bones.size(); ++i)
    add_bone_contacts(builder, model.bones[i], builder.body_of_bone[i]);
}

}  // namespace

Eigen::Matrix3d turned(const Vec3& degrees) {
  const Vec3 angles = degrees * degree;
  return (Eigen::AngleAxisd(angles.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(angles.y(), Vec3::UnitY()) *
          Eigen::AngleAxisd(angles.x(), Vec3::UnitX()))
      .toRotationMatrix();
}

void add_solids(Builder& builder, const Description& description) {
  add_colliders(builder, description.planes);
  add_colliders(builder, description.spheres);
  add_colliders(builder, description.capsules);
  add_colliders(builder, description.boxes);
  add_colliders(builder, description.mesh_solids);
}

// In the order in which add_solids() has them.
SectionEntry solid_entry(const Description& description, std::size_t collider) {
  const std::array<std::pair<std::string_view, std::size_t>, 5> sections{{
      {"plane", description.planes.size()},
      {"sphere", description.spheres.size()},
      {"capsule", description.capsules.size()},
      {"box", description.boxes.size()},
      {"solid", description.mesh_solids.size()},
  }};
  for (const auto& [section, count] : sections) {
    if (collider < count) return {section, collider};
    collider -= count;
  }
  return {};
}

void add_contact_points(Builder& builder) {
  if (!builder.model.colliders.empty() || builder.any_body()) add_contacts(builder);
}

}  // namespace taut
