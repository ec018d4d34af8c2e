#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "relax/vector_room.h"

namespace taut {

/// How many links a kernel takes at once, at most: 32 bytes of numbers.
template <class Real>
inline constexpr std::size_t links_at_once = 32 / sizeof(Real);

/// A stretch of links of which no two share a mass: their slots, a multiple of links_at_once, and what sets
/// them apart from rigid links between equal masses. The others have a place each in the special arrays.
struct LinkStretch {
  std::size_t begin = 0, end = 0;
  std::size_t special = 0;  ///< place of its first link
  /// Where its ends begin among those of all stretches: one a link, or, where places go on by a stride
  /// (bytes, not 0), one every links_at_once links. Where masses are split, the only stride is from one mass
  /// to the next, and slots may have no link, if their length is below 0: for kernels add nothing, ±0, to
  /// what lies at their ends.
  std::size_t ends = 0, stride = 0;
  bool alike = false;     ///< rigid ones with a stride and no gaps, as long as the first one: it tells all
  bool weighted = false;  ///< unequal masses, or a pin
  bool soft = false;      ///< with compliance
  bool damped = false;    ///< and damping
  /// Once the stretches until here, this one included, have been visited: the masses below `begun` are those
  /// that they may have touched, and those below `done` no later one touches.
  std::size_t begun = 0, done = 0;
};

/// How masses go on from where they are, before links are visited. They came there in a step that was
/// 1/inverse_h long, from `previous`, and end_keep and end_gain are what that step ends with:
///   v ← (x − previous) inverse_h end_keep + end_gain,  next = x + h (v keep + gain)
/// Or `previous` holds the velocities themselves.
template <class Real>
struct FreeMotion {
  RoomView<const Real> previous, present;
  bool velocities;
  Real inverse_h;  // 1/s
  Real end_keep, keep, h;
  Packed<Real> end_gain, gain;  // m/s
};

/// Bytes from the x of one mass to that of the next.
template <class Real>
constexpr std::size_t bytes_between(Layout layout) {
  return layout == Layout::packed ? sizeof(Packed<Real>) : sizeof(Real);
}

/// Where the end of a stretch's link lies, of its ends a or b: bytes from the first mass.
template <class Real>
std::uint32_t end_offset(const std::uint32_t* ends, const LinkStretch& stretch, std::size_t slot) {
  const std::size_t link = slot - stretch.begin;
  if (stretch.stride == 0) return ends[stretch.ends + link];
  return ends[stretch.ends + link / links_at_once<Real>] +
         static_cast<std::uint32_t>(link % links_at_once<Real> * stretch.stride);
}

/// What a kernel reads and writes of the links, one array each; relaxation.h has the formulas. With N for the
/// numerator of Δλ and f for one over its denominator, λ changes by f N, and a mass moves by (answer·w f) N
/// n: its share.
template <class Real>
struct LinkArrays {
  const std::uint32_t *a, *b;  // where the masses lie, bytes from the first, as LinkStretch::ends has it
  // One a slot.
  const Real* length;  // m
  Real* multiplier;    // λ
  // Of rigid links between equal masses; either mass moves by half of N.
  Real plain_factor;  // 1/(2 answer·w)
  // One a special place.
  const Real* factor;             // 1/((1 + γ) answer (w_a + w_b) + α̃)
  const Real *share_a, *share_b;  // answer·w_a·factor, answer·w_b·factor
  const Real* scaled;             // α̃, of soft links
  const Real* gamma;              // γ, of damped ones
};

/// Which pass of a step it is. Before the first one multipliers are 0, whatever they hold. A step of one pass
/// need not keep them.
struct PassPlace {
  bool first = true, last = true;
  bool keeps = true;
};

/// Masses, by their places, that some stretches are about: they move freely just ahead of the first link that
/// may touch them, and are looked at after the last one.
struct MassRange {
  std::size_t begin = 0, end = 0;
  std::size_t settled_begin = 0, settled_end = 0;  ///< those of them to be looked at
};

/// One pass along the present directions over these stretches. `start` is read where links are damped. With a
/// `motion` masses come to `position` by it. True when those to be looked at are finite in the end; they are
/// only in the last pass. All rooms have this layout.
template <class Real>
bool relax_along_present(Layout layout, const LinkArrays<Real>& links, std::span<const LinkStretch> stretches,
                         RoomView<const Real> start, const FreeMotion<Real>* motion, const MassRange& masses,
                         PassPlace place, RoomView<Real> position);

/// Whether the masses [begin, end) are finite.
template <class Real>
bool are_finite(Layout layout, RoomView<const Real> position, std::size_t begin, std::size_t end);

/// What the energy of masses is worked out from that have come where they are in a step: with
///   v = (x − before)·inverse_h·keep + gain,  E = m (v²/2 + lift·x)
struct MotionEnergy {
  double inverse_h, keep;     // 1/s, –
  Packed<double> gain, lift;  // m/s; −gravity, m/s²
};

/// The sum of it (J). `mass`: kg, by place; where masses are split, filled up with 0 to a
/// multiple of four.
double energy_of_motion(Layout layout, const MotionEnergy& of, std::span<const double> mass,
                        RoomView<const double> now, RoomView<const double> before);

/// A link that has turned by 90° or more within a step, or is not finite.
struct LostLink {
  std::size_t slot;
  double along;  ///< its d·d₀ (m²)
};

/// What a pass along the directions at the start of the step found.
struct AlongFound {
  double worst = 0.0;  ///< largest ||d|² − l²|/l² that it met; 0 unless judged
  std::vector<LostLink> lost;
};

/// The same of rigid links along their directions at `start`. Lost links are left as they are, and added to
/// those found.
bool relax_along_start(Layout layout, const LinkArrays<double>& links, std::span<const LinkStretch> stretches,
                       RoomView<const double> start, const FreeMotion<double>* motion,
                       const MassRange& masses, PassPlace place, bool judged, RoomView<double> position,
                       AlongFound& found);

}  // namespace taut
