#include "read_picture.h"

#include <cstddef>

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb_image.h>

namespace taut::testing {

Pixels read_picture(const std::string& file) {
  Pixels pixels;
  int channels = 0;
  unsigned char* data = stbi_load(file.c_str(), &pixels.width, &pixels.height, &channels, 3);
  if (data == nullptr) return pixels;
  pixels.rgb.assign(data, data + 3 * static_cast<std::ptrdiff_t>(pixels.width) * pixels.height);
  stbi_image_free(data);
  return pixels;
}

}  // namespace taut::testing
