#pragma once

#include "base/image.h"

namespace taut {

/// Draws `lines` behind what a picture shows: where the picture looks like the backdrop, which has nothing in
/// it, it becomes like `lines`, and stays as it is where anything else is seen. All three have the same size
/// and channels.
void show_behind(const Image& backdrop, const Image& lines, Image& picture);

}  // namespace taut
