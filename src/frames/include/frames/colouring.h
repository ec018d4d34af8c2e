#pragma once

#include <string>

#include "scene/scene.h"

namespace taut {

/// Whether tensions mean anything at a time (s) of a scene's run: a method knows them once it has made a
/// step, or never.
bool tension_known(const Scene& scene, double time);

/// Why a scene as it is can't be coloured by what its look says: tension with a method that knows none,
/// limits where there are none. One sentence that says what to do instead; empty where it can.
std::string colour_problem(const Scene& scene);

/// Throws BadRequest with that sentence.
void require_colours(const Scene& scene);

}  // namespace taut
