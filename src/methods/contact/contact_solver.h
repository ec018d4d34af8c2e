#pragma once

#include <cstdint>
#include <optional>
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
  /// start and what contacts with static friction had slipped: finds what may touch in this step, at whose
  /// end solids are where they are then.
  void begin_step(const std::vector<ContactSlip>& slips, const Vectors& start, const Vectors& velocity,
                  const Vectors& predicted, double start_time, double end_time);

  /// One pass: pushes what has entered a solid back to its surface, and takes from its way along the surface,
  /// as seen from the solid, what friction allows.
  void solve(Vectors& position);

  /// Whether anything has touched a solid in this step.
  bool touched() const { return touched_; }

  /// How far contacts with static friction have slipped at the end of the step.
  void keep(const Vectors& position, std::vector<ContactSlip>& slips) const;

  /// Once velocities have been derived from positions: what has touched a solid that gives something back
  /// leaves it with that share of the speed at which it came, both as seen from the solid (Müller et al.,
  /// Detailed Rigid Body Simulation with Extended Position Based Dynamics, 2020, eq. 34); but not what
  /// gravity alone could have brought to that speed within two steps, so that things come to rest.
  void rebound(double h, const Vectors& position, Vectors& velocity);

  /// What solids that move have done in this step of h seconds (J): Σ impulse · way of the solid over the
  /// step, at the middle of what touches it, for that is where its impulse acts.
  double work(double h) const { return impulse_way_ / (h * h) + rebound_work_; }

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

  // A solid that moves, at both ends of the step.
  struct Ride {
    std::uint32_t collider;
    Placement start, end;
    Twist start_twist, end_twist;
  };

  void move_solids(double start_time, double end_time);
  const Ride* ride_of(std::uint32_t collider) const;
  static Vec3 way_of(const Ride& ride, const Vec3& place);
  Vec3 moved_since_start(const Pair& pair, const Vectors& position) const;
  bool solves(const Pair& pair) const;
  std::optional<Surface> surface_at(const Pair& pair, const Vec3& x, double reach) const;
  double push_out(std::size_t near, Vectors& position);
  void touch(std::size_t near, const Vec3& normal);

  const Model& model_;
  ContactPoints points_;
  const Vectors* start_ = nullptr;
  bool touched_ = false;
  double impulse_way_ = 0.0, rebound_work_ = 0.0;  // kg m² of pushes, J
  const Vectors* start_velocity_ = nullptr;
  GroundContacts ground_;                // single masses on the ground …
  std::vector<std::uint32_t> touching_;  // … and points that can ever touch anything else
  std::vector<Shape> shapes_;            // of all solids, at the end of the step
  std::vector<std::uint32_t> moving_;    // solids that move, rising
  ColliderTree still_solids_;
  std::optional<ColliderTree> moving_solids_;  // where they are in this step
  std::vector<Ride> rides_;                    // of each of those that move
  bool any_thin_;                              // whether there are solids that may be thin …
  double thin_way_ = 0.0;                      // m, and how far any of those goes in this step
  std::vector<std::uint32_t> around_;          // solids near a point
  std::vector<Pair> near_;                     // that may touch in this step, point by point
  std::vector<bool> has_touched_;              // each of those, a solid that gives something back
  std::vector<StickingFriction> frictions_;    // one for each of those; none without static friction
  std::vector<Touch> touches_;                 // only of colliders that give something back
};

}  // namespace taut
