#pragma once

#include <filesystem>
#include <string>

#include "scene/scene.h"
#include "study/stability_map.h"

namespace taut {

/// Writes what is known of the maps into a folder: cells.csv, edges.csv and maps.json, a PNG and an SVG for
/// every method under its name, and one with all methods side by side, overview, with its caption as .txt.
/// Throws RunFailure, and Interrupted.
void write_stability_files(const StabilityMaps& maps, const Scene& scene, const std::filesystem::path& folder,
                           const StopTest& stop = {});

/// The maps as JSON text: axes, values, counts of columns planned and completed, build, and every column.
std::string stability_json(const StabilityMaps& maps, const Scene& scene);

}  // namespace taut
