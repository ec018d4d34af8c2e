#pragma once

#include <memory>

#include "base/image.h"

namespace taut {

/// The parts of a drawn picture, before they are laid over each other: see layers.cpp.
struct Layers;

/// The picture: RGB, or RGBA with straight alpha when transparent, of as many bits as it was drawn with.
/// Needs no OpenGL, and may run in another thread than what drew.
Image flatten(const Layers& layers);

}  // namespace taut
