#pragma once

#include <vector>

#include "base/vectors.h"
#include "model/model.h"
#include "model/state.h"
#include "view/view.h"

namespace taut {

/// A ball that reaches around an end or a corner of something.
struct Reach {
  Vec3 place;     ///< m
  double radius;  ///< m
};

/// What a picture has to show for that which holds a scene's pins to be whole in it from the pins upwards.
struct SupportReach {
  /// Seen from a mass that it moves along with.
  struct Carried {
    Index mass;
    Reach reach;
  };
  /// Rails, brackets and the tops of poles and posts: those may be as high as they like.
  std::vector<Reach> fixed;
  std::vector<Carried> carried;
};

/// Nothing where the look has no supports. `up`: unit length.
SupportReach reach_of_supports(const Model& model, const State& start, const Look& look, const Vec3& up);

}  // namespace taut
