#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "base/image.h"

namespace taut {

/// An image of 16 bits a channel as the bytes of a TIFF file: RGB, or RGBA with straight alpha, compressed
/// without loss. Throws RunFailure when there is no memory.
std::vector<std::uint8_t> encode_tiff(const Image& image);

/// The pixels of a file as encode_tiff() gave it. `name` is for the message. Throws RunFailure where the
/// bytes are no such file.
Image decode_tiff(std::string_view bytes, const std::filesystem::path& name);

/// True when the file is a picture of that size as encode_tiff() gave it. Reads all of it.
bool is_whole_tiff(const std::filesystem::path& file, Size size);

}  // namespace taut
