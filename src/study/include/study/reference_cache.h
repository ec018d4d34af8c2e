#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/stop.h"
#include "measure/reference.h"
#include "scene/scene.h"

namespace taut {

/// The folder for references: TAUT_CACHE, or taut in XDG_CACHE_HOME, or in ~/.cache.
std::filesystem::path reference_folder();

/// The physics of a scene alone, as TOML: what it is solved with and how it is looked at make no difference
/// to the truth.
std::string physics_toml(const Scene& scene);

/// make_reference() for a scene, kept in a file whose name covers the scene's physics, the times, the
/// accuracy, most_seconds and the build; a second call with the same reads that file. A folder that can't be
/// written only costs the time. Refusals are kept too. Throws Interrupted.
Reference cached_reference(const Scene& scene, const std::vector<double>& times, double accuracy,
                           const std::filesystem::path& folder = reference_folder(),
                           double most_seconds = 10.0, const StopTest& stop = {});

}  // namespace taut
