#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "base/image.h"

namespace taut {

/// The ending of a frame's file, with its dot: PNG for 8 bits a channel, TIFF for 16.
std::string_view frame_ending(int bits);

/// A frame as the bytes of its file. Throws RunFailure.
std::vector<std::uint8_t> encode_frame(const Image& image);

/// The pixels of a frame's file of so many bits a channel. Throws RunFailure where the bytes are no such
/// file.
Image decode_frame(std::string_view bytes, int bits, const std::filesystem::path& name);

/// True when the file is a frame of that size and of so many bits.
bool is_whole_frame(const std::filesystem::path& file, Size size, int bits);

}  // namespace taut
