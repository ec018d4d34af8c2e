#pragma once

#include <cstdint>
#include <vector>

#include "model/model.h"

namespace taut {

/// A model's contact points as points that can be moved: each rides on its masses.
class ContactPoints {
 public:
  explicit ContactPoints(const Model& model);

  std::uint32_t size() const { return static_cast<std::uint32_t>(weight_.size()); }
  const ContactPoint& point(std::uint32_t i) const { return model_.contacts[i]; }

  /// Whether any of them remembers where it sticks.
  bool any_static_friction() const { return any_static_friction_; }

  /// How far a unit push moves the point: Σ wₖ sₖ² (1/kg) with the inverse masses wₖ and its weights sₖ on
  /// them; 0 when all its masses are pinned.
  double weight(std::uint32_t i) const { return weight_[i]; }

  /// The point's own position or velocity.
  Vec3 value(std::uint32_t i, const Vectors& of) const { return value_at(model_.contacts[i], of); }

  /// Moves its masses, each as a push at the point would, so that the point goes that way.
  void move(std::uint32_t i, const Vec3& way, Vectors& of) const;

 private:
  const Model& model_;
  std::vector<double> weight_;
  bool any_static_friction_ = false;
};

}  // namespace taut
