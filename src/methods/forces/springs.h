#pragma once

#include <cstdint>
#include <vector>

#include "direct/link_system.h"
#include "forces/bend_forces.h"

namespace taut {

/// Links with stiffness and damping, and bends, as forces.
struct Springs {
  SystemLinks links;
  std::vector<double> stiffness;      ///< N/m
  std::vector<FreeRange> free_range;  ///< empty where none is one-sided

  BendForces bends;

  bool empty() const { return links.size() == 0 && bends.empty(); }
  /// How far (m) a spring is beyond where it does nothing.
  double stretch(std::size_t i, double distance) const {
    return free_range.empty() ? distance - links.length[i] : free_range[i].beyond(distance);
  }
};

/// Whether one-sided links are springs, too: where they aren't the method's limits.
enum class OneSided { left_out, taken };

/// The whole links with stiffness that have a free end.
Springs gather_springs(const Model& model, const State& state, OneSided one_sided = OneSided::left_out);

/// Whether any of them is damped.
bool any_damped(const Springs& springs);

/// Pull of each spring (N): k (|d| − l) + c d·ḋ/|d|.
void spring_tensions(const Springs& springs, const Vectors& position, const Vectors& velocity,
                     std::vector<double>& tension);

/// Adds to `kicked` what the springs' pulls do to velocities in h seconds; where springs are damped it must
/// not be `velocity`.
void kick_by_springs(const Springs& springs, double h, const Vectors& position, const Vectors& velocity,
                     Vectors& kicked, std::vector<double>& tension);

/// The largest angular frequency (rad/s) of the springs' vibrations about a configuration: the root of the
/// largest eigenvalue of M⁻¹K, K = Σ k n nᵀ, by power iteration from a fixed start. Explicit steps need ω·h
/// < 2.
double highest_frequency(const Springs& springs, const Vectors& position);

}  // namespace taut
