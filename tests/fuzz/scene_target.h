#pragma once

#include <string>

namespace taut::testing {

/// How far a text is taken.
enum class Depth {
  geometry,  ///< read, built, stepped, and what a picture would show worked out
  picture,   ///< drawn, too
};

/// Reads a text as a scene, writes and reads it resolved, makes ten steps and a picture of 64×64 of it. What
/// is refused is refused by a message; anything else that goes wrong ends the process. Scenes of more than a
/// few hundred masses or links are left alone.
void try_scene(const std::string& text, Depth depth);

}  // namespace taut::testing
