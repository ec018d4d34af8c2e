#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"

namespace taut {

/// Why a look that asks for the exact shape at rest can't have it: one sentence; empty where it can, or where
/// it doesn't ask.
std::string exact_problem(const Scene& scene);

/// Throws BadRequest with that sentence.
void require_exact(const Scene& scene);

/// The exact shape at rest (exact_rest_shape()) where the look asks for it. Throws RunFailure where the scene
/// doesn't come to rest.
std::optional<State> exact_shape(const Scene& scene);

}  // namespace taut
