#pragma once

#include <vector>

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// How each mass has turned since the start, as a unit quaternion: the mean rotation of its whole links, that
/// is the one that takes their directions at the start as near as it can to their directions now (least
/// squares). With links along one line only, the shortest such turn; without any, none. No force turns a
/// point mass: this is for pictures and exports, and no step reads it.
std::vector<Eigen::Quaterniond> orientations(const Model& model, const State& start, const State& state);

}  // namespace taut
