#pragma once

#include <vector>

#include "model/state.h"

namespace taut {

/// The part of a way that lies along a surface.
inline Vec3 along_surface(const Vec3& normal, const Vec3& way) {
  return way - normal * way.dot(normal);
}

/// Coulomb's bound: a vector, shortened where it is longer than friction can hold.
template <class Vector>
Vector no_longer_than(double most, const Vector& vector) {
  const double size = vector.norm();
  return size > most ? Vector(vector * (most / size)) : vector;
}

/// Coulomb's law for the position changes of one step (Macklin et al., Unified Particle Physics, 2014, eq.
/// 24): what is taken from the way along a surface of something pushed back by `depth` (m) along its unit
/// normal, that has `moved` (m) since the start of the step; at most coefficient × depth.
inline Vec3 coulomb_friction(double coefficient, double depth, const Vec3& normal, const Vec3& moved) {
  return -no_longer_than<Vec3>(coefficient * depth, along_surface(normal, moved));
}

/// coulomb_friction() for a contact with static friction: summed over the passes of a step, and with a
/// memory.
///
/// The way to be taken back is the slip that the step began with, and what the contact has moved along the
/// surface since. At the end of the step a part of it is left: what the links have not yet answered.
/// Forgotten, it would be left again in every step, as a creep of that much a step; kept, it is what loads
/// the contact until friction balances the pull, as the tangential spring of Cundall and Strack does (A
/// discrete numerical model for granular assemblies, 1979). It is bounded by what friction can hold.
class StickingFriction {
 public:
  explicit StickingFriction(const Vec3& slip) : slip_(slip) {}

  /// A pass, with arguments as coulomb_friction().
  Vec3 hold(double coefficient, double depth, const Vec3& normal, const Vec3& moved) {
    pushed_ += depth;
    normal_ = normal;
    most_ = coefficient * pushed_;
    const Vec3 before = held_;
    held_ = no_longer_than<Vec3>(most_, held_ - along_surface(normal_, slip_ + moved));
    return held_ - before;
  }

  bool touched() const { return pushed_ > 0.0; }

  /// The slip to be kept for the next step.
  Vec3 slip(const Vec3& moved) const {
    return no_longer_than<Vec3>(most_, along_surface(normal_, slip_ + moved));
  }

 private:
  Vec3 slip_ = Vec3::Zero();
  Vec3 held_ = Vec3::Zero();  // m, taken from the way by all passes
  Vec3 normal_ = Vec3::UnitY();
  double pushed_ = 0.0, most_ = 0.0;  // m
};

/// Looks up what contacts have slipped, in the order in which that is kept.
class ContactSlipReader {
 public:
  explicit ContactSlipReader(const std::vector<ContactSlip>& slips) : grips_(slips) {}

  /// The slip of a contact that comes after all that have been asked for; zero where there is none.
  Vec3 slip(Index a, Index b) {
    while (next_ < grips_.size() && (grips_[next_].a < a || (grips_[next_].a == a && grips_[next_].b < b)))
      ++next_;
    const bool found = next_ < grips_.size() && grips_[next_].a == a && grips_[next_].b == b;
    return found ? grips_[next_].slip : Vec3::Zero();
  }

 private:
  const std::vector<ContactSlip>& grips_;
  std::size_t next_ = 0;
};

}  // namespace taut
