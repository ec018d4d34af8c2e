#pragma once

#include <cstdint>
#include <vector>

#include "base/image.h"

namespace taut {

/// The image as the bytes of a PNG file: 8 bits a channel, RGB or RGBA. Throws RunFailure when the compressor
/// fails.
std::vector<std::uint8_t> encode_png(const Image& image);

}  // namespace taut
