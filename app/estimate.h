#pragma once

#include <cstddef>
#include <string>

#include "scene/scene.h"

namespace taut {

/// How much memory and time a description of that size takes to be built, as a sentence; empty for one that
/// is built at once.
std::string size_note(const Counts& counts);

/// How long simulating all of a scene takes with its settings, and how much memory, as a sentence; empty
/// where neither is much. The time is what the prices of the registry come to on one core of an ordinary
/// machine. `picture_bytes`: what drawing takes of memory beside.
std::string run_note(const Scene& scene, double picture_bytes);

/// How long drawing so many frames takes, as a sentence; empty where that is not long.
std::string drawing_note(std::size_t frames, double seconds);

}  // namespace taut
