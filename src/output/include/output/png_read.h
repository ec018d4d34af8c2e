#pragma once

#include <filesystem>
#include <string_view>

#include "base/image.h"

namespace taut {

/// The pixels of a PNG file as encode_png() gave it: RGB or RGBA of eight bits. `name` is for the message.
/// Throws RunFailure where the bytes are no such file.
Image decode_png(std::string_view bytes, const std::filesystem::path& name);

}  // namespace taut
