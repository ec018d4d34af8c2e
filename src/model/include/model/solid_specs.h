#pragma once

#include <memory>
#include <optional>
#include <string>

#include "base/vectors.h"
#include "model/mesh_data.h"
#include "model/motion_specs.h"
#include "model/solid_data.h"

namespace taut {

// What masses can touch, as a person writes it; see description.h.

struct PlaneSpec {
  Vec3 point = Vec3::Zero();    ///< m
  Vec3 normal = Vec3::UnitY();  ///< any length but 0
  double friction = 0.5;
  double restitution = 0.0;  ///< 0 to 1
  SolidMotionSpec moves{};
};

struct SphereSpec {
  Vec3 centre = Vec3::Zero();  ///< m
  double radius = 1.0;         ///< m
  double friction = 0.5;
  double restitution = 0.0;  ///< 0 to 1
  SolidMotionSpec moves{};
};

/// Everything within a radius of the line from `from` to `to`.
struct CapsuleSpec {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  ///< m
  double radius = 1.0;                          ///< m
  double friction = 0.5;
  double restitution = 0.0;  ///< 0 to 1
  SolidMotionSpec moves{};
};

struct BoxSpec {
  Vec3 centre = Vec3::Zero();  ///< m
  Vec3 size = Vec3::Ones();    ///< m, whole edges
  Vec3 turn = Vec3::Zero();    ///< degrees about x, then y, then z
  double friction = 0.5;
  double restitution = 0.0;  ///< 0 to 1
  SolidMotionSpec moves{};
};

/// What a closed surface of triangles, quads and polygons out of a file holds.
struct MeshSolidSpec {
  std::string file;       ///< relative to the folder of the scene
  std::string content{};  ///< the hash that the file must have; empty: any
  double scale = 1.0;     ///< m for 1 in the file
  UpAxis up = UpAxis::y;
  Vec3 position = Vec3::Zero();  ///< m, where the file's origin goes
  Vec3 turn = Vec3::Zero();      ///< degrees about x, then y, then z, through it
  std::optional<double> weld{};  ///< m, corners as near as that are one; absent: a millionth of its size
  double friction = 0.5;
  double restitution = 0.0;  ///< 0 to 1
  SolidMotionSpec moves{};
  std::shared_ptr<const SolidData> data{};  ///< what is in the file, placed; set by whoever reads files
};

}  // namespace taut
