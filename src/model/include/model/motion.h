#pragma once

#include <variant>
#include <vector>

#include "model/solid_motion.h"

namespace taut {

/// A pin that a solid carries along: where it stands beside the solid as that stands in the model.
struct Carried {
  Vec3 place = Vec3::Zero();  ///< m
  SolidMotion solid;
};

Vec3 position_at(const Carried& carried, double time);
Vec3 velocity_at(const Carried& carried, double time);
Vec3 acceleration_at(const Carried& carried, double time);

/// How a pin is driven.
using Motion = std::variant<Sinusoid, Path, Carried>;

/// Where a motion is at a time (m).
Vec3 position_at(const Motion& motion, double time);

/// How fast it moves then (m/s): the exact derivative of position_at().
Vec3 velocity_at(const Motion& motion, double time);

/// The exact derivative of velocity_at() (m/s²).
Vec3 acceleration_at(const Motion& motion, double time);

/// The times (s) at which derivatives beyond the second jump.
std::vector<double> kinks_of(const Motion& motion);

/// The last time (s) at which anything of it changes: infinity where it goes on for ever.
double last_change(const Motion& motion);

}  // namespace taut
