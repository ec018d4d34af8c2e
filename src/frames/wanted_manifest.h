#pragma once

#include <span>
#include <string>

#include "frames/frames.h"
#include "output/manifest.h"
#include "scene/scene.h"

namespace taut {

/// The manifest of frames that are asked for: all but the frames themselves.
Manifest frames_manifest(std::span<const Scene> scenes, const RenderRequest& request);

/// A hash of what decides the moments of a motion: camera and look, but for look.speed, change nothing in
/// them.
std::string motion_inputs(const Scene& scene, const FrameRate& rate);

/// The manifest of a motion without pictures, with those inputs. `plan`: why the scene is run as it is; may
/// be empty.
Manifest motion_manifest(const Scene& scene, const FrameRate& rate, const std::string& plan);

}  // namespace taut
