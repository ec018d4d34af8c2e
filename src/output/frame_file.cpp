#include "output/frame_file.h"

#include "output/png.h"
#include "output/png_check.h"
#include "output/png_read.h"
#include "output/tiff.h"

namespace taut {

std::string_view frame_ending(int bits) {
  return bits == 16 ? ".tif" : ".png";
}

std::vector<std::uint8_t> encode_frame(const Image& image) {
  return image.bits == 16 ? encode_tiff(image) : encode_png(image);
}

Image decode_frame(std::string_view bytes, int bits, const std::filesystem::path& name) {
  return bits == 16 ? decode_tiff(bytes, name) : decode_png(bytes, name);
}

bool is_whole_frame(const std::filesystem::path& file, Size size, int bits) {
  return bits == 16 ? is_whole_tiff(file, size) : is_whole_png(file, size);
}

}  // namespace taut
