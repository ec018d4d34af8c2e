#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>

#include "output/png_check.h"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb_image.h>

namespace taut {
namespace {

struct FreePixels {
  void operator()(unsigned char* pixels) const { stbi_image_free(pixels); }
};

}  // namespace

bool is_blank_png(const std::filesystem::path& file) {
  constexpr int channels = 3;
  int width = 0, height = 0, channels_there = 0;
  const std::unique_ptr<unsigned char, FreePixels> pixels(
      stbi_load(file.c_str(), &width, &height, &channels_there, channels));
  if (!pixels) return true;
  const std::span all(pixels.get(),
                      static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * channels);
  // Alike with its neighbour, each.
  return std::equal(all.begin() + channels, all.end(), all.begin());
}

}  // namespace taut
