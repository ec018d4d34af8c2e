#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <variant>

#include "base/vectors.h"
#include "model/solid_motion.h"
#include "model/surface.h"

namespace taut {

/// Everything below a plane.
struct HalfSpace {
  Vec3 point = Vec3::Zero();    ///< m
  Vec3 normal = Vec3::UnitY();  ///< unit length, out of the solid
};

struct Sphere {
  Vec3 centre = Vec3::Zero();  ///< m
  double radius = 1.0;         ///< m
};

/// Everything within a radius of a straight line from a to b.
struct Capsule {
  Vec3 a = Vec3::Zero(), b = Vec3::UnitY();  ///< m
  double radius = 1.0;                       ///< m
};

struct Box {
  Vec3 centre = Vec3::Zero();                          ///< m
  Vec3 half_size = Vec3::Ones();                       ///< m
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< its edges' directions as columns
};

class SolidMesh;  // model/solid_mesh.h

/// A closed surface of triangles out of a file.
struct MeshSolid {
  std::shared_ptr<const SolidMesh> mesh;               ///< in axes of its own
  Vec3 centre = Vec3::Zero();                          ///< m, where the origin of those is
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< their directions as columns

  Vec3 place(const Vec3& own) const { return centre + axes * own; }
  Vec3 back(const Vec3& place) const { return axes.transpose() * (place - centre); }
};

using Shape = std::variant<HalfSpace, Sphere, Capsule, Box, MeshSolid>;

/// A solid that nothing can enter.
struct Collider {
  Shape shape;                          ///< where it stands, or would stand if it didn't move
  double friction = 0.5;                ///< Coulomb's coefficient
  double restitution = 0.0;             ///< share of the speed of approach that is given back, 0 to 1
  std::optional<SolidMotion> motion{};  ///< absent: it stays where it is
};

/// A shape that has been moved.
Shape moved(const Shape& shape, const Placement& pose);

/// The shape of a solid where it is at a time.
Shape shape_at(const Collider& collider, double time);

/// The nearest place of a shape's surface.
Surface nearest_surface(const Shape& shape, const Vec3& point);

/// The same where the distance is below `reach` (m), as it is of all that is inside: quickly said of most
/// points that are farther away.
std::optional<Surface> surface_within(const Shape& shape, const Vec3& point, double reach);

/// The same for what came straight from another place. Where it went into the solid on its way, and is
/// through it or nearer to another side, that is the plane that it went in by: however thin a solid is,
/// nothing is pushed out of it on the side that it didn't come from. Solids out of meshes alone know of ways;
/// they may be thin.
std::optional<Surface> surface_on_way(const Shape& shape, const Vec3& from, const Vec3& point, double reach);

inline constexpr Index no_body = std::numeric_limits<Index>::max();

/// Coulomb's coefficient between bodies that touch.
inline constexpr double body_friction = 0.8;

/// How far apart (m) bodies may be to be watched for contact.
inline constexpr double contact_margin = 0.02;

/// A ball that rides on up to four masses and touches colliders: a mass of some size, or a place on a bone.
struct ContactPoint {
  std::array<Index, 4> masses{};    ///< those without weight repeat the first
  std::array<double, 4> weights{};  ///< sum to 1
  double radius = 0.0;              ///< m
  Index body = no_body;             ///< touches points of other bodies; no_body: touches none
  bool static_friction = false;     ///< remembers where it sticks; see StaticFriction
  bool of_faces = false;            ///< a corner of faces that touch; see SheetFaces
};

/// Whether a contact point is a single mass that touches other bodies as a ball, the faces of sheets among
/// them.
inline bool is_ball(const ContactPoint& point) {
  return point.body != no_body && point.weights[0] == 1.0 && !point.of_faces;
}

/// What a contact point has of its masses' positions, or velocities.
inline Vec3 value_at(const ContactPoint& point, const Vectors& of) {
  Vec3 sum = point.weights[0] * of.at(point.masses[0]);
  for (std::size_t k = 1; k < point.masses.size(); ++k)
    if (point.weights[k] != 0.0) sum += point.weights[k] * of.at(point.masses[k]);
  return sum;
}

}  // namespace taut
