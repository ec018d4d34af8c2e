#include "picture_behind.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace taut {

void show_behind(const Image& backdrop, const Image& lines, Image& picture) {
  constexpr int noise = 2, full = 30;  // of 255: differences that mean nothing, and those of a thing itself
  const auto channels = static_cast<std::size_t>(picture.channels);
  for (std::size_t at = 0; at < picture.pixels.size(); at += channels) {
    int difference = 0;
    for (std::size_t i = at; i < at + channels; ++i)
      difference = std::max(difference, std::abs(picture.pixels[i] - backdrop.pixels[i]));
    const int share = std::clamp(difference - noise, 0, full);
    for (std::size_t i = at; i < at + channels; ++i)
      picture.pixels[i] =
          static_cast<std::uint8_t>((picture.pixels[i] * share + lines.pixels[i] * (full - share)) / full);
  }
}

}  // namespace taut
