#pragma once

#include <span>
#include <vector>

#include "geometry/bodies.h"
#include "geometry/picture_space.h"
#include "model/colliders.h"
#include "model/model.h"
#include "model/state.h"
#include "render/ground.h"
#include "view/view.h"

namespace taut {

enum class Material { wood, metal };

/// A rod with round ends, or a ball where both are one; see TaperedRod.
struct SupportPart {
  Vec3 start, end;                  ///< m
  double start_radius, end_radius;  ///< m
  Vec3 squeeze;                     ///< shorter than 1
  Material material;
};

/// A part that moves along with a mass.
struct CarriedPart {
  Index mass;
  SupportPart part;  ///< seen from the mass
};

/// What holds the pins of a scene. It is drawn, and no part of the physics.
struct Supports {
  std::vector<SupportPart> fixed;  ///< in the world
  std::vector<Box> beams;          ///< in the world, of wood
  std::vector<CarriedPart> carried;
};

/// What drawing knows that bears on supports.
struct SupportSight {
  Vec3 up = Vec3::UnitY();                  ///< unit length
  std::span<const Ground> grounds;          ///< what posts stand on
  double pin_radius = 0.0;                  ///< m, of pins as they are drawn
  const std::vector<bool>* seen = nullptr;  ///< whether each mass is; null: all are
};

/// Works out from a scene's pins what might hold them, once for a whole film:
/// - an edge of a sheet that is moved as one: a bar that moves along.
/// - another whose pins all lie on one line: a pole where that is upright, else a bar where all
///   of the edge is pinned, else a rail with a ring for each pin. A rail is as long as hooks ever move.
/// - three pins or more that are spread out level and pulled at from the side: a post each; a pin just above
///   the ground: a peg; other pins at rest: a bracket above each; of a body: a bar to hold on to.
/// - pins that are moved otherwise: a handle that moves along.
/// Pins without links, hidden ones, and what nothing is pinned of, have none.
Supports supports(const Model& model, const Vectors& start, const SupportSight& sight);

/// The supports of one scene, worked out when they are first seen.
class SceneSupports {
 public:
  /// Refers to the model from then on.
  SceneSupports(const Model& model, const State& start, const Look& look, const Radii& radii,
                const Appearance& appearance);

  /// In pictures for which `up` (unit length) is up.
  const Supports& seen_with(const Vec3& up);

 private:
  const Model* model_;
  Vectors start_;  // m, where masses are at the start
  Look look_;
  double pin_radius_;       // m
  std::vector<bool> seen_;  // by mass
  Vec3 up_ = Vec3::Zero();
  Supports supports_;
};

/// Adds them as they stand in a state that is seen (picture_space.h).
void add_supports(Bodies& bodies, const Supports& supports, const PictureSpace& space, const State& seen,
                  Theme theme);

}  // namespace taut
