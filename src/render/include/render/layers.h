#pragma once

#include <memory>

#include "base/image.h"

namespace taut {

/// The parts of a drawn picture, before they are laid over each other: see layers.cpp.
struct Layers;

/// The picture: RGB, or RGBA with straight alpha when transparent, of as many bits as it was drawn with.
/// With what its colours mean, if they mean anything and that is wanted. Needs no OpenGL, and may run in
/// another thread than what drew.
Image flatten(const Layers& layers, bool with_legend = true);
/// Whether colours mean anything.
bool has_legend(const Layers& layers);

}  // namespace taut
