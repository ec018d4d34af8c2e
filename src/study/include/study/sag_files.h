#pragma once

#include <filesystem>
#include <string>

#include "base/stop.h"
#include "frames/painter.h"
#include "study/sag.h"

namespace taut {

/// Writes what a study found into a folder: sag.png (the contact sheet), sag-over-passes.png and .svg (the
/// chart), sag.csv and sag.json. Each is there whole or as it was before. Throws RunFailure, and
/// Interrupted.
void write_sag_files(const Scene& scene, const SagStudy& study, const PictureSettings& settings,
                     const std::filesystem::path& folder, const StopTest& stop = {});

/// The study as JSON text.
std::string sag_json(const Scene& scene, const SagStudy& study);

}  // namespace taut
