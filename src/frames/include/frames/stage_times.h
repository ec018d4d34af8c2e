#pragma once

#include <string_view>
#include <vector>

namespace taut {

/// What making frames took in one stage.
struct StageTime {
  std::string_view name;
  double seconds = 0.0;  ///< of a processor, on all threads of that stage
};

/// In the order in which frames pass through them:
/// simulate (the motion), shape (what is seen of it), draw (OpenGL's own thread: vertices and triangles),
/// rasterise (Mesa's threads: pixels; nothing where a graphics card draws), flatten (parts of the picture
/// laid over each other), compress (PNG), write (files), feed (pictures to the film's encoder), encode (that
/// encoder, another process).
using StageSeconds = std::vector<StageTime>;

}  // namespace taut
