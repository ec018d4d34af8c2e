#pragma once

#include <optional>
#include <vector>

#include "model/model.h"
#include "view/view.h"

namespace taut {

/// A plane that is drawn.
struct Ground {
  Vec3 point = Vec3::Zero();    ///< m, anywhere on it
  Vec3 normal = Vec3::UnitY();  ///< unit length
  bool solid = false;           ///< whether it stops anything; else it is only there to see heights by
  std::optional<Colour> colour = std::nullopt;  ///< its own; left out: the theme's
};

/// What is drawn as ground at a time (s), for pictures in which `up` (unit length) is up: the model's planes,
/// a level one at the look's height where that is given; in a model without planes a level place that stops
/// nothing, at the look's height or through the origin. Nothing where the look has no ground, and no plane
/// that is hidden.
std::vector<Ground> drawn_grounds(const Model& model, const Look& look, const Vec3& up, double time = 0.0);

}  // namespace taut
