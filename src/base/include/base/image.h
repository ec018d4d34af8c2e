#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace taut {

/// A size in pixels.
struct Size {
  int width = 1280;
  int height = 720;
};

/// 8-bit pixels, sRGB, row by row from the top, without padding. `channels` is 3 (RGB) or 4 (RGBA, straight
/// alpha).
struct Image {
  Size size{0, 0};
  int channels = 3;
  std::vector<std::uint8_t> pixels;

  /// An all-zero image of the given size and channel count.
  static Image blank(Size size, int channels) {
    const auto bytes = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    return Image{size, channels, std::vector<std::uint8_t>(bytes * static_cast<std::size_t>(channels))};
  }
};

}  // namespace taut
