#pragma once

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// Velocities after gravity, loads and drag have acted for h seconds, in the free masses; pins keep theirs.
/// Drag is implicit: v' = (v + h (g + f/m)) / (1 + h·drag), which damps for every h. Loads have their
/// strength at `load_time`.
void kick(const Model& model, double load_time, double h, const Vectors& velocity, Vectors& kicked);

/// moved = position + h·velocity, in every mass.
void drift(double h, const Vectors& position, const Vectors& velocity, Vectors& moved);

/// The mean velocity (to − from)/h of every mass.
void difference_quotient(double h, const Vectors& from, const Vectors& to, Vectors& velocity);

/// Pushes masses that have entered the plane back onto it and takes from their way along it, counted from
/// `start`, at most friction × depth: Coulomb's law for the position changes of one step (Macklin et al.,
/// Unified Particle Physics, 2014, eq. 24).
void keep_out_of_plane(const Plane& plane, const Masses& masses, const Vectors& start, Vectors& position);

}  // namespace taut
