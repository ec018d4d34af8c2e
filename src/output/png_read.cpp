#include "output/png_read.h"

#include <fmt/format.h>

#include <limits>
#include <memory>

#include "base/failure.h"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb_image.h>

namespace taut {
namespace {

struct FreePixels {
  void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

}  // namespace

Image decode_png(std::string_view bytes, const std::filesystem::path& name) {
  Image image;
  const bool countable = bytes.size() <= static_cast<std::size_t>(std::numeric_limits<int>::max());
  const std::unique_ptr<stbi_uc, FreePixels> pixels(
      countable ? stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                                        static_cast<int>(bytes.size()), &image.size.width, &image.size.height,
                                        &image.channels, 0)
                : nullptr);
  if (!pixels || image.channels < 3)
    throw RunFailure(fmt::format("{} is not a whole picture", name.string()));
  const auto count = static_cast<std::ptrdiff_t>(image.size.width) * image.size.height * image.channels;
  image.pixels.assign(pixels.get(), pixels.get() + count);
  return image;
}

}  // namespace taut
