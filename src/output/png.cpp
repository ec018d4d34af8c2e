#include "output/png.h"

#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>

#include <array>
#include <cstdlib>
#include <memory>

#include "base/failure.h"

// stb_image_write puts PNG files together. As it comes it takes ten times as long as a frame may: it tries
// every filter on every row, and its compressor is a simple one. So it is told one filter, and is given
// ISA-L's compressor and checksum through its own hooks; tests/bench/png_bench.cpp has what that brings.

namespace taut {
namespace {

/// A zlib stream in memory from malloc(), as stb wants it; null when there is none left. The level is
/// ISA-L's.
unsigned char* compress_for_stb(unsigned char* from, int length, int* compressed_length, int level) {
  std::array<std::uint8_t, ISAL_DEF_LVL1_DEFAULT> workspace;
  isal_zstream stream;
  isal_deflate_init(&stream);
  stream.level = static_cast<std::uint32_t>(level);
  stream.level_buf = workspace.data();
  stream.level_buf_size = static_cast<std::uint32_t>(workspace.size());
  stream.gzip_flag = IGZIP_ZLIB;
  stream.end_of_stream = 1;
  stream.next_in = from;
  stream.avail_in = static_cast<std::uint32_t>(length);
  // Deflate's worst case is stored blocks: five bytes for every 65,535, and a few at the ends.
  stream.avail_out = stream.avail_in + 5 * (stream.avail_in / 65535 + 1) + 512;
  auto* const to = static_cast<unsigned char*>(std::malloc(stream.avail_out));
  if (to == nullptr) return nullptr;
  stream.next_out = to;
  if (isal_deflate(&stream) != COMP_OK || stream.avail_in != 0 || stream.internal_state.state != ZSTATE_END) {
    std::free(to);
    return nullptr;
  }
  *compressed_length = static_cast<int>(stream.total_out);
  return to;
}

unsigned checksum_for_stb(unsigned char* bytes, int length) {
  return crc32_gzip_refl(0, bytes, static_cast<std::uint64_t>(length));
}

}  // namespace
}  // namespace taut

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBIW_ZLIB_COMPRESS taut::compress_for_stb
#define STBIW_CRC32 taut::checksum_for_stb
#include <stb_image_write.h>

namespace taut {
namespace {

// stb's settings are variables of this file; they are set before the first picture and never again.
const bool settings_made = [] {
  constexpr int filter_sub = 1, fastest_that_compresses_well = 1;
  stbi_write_force_png_filter = filter_sub;
  stbi_write_png_compression_level = fastest_that_compresses_well;
  return true;
}();

struct Free {
  void operator()(unsigned char* bytes) const { std::free(bytes); }
};

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image) {
  int length = 0;
  const std::unique_ptr<unsigned char, Free> png(stbi_write_png_to_mem(
      image.pixels.data(), 0, image.size.width, image.size.height, image.channels, &length));
  if (!settings_made || !png) throw RunFailure("a frame could not be compressed: there is no memory left");
  return {png.get(), png.get() + length};
}

}  // namespace taut
