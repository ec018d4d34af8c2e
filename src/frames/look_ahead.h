#pragma once

#include <functional>

#include "base/stop.h"
#include "model/state.h"
#include "scene/scene.h"

namespace taut {

/// Shows states of the whole of a scene, from its start to its end, by a run that is cheap rather than exact:
/// enough to see where things go. Where it comes to nothing the start is all there is. Throws Interrupted.
void look_ahead(const Scene& scene, const StopTest& stop, const std::function<void(const State&)>& see);

}  // namespace taut
