#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/stop.h"
#include "frames/painter.h"
#include "scene/scene.h"

namespace taut {

/// Throws BadRequest for a time (s) outside the scene's duration.
void check_times(const Scene& scene, const std::vector<double>& times);

/// Writes one picture of a scene at a time (s) as a PNG file. Returns what is odd about it, where something
/// is (picture_notes.h). Settles the scene's view (settled_view.h). Throws BadRequest for a time outside the
/// scene's duration, RunFailure for what goes wrong later, Interrupted when told to stop; a picture that was
/// there before is then still there.
std::optional<std::string> make_still(Scene& scene, double time, const PictureSettings& settings,
                                      const std::filesystem::path& file, const Execution& execution = {},
                                      const StopTest& stop = {});

/// Times from the scene's start to its end at equal distances (s); the start alone for a count of 1. Throws
/// BadRequest for a count that is not a whole number from 1 to 100.
std::vector<double> strip_times(const Scene& scene, double count);

/// Writes pictures of a scene at rising times (s) side by side as one PNG file; the settings' size is that of
/// one picture. Returns and throws as make_still() does, and BadRequest where all together are too wide.
std::optional<std::string> make_strip(Scene& scene, const std::vector<double>& times,
                                      const PictureSettings& settings, const std::filesystem::path& file,
                                      const Execution& execution = {}, const StopTest& stop = {});

}  // namespace taut
