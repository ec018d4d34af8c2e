#pragma once

#include <cstdint>
#include <vector>

#include "contact/collider_tree.h"
#include "contact/contact_points.h"
#include "contact/friction.h"
#include "contact/ground_contacts.h"

namespace taut {

/// Contact of a model's contact points with its colliders, for methods that move positions and derive
/// velocities from them.
class ContactSolver {
 public:
  explicit ContactSolver(const Model& model);

  /// To be called once positions of the step have been predicted, with the positions and velocities at its
  /// start and what contacts with static friction had slipped: finds what may touch in this step.
  void begin_step(const std::vector<ContactSlip>& slips, const Vectors& start, const Vectors& velocity,
                  const Vectors& predicted);

  /// One pass: pushes what has entered a solid back to its surface, and takes from its way along the surface
  /// what friction allows.
  void solve(Vectors& position);

  /// Whether anything has touched a solid in this step.
  bool touched() const { return touched_; }

  /// How far contacts with static friction have slipped at the end of the step.
  void keep(const Vectors& position, std::vector<ContactSlip>& slips) const;

  /// Once velocities have been derived from positions: what has touched a solid that gives something back
  /// leaves it with that share of the speed at which it came (Müller et al., Detailed Rigid Body Simulation
  /// with Extended Position Based Dynamics, 2020, eq. 34); but not what gravity alone could have brought to
  /// that speed within two steps, so that things come to rest.
  void rebound(double h, Vectors& velocity) const;

 private:
  // A contact point and a collider.
  struct Pair {
    std::uint32_t point, collider;
  };
  // Those that have touched in this step.
  struct Touch {
    Pair pair;
    Vec3 normal;
    double approach;  // m/s along the normal at the start of the step; negative: towards the solid
  };

  bool solves(const Pair& pair) const;
  void touch(std::size_t near, const Vec3& normal);

  const Model& model_;
  ContactPoints points_;
  const Vectors* start_ = nullptr;
  bool touched_ = false;
  const Vectors* start_velocity_ = nullptr;
  GroundContacts ground_;                // single masses on the ground …
  std::vector<std::uint32_t> touching_;  // … and points that can ever touch anything else
  ColliderTree solids_;
  std::vector<std::uint32_t> around_;        // solids near a point
  std::vector<Pair> near_;                   // that may touch in this step, point by point
  std::vector<bool> has_touched_;            // each of those, a solid that gives something back
  std::vector<StickingFriction> frictions_;  // one for each of those; none without static friction
  std::vector<Touch> touches_;               // only of colliders that give something back
};

}  // namespace taut
