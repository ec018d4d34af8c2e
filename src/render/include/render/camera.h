#pragma once

#include "model/model.h"
#include "model/state.h"
#include "view/view.h"

namespace taut {

/// Where the picture is taken from at one moment.
struct CameraPose {
  Vec3 eye{0.0, 1.0, 5.0};      ///< m
  Vec3 target{0.0, 1.0, 0.0};   ///< m
  double field_of_view = 38.0;  ///< degrees, vertical
  Vec3 up = Vec3::UnitY();      ///< unit length

  bool operator==(const CameraPose&) const = default;
};

/// Which way is up in pictures of a model, of unit length: as the camera says, or against gravity.
Vec3 up_direction(const Camera& camera, const Model& model);

/// Axes of which the second points up (unit length): those of the world, turned by the shortest way that
/// takes y there (by half a turn about x where that is −y). As columns.
Eigen::Matrix3d upright_axes(const Vec3& up);

/// How far a mass has moved since the start (m); nothing for an empty name. Throws BadRequest when there is
/// no such mass.
Vec3 displacement(const std::string& name, const Model& model, const State& start, const State& now);

/// How an orbiting camera has turned about the vertical by a time (s).
Eigen::AngleAxisd orbit_turn(const Camera& camera, const Vec3& up, double time);

/// The picture's right and top, and what points back at the eye, as columns.
Eigen::Matrix3d sight_axes(const Vec3& towards_eye, const Vec3& up);

/// The camera, whose eye and target are given, at the time of `now`: its eye turned about the vertical
/// through the target (counter-clockwise seen from above) by orbit × time, then both displaced as far as the
/// followed mass has moved since `start`. Throws BadRequest when the mass to follow does not exist.
CameraPose camera_pose(const Camera& camera, const Model& model, const State& start, const State& now);

/// Where a point of space appears in a picture, in pixels from its top left corner; z is the distance from
/// the eye along the line of sight (m), negative behind the eye.
Vec3 picture_position(const CameraPose& pose, int width, int height, const Vec3& point);

}  // namespace taut
