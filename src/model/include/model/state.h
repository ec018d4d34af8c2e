#pragma once

#include <cstdint>
#include <vector>

#include "base/vectors.h"
#include "model/model.h"

namespace taut {

/// How far a contact that sticks has given way (m): what friction takes back in the steps to come.
struct ContactSlip {
  Index a = 0, b = 0;  ///< a contact point, and a collider or another contact point
  Vec3 slip = Vec3::Zero();
};

/// What friction at rest remembers. Without it a contact that sticks would let go of what one step leaves
/// undone, every step, and creep.
struct StaticFriction {
  std::vector<ContactSlip>
      solids;  ///< contact points with static friction, on colliders, in order of a and then b
  std::vector<ContactSlip> bodies;  ///< the same on one another, in the same order
  std::vector<Vec3> joints;  ///< rad, one a joint: how far it has given way, along JointAngles' directions
};

/// A limit on an angle that a method which knows when stops are met and left holds at one end of its range,
/// +1 the upper or −1 the lower: a hard one stays there, a soft one pushes back from beyond it.
struct HeldStop {
  Index limit = 0;
  double sign = 1.0;

  bool operator==(const HeldStop&) const = default;
};

/// What a method that chooses its own steps takes along.
struct OwnSteps {
  double next = 0.0;  ///< s, the length it wants to try next; 0: it is yet to find one
  /// Whether it is known which stops are held: not before the first step, or after something has broken.
  bool settled = false;
  std::vector<HeldStop> held;
};

/// Everything about a scene's physics that moves. Positions and velocities hold for the same time.
struct State {
  double time = 0.0;  ///< s
  Vectors position;   ///< m, one a mass
  Vectors velocity;   ///< m/s, one a mass
  std::vector<double>
      tension;  ///< N, one a link, pull positive; 0 until a method that knows it has made a step
  std::vector<double> broken_at;  ///< s, one a link; infinity while the link is whole

  StaticFriction static_friction;

  /// How long a kick of gravity, loads, drag, wind and springs (s) the velocities hold that rigid links have
  /// not answered yet: half the last step with methods whose Capabilities say half_kicked, 0 at the start.
  double unanswered_kick = 0.0;
  /// N, one a link: the tension at the start of the last step, for a method that continues it to the end of
  /// the next one; empty where that can't be done, as after a break.
  std::vector<double> tension_before;
  OwnSteps own_steps;

  bool broken(std::size_t link) const { return broken_at[link] != infinity; }
};

/// Hash of time, positions, velocities, broken links and what friction holds: equal exactly when those are
/// equal bit for bit.
std::uint64_t state_hash(const State& state);

/// True when every one of the vectors is finite.
bool all_finite(const Vectors& vectors);

/// True when time and all positions and velocities are finite.
bool all_finite(const State& state);

/// Length of a link now (m).
double link_distance(const Model& model, const Vectors& position, std::size_t link);

/// Puts every pin where it belongs at a time, and gives it the velocity it has there (zero for pins at rest).
void place_pins(const Model& model, double time, Vectors& position, Vectors& velocity);

/// How positions are found between two steps: along the cubic Hermite curve through both positions and
/// velocities, or along the straight line (for methods whose velocities are not their positions' derivative).
enum class Interpolation { hermite, linear };

/// The state between two neighbouring ones (velocities: the derivative of the positions; tensions: along the
/// straight line, but for links without any before, which a method may not have met yet); what broke between
/// the two counts as broken from its own time on.
State interpolate(const State& before, const State& after, double time, Interpolation kind);

}  // namespace taut
