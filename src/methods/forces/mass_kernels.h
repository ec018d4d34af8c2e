#pragma once

#include <cstddef>

#include "axes.h"

namespace taut {

/// What kick() does to free masses: v ← v·keep + gain. Pins keep theirs.
struct MassKick {
  const double* inverse_mass;  ///< 1/kg, 0 for pins
  double keep;
  Vec3 gain;  ///< m/s
};

/// kicked = v after the kick, of `count` masses; it may be v.
void kick_masses(std::size_t count, const MassKick& kick, const AxesToRead& velocity,
                 const AxesToWrite& kicked);

/// kicked = v after the kick, unless it is null, moved = x + h·kicked, of `count` masses.
void kick_and_move(std::size_t count, const MassKick& kick, double h, const AxesToRead& position,
                   const AxesToRead& velocity, const AxesToWrite& kicked, const AxesToWrite& moved);

/// velocity = rate·(to − from), of `count` masses.
void mean_velocities(std::size_t count, double rate, const AxesToRead& from, const AxesToRead& to,
                     const AxesToWrite& velocity);

/// velocity = rate·(to − from) after the kick, of `count` masses.
void mean_and_kick(std::size_t count, const MassKick& kick, double rate, const AxesToRead& from,
                   const AxesToRead& to, const AxesToWrite& velocity);

/// Energy of motion and of gravity (J), Σ m (|v|²/2 − g·x) over the free ones of `count` masses; where any
/// number is not finite, even a pin's, neither is the sum.
struct FallingMasses {
  const double *mass, *inverse_mass;  ///< kg, 1/kg
  Vec3 gravity;                       ///< m/s²
};
double energy_of_falling(std::size_t count, const FallingMasses& masses, const AxesToRead& position,
                         const AxesToRead& velocity);

/// The largest |coordinate| of `count` vectors that are numbers.
double largest_of(std::size_t count, const AxesToRead& vectors);

}  // namespace taut
