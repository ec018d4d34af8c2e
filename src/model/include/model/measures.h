#pragma once

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// How far links are from their lengths: (distance − length)/length over the whole links.
struct Strain {
  double largest = 0.0;  ///< largest |strain|
  double mean = 0.0;     ///< mean |strain|
  double root_mean_square = 0.0;
  Index worst_link = no_link;
};
Strain link_strain(const Model& model, const State& state);

/// Energy of the free masses and whole links (J). Potential energy counts from the origin.
struct Energy {
  double kinetic = 0.0;
  double potential = 0.0;  ///< in gravity
  double elastic = 0.0;  ///< k (distance − length)²/2 of links with stiffness, excess²/(2 compliance) of soft
                         ///< limits

  double total() const { return kinetic + potential + elastic; }
};
Energy energy(const Model& model, const State& state);
/// The same without what links hold.
Energy energy_of_masses(const Model& model, const State& state);
/// What a link holds (J); 0 when it is rigid or broken.
double elastic_energy(const Model& model, const State& state, std::size_t link);

/// The size that energy errors are measured in (J): kinetic and elastic energy at the start + weight × total
/// link length, or where there are no links scene_size().
double energy_scale(const Model& model, const State& start);

/// Energy that a run has gained from nothing, over the energy scale, when it counts as diverged.
inline constexpr double divergence = 1e3;

/// The size that errors of place are measured in (m): the diagonal of the box around all masses at the start.
/// Where that is nothing: the total link length; without links, the diameter of the mass; of a point, 1 m.
double scene_size(const Model& model, const State& start);

/// Linear momentum of the free masses (kg m/s).
Vec3 linear_momentum(const Model& model, const State& state);

/// Angular momentum of the free masses about the origin (kg m²/s).
Vec3 angular_momentum(const Model& model, const State& state);

/// Centre of the free masses (m).
Vec3 centre_of_mass(const Model& model, const State& state);

/// Which way is up, of unit length: against gravity, or along y where there is none.
Vec3 up_direction(const Model& model);

/// Angular momentum of the free masses about their centre (kg m²/s): it stays in free flight.
Vec3 spin(const Model& model, const State& state);

/// Whether nothing outside acts on the free masses but uniform gravity: no pin holds them, nothing is there
/// to be touched, no air, no drag, no load.
bool flies_freely(const Model& model);

/// How far the lowest mass lies below the lowest pin (below the highest mass where nothing is pinned), with
/// up_direction() (m).
double sag(const Model& model, const State& state);

/// Speed of the fastest mass (m/s).
double fastest_speed(const State& state);

/// How far the worst angle is beyond its range (rad); 0 where none is.
double largest_limit_excess(const Model& model, const State& state);

/// How deep the deepest contact point or face is inside what it can't enter: a solid, or of faces the
/// thickness of others (m); 0 where none is.
double deepest_penetration(const Model& model, const State& state);

/// Links that are broken.
std::size_t broken_links(const State& state);

/// Largest distance between the places of one mass in two states (m).
double position_error(const State& state, const State& reference);

}  // namespace taut
