#pragma once

#include <algorithm>

namespace taut {

/// How many threads each stage has that can use several. Mesa's rasteriser takes one a core itself, and the
/// solver what RenderRequest::execution says; simulating, shaping and drawing are one more each.
struct ThreadBudget {
  int finishing = 1;  ///< that lay pictures together and compress them
  int film = 1;       ///< of the film's encoder
};

/// A frame is drawn in some five times the time in which it is finished, and encoders gain little from more
/// than eight threads at the size of a film.
inline ThreadBudget thread_budget(int cores) {
  return {std::clamp(cores / 4, 1, 8), std::clamp(cores, 1, 8)};
}

}  // namespace taut
