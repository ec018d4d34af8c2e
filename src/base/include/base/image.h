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

/// Pixels as on a display (sRGB), row by row from the top, without padding. `channels` is 3 (RGB) or 4 (RGBA,
/// straight alpha).
struct Image {
  Size size{0, 0};
  int channels = 3;
  std::vector<std::uint8_t> pixels;  ///< the bytes of all samples; of 16 bits as the machine has them
  int bits = 8;                      ///< of a sample: 8 or 16

  /// An all-zero image of the given size and channel count.
  static Image blank(Size size, int channels, int bits = 8) {
    const auto samples = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) *
                         static_cast<std::size_t>(channels);
    return Image{size, channels, std::vector<std::uint8_t>(samples * static_cast<std::size_t>(bits / 8)),
                 bits};
  }

  std::size_t bytes_of_pixel() const {
    return static_cast<std::size_t>(channels) * static_cast<std::size_t>(bits / 8);
  }
};

}  // namespace taut
