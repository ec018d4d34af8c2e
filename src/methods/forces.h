#pragma once

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// How drag acts in a kick of h seconds: at the end, v' = (v + h (g + f/m)) / (1 + h·drag), which damps for
/// every h; or at the start, v' = v (1 − h·drag) + h (g + f/m). Half a kick of the second kind and then one
/// of the first are the trapezoidal rule, of second order.
enum class DragAt { end, start };

/// Velocities after gravity, loads and drag have acted for h seconds, in the free masses; pins keep theirs.
/// Loads have their strength at `load_time`. `kicked` may be `velocity`.
void kick(const Model& model, double load_time, double h, const Vectors& velocity, Vectors& kicked,
          DragAt drag_at = DragAt::end);

/// Lets the wind blow on the sheets' whole triangles for h seconds: each, of area A and unit normal n, is
/// pushed by F = ρ C A |u·n| (u·n) n/2, u being the air's velocity relative to it, whichever side faces it.
/// Its three masses share F; the push never overtakes the air.
void blow(const Wind& wind, const Model& model, const State& state, double time, double h, Vectors& velocity);

/// moved = position + h·velocity, in every mass.
void drift(double h, const Vectors& position, const Vectors& velocity, Vectors& moved);

/// The mean velocity (to − from)/h of every mass.
void difference_quotient(double h, const Vectors& from, const Vectors& to, Vectors& velocity);

/// Pushes masses that have entered the plane back onto it and takes from their way along it, counted from
/// `start`, at most friction × depth: Coulomb's law for the position changes of one step (Macklin et al.,
/// Unified Particle Physics, 2014, eq. 24).
void keep_out_of_plane(const Plane& plane, const Masses& masses, const Vectors& start, Vectors& position);

}  // namespace taut
