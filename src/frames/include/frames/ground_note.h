#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"

namespace taut {

/// What to say of a picture of a state in which masses are below a drawn ground that stops nothing, such as
/// people take for a floor; nothing where none are, where the ground isn't drawn or where the eye, too, is
/// below it.
std::optional<std::string> ground_note(const Scene& scene, const State& state);

}  // namespace taut
