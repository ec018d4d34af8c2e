#pragma once

#include <cstddef>
#include <span>

#include "base/vectors.h"
#include "relax/packed.h"

namespace taut {

/// How many links a kernel takes at once, at most: 32 bytes of numbers.
template <class Real>
inline constexpr std::size_t links_at_once = 32 / sizeof(Real);

/// A stretch of links of which no two share a mass: their slots, a multiple of links_at_once, and what sets
/// them apart from rigid links between equal masses. The others have a place each in the special arrays.
struct LinkStretch {
  std::size_t begin = 0, end = 0;
  std::size_t special = 0;  ///< place of its first link
  bool weighted = false;    ///< unequal masses, or a pin
  bool soft = false;        ///< with compliance
  bool damped = false;      ///< and damping
};

/// What a kernel reads and writes of the links, one array each; relaxation.h has the formulas.
template <class Real>
struct LinkArrays {
  // One a slot.
  const Index *a, *b;  // places of the masses
  const Real* length;  // m
  Real* multiplier;    // λ
  // Of rigid links between equal masses.
  Real plain_move;    // answer·w
  Real plain_factor;  // 1/(2 answer·w)
  // One a special place.
  const Real *move_a, *move_b;  // answer·w_a, answer·w_b
  const Real* factor;           // 1/((1 + γ) answer (w_a + w_b) + α̃)
  const Real* scaled;           // α̃, of soft links
  const Real* gamma;            // γ, of damped ones
};

/// One pass along the present directions over these stretches. `start` is read where links are damped.
template <class Real>
void relax_along_present(const LinkArrays<Real>& links, std::span<const LinkStretch> stretches,
                         const Packed<Real>* start, Packed<Real>* position);

/// What a pass along the directions at the start of the step found.
struct AlongFound {
  static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);
  double worst = 0.0;          ///< largest ||d|² − l²|/l² that it met; 0 unless asked for
  std::size_t lost = nowhere;  ///< first slot whose link has turned by 90° or more, or is not finite …
  double lost_along = 0.0;     ///< … and its d·d₀ (m²)
};

/// One pass of rigid links along these directions, one a slot. Lost links are left as they are.
AlongFound relax_along_start(const LinkArrays<double>& links, std::span<const LinkStretch> stretches,
                             const Packed<double>* direction, bool judged, Packed<double>* position);

/// directions[slot] = position[a] − position[b], for so many slots.
void link_directions(const Index* a, const Index* b, std::size_t slots, const Packed<double>* position,
                     Packed<double>* direction);

}  // namespace taut
