#pragma once

#include <array>
#include <vector>

#include "model/model.h"

namespace taut {

/// The masses of a body's limbs on one side. The two of a hinge are left and right as the body sees it.
struct Limbs {
  Index shoulder = 0, wrist = 0, hand = 0, hip = 0, ankle = 0, toe = 0;
  std::array<Index, 2> elbow{}, knee{};
};

/// Which mass of a ragdoll is what.
struct BodyParts {
  double height = 0.0;  ///< m
  Index head = 0, chest = 0, back = 0;
  Limbs left, right;
};

/// Those of all ragdolls of a model, by their masses' names. A name that is missing is an std::logic_error.
std::vector<BodyParts> body_parts(const Model& model);

}  // namespace taut
