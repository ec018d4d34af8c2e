#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "contact/contact_points.h"
#include "contact/friction.h"
#include "model/near_balls.h"

namespace taut {

/// Contact between the contact points of different bodies, as balls. Pairs that may meet are looked for
/// when balls have moved.
class BodyContacts {
 public:
  explicit BodyContacts(const Model& model);

  /// To be called once positions of the step have been predicted; `start` are those at its start, `slips`
  /// what contacts with static friction had slipped there.
  void begin_step(const std::vector<ContactSlip>& slips, const Vectors& start, const Vectors& predicted);

  /// One pass over the pairs: pushes those that overlap apart, and takes from their sliding on one another
  /// what friction allows.
  void solve(Vectors& position);

  /// Whether any have touched in this step.
  bool touched() const { return touched_; }

  /// What balls that are moved by pins have done to others in this step of h seconds (J).
  double work(double h) const { return impulse_way_ / (h * h); }

  /// Whether more balls are near each other than can be solved; then none is, and the step is none.
  bool crowded() const { return crowded_; }

  /// How far contacts with static friction have slipped at the end of the step.
  void keep(const Vectors& position, std::vector<ContactSlip>& slips) const;

 private:
  bool moved_since_search(const Vectors& position) const;
  Vec3 way_of(std::uint32_t point, const Vectors& position) const;
  Vec3 moved(std::uint32_t a, std::uint32_t b, const Vectors& position) const;
  static std::vector<BodyBall> touching_balls(const Model& model, std::vector<std::uint32_t>& points);

  ContactPoints points_;
  std::vector<std::uint32_t> balls_;  // those of the points that touch others
  NearBalls near_;
  bool any_faces_;                           // corners of faces don't touch each other, nor balls, as balls
  std::vector<Vec3> centres_;                // at the last search
  NearBalls::Pairs pairs_;                   // of points
  std::vector<StickingFriction> frictions_;  // one a pair, of this step; none without static friction
  const Vectors* start_ = nullptr;
  bool touched_ = false, crowded_ = false;
  double impulse_way_ = 0.0;  // kg m²
};

}  // namespace taut
