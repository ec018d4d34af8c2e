#pragma once

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "base/workers.h"
#include "direct/link_system.h"
#include "high_order/phase_sums.h"
#include "model/model.h"

namespace taut {

/// So many links at most are worked on at once: what they take stays in the nearest cache, and is long enough
/// for memory to read ahead.
inline constexpr std::size_t most_block_links = 512;

/// Links that follow each other: link `link` + k joins the masses `mass` + k and `mass` + k + 1. Of the
/// masses `mass` + k between the links `link` + k − 1 and `link` + k, those from `inner_begin` to before
/// `inner_end` are moved with the block.
struct ChainBlock {
  std::size_t link = 0, count = 0, mass = 0, inner_begin = 0, inner_end = 0;
};

/// A mass that is moved with no block: an end of a chain, or a pin.
struct SingleMass {
  std::size_t mass = 0, count = 0;    ///< how many links it has, of those with a free end
  std::array<std::size_t, 2> link{};  ///< which, if it isn't a pin
  std::array<double, 2> pull{};       ///< 1/kg, along their directions
  bool pinned = false;
};

/// Chains on which nothing acts but gravity and rigid links, whose masses follow each other, in the order of
/// their elimination.
struct ChainLinks {
  std::size_t count = 0;
  std::size_t middle = 0;               ///< what is before it is eliminated upwards, the rest downwards
  std::vector<ChainBlock> front, back;  ///< of both halves, from the ends to the middle
  bool is_short = false;                ///< one block of each half, and both beside each other:
  ChainBlock whole;                     ///< both of them, if so, for what moves no masses
  std::vector<double> coupling;         ///< ± 1/kg, [i] of links i − 1 and i; 0 at both ends
  std::vector<double> inverse_mass;     ///< 1/kg
  std::vector<double> length;           ///< m
  /// Links with a pin at one end, rising, and whether that is the lower mass: gravity changes their length.
  std::vector<std::pair<std::size_t, bool>> hung;
  std::vector<SingleMass> singles;
  Vec3 gravity = Vec3::Zero();  ///< m/s²
};

/// Room for an evaluation.
struct ChainRoom {
  std::array<std::vector<double>, 3> direction;  ///< m, [i + 1]: the lower mass of link i less the higher one
  std::vector<double> passed;  ///< [i]: what link i or i − 1 takes of the other, from the middle outwards
  std::vector<double> strength;
  Vectors corrected;
};

/// The equations of motion of such chains, in two passes over memory, and the way back onto their links. Of
/// long ones two threads take a half each, with the same bits.
class ChainMotion {
 public:
  ChainMotion(ChainLinks links, std::shared_ptr<Workers> workers);

  /// Accelerations and multipliers (N/m) there. False when the links' system is singular, or something is not
  /// finite.
  bool evaluate(const PhaseSums& at, Vectors& acceleration, std::vector<double>& multipliers);

  /// The largest error in a link's length, as a share of it; NaN where something is not finite.
  double length_error(const Vectors& position) const;
  /// The largest speed (m/s) at which links change their lengths; NaN where something is not finite.
  double speed_along(const Vectors& position, const Vectors& velocity) const;

  /// A round of Newton's method towards the links' lengths, as little as can be in the metric of mass. False
  /// when that can't be done.
  bool correct(Vectors& position);
  /// Takes from velocities what changes lengths.
  bool correct(const Vectors& position, Vectors& velocity);

 private:
  ChainLinks links_;
  std::shared_ptr<Workers> workers_;  // null: the calling thread alone
  ChainRoom room_;
};

/// Nothing where masses do not follow each other, or something but gravity and rigid links acts; stops on
/// angles that are not held don't count.
std::unique_ptr<ChainMotion> make_chain_motion(const Model& model, const LinkSystem& system,
                                               const std::shared_ptr<Workers>& workers);

}  // namespace taut
