#pragma once

#include "extent.h"
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

/// What gravity and drag make of a free mass's velocity in a kick: v·keep + gain. `answer` is how much of any
/// other impulse drag leaves.
struct FieldKick {
  double keep = 1.0, answer = 1.0;
  Vec3 gain = Vec3::Zero();  ///< m/s
};
FieldKick field_kick(const Model& model, double h, DragAt drag_at);

/// Whether masses are pushed from outside: by wind, by loads, or by pins that are driven.
bool pushed_from_outside(const Model& model);

/// kick() for `kick_time` seconds and then drift() for h, in one go over some of the masses; none of the
/// vectors may be another. `kicked` is room for velocities, and holds them only where there are loads.
void kick_and_drift(const Model& model, double load_time, double kick_time, double h, const Vectors& position,
                    const Vectors& velocity, Vectors& kicked, Vectors& moved, DragAt drag_at, Extent masses);

/// difference_quotient() and then kick() for `kick_time` seconds, in one go over some of the masses; driven
/// pins get their velocities.
void mean_velocity_and_kick(const Model& model, double load_time, double kick_time, double h,
                            const Vectors& from, const Vectors& to, Vectors& velocity, Extent masses);

/// Accelerations (m/s²) by gravity, loads and drag; 0 for pins.
void fall(const Model& model, double load_time, const Vectors& velocity, Vectors& acceleration);

/// Lets the wind, where there is one, blow for h seconds on the sheets' triangles that are whole in `state`:
/// each, of area A and unit normal n, is pushed by F = ρ C A |u·n| (u·n) n/2, u being the air's velocity
/// relative to it, whichever side faces it; its three masses share F. `velocity` is that of the masses the
/// wind meets. At the end of a step the push answers to what it does, at its start it does not; in neither
/// case does one triangle's push overtake the air.
void blow(const Model& model, const State& state, const Vectors& position, const Vectors& velocity,
          double time, double h, Vectors& kicked, DragAt drag_at = DragAt::end);

/// The same as accelerations (m/s²), added to those of the free masses.
void add_wind(const Model& model, const State& state, const Vectors& position, const Vectors& velocity,
              double time, Vectors& acceleration);

/// moved = position + h·velocity, in every mass.
void drift(double h, const Vectors& position, const Vectors& velocity, Vectors& moved);

/// The mean velocity (to − from)/h of every mass.
void difference_quotient(double h, const Vectors& from, const Vectors& to, Vectors& velocity);
void difference_quotient(double h, const Vectors& from, const Vectors& to, Vectors& velocity, Extent masses);

/// Energy (J) of some masses' motion and of gravity on them. Where it is finite, all their positions and
/// velocities are.
double energy_of_some(const Model& model, const Vectors& position, const Vectors& velocity, Extent masses);

}  // namespace taut
