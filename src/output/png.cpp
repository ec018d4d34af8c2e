#include "output/png.h"

#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>

#include <array>
#include <cstring>
#include <string_view>

#include "base/failure.h"

// A PNG is a signature and a few chunks, so it is put together here, around ISA-L's deflate at level 1 and
// the SUB filter on every row. Measured on a 1280×720 frame of the curtain (build with
// TAUT_BUILD_BENCHMARKS=ON, run png_bench): see the table in tests/bench/png_bench.cpp.

namespace taut {
namespace {

constexpr std::array<std::uint8_t, 8> signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::array<std::uint8_t, 12> end_chunk{0, 0, 0, 0, 'I', 'E', 'N', 'D', 0xae, 0x42, 0x60, 0x82};
constexpr std::size_t chunk_overhead = 12;  // length, type, checksum
constexpr std::size_t header_length = 13;
constexpr std::uint8_t filter_sub = 1;

void put_number(std::uint8_t* to, std::uint32_t value) {
  for (int byte = 0; byte < 4; ++byte) to[byte] = static_cast<std::uint8_t>(value >> (24 - 8 * byte));
}

// Fills in length, type and checksum around the `length` bytes that already stand at chunk + 8.
void finish_chunk(std::uint8_t* chunk, std::string_view type, std::size_t length) {
  put_number(chunk, static_cast<std::uint32_t>(length));
  std::memcpy(chunk + 4, type.data(), 4);
  put_number(chunk + 8 + length, crc32_gzip_refl(0, chunk + 4, length + 4));
}

void write_header(std::uint8_t* chunk, const Image& image) {
  constexpr std::uint8_t rgb = 2, rgba = 6;
  std::uint8_t* data = chunk + 8;
  put_number(data, static_cast<std::uint32_t>(image.size.width));
  put_number(data + 4, static_cast<std::uint32_t>(image.size.height));
  data[8] = 8;  // bits a channel
  data[9] = image.channels == 4 ? rgba : rgb;
  data[10] = data[11] = data[12] = 0;  // deflate, adaptive filters, not interlaced
  finish_chunk(chunk, "IHDR", header_length);
}

// Every row behind its filter's number, each byte as the difference from the one a pixel to its left.
std::vector<std::uint8_t> filtered_rows(const Image& image) {
  const auto channels = static_cast<std::size_t>(image.channels);
  const auto row_bytes = static_cast<std::size_t>(image.size.width) * channels;
  const auto rows = static_cast<std::size_t>(image.size.height);
  std::vector<std::uint8_t> filtered((row_bytes + 1) * rows);
  for (std::size_t row = 0; row < rows; ++row) {
    const std::uint8_t* from = image.pixels.data() + row * row_bytes;
    std::uint8_t* to = filtered.data() + row * (row_bytes + 1);
    *to++ = filter_sub;
    std::memcpy(to, from, channels);
    for (std::size_t i = channels; i < row_bytes; ++i)
      to[i] = static_cast<std::uint8_t>(from[i] - from[i - channels]);
  }
  return filtered;
}

// Deflate's worst case is stored blocks: five bytes for every 65,535, and a few at the ends.
std::size_t most_compressed(std::size_t length) {
  return length + 5 * (length / 65535 + 1) + 512;
}

std::size_t compress(std::vector<std::uint8_t>& from, std::uint8_t* to, std::size_t room) {
  std::vector<std::uint8_t> workspace(ISAL_DEF_LVL1_DEFAULT);
  isal_zstream stream;
  isal_deflate_init(&stream);
  stream.level = 1;
  stream.level_buf = workspace.data();
  stream.level_buf_size = static_cast<std::uint32_t>(workspace.size());
  stream.gzip_flag = IGZIP_ZLIB;
  stream.end_of_stream = 1;
  stream.next_in = from.data();
  stream.avail_in = static_cast<std::uint32_t>(from.size());
  stream.next_out = to;
  stream.avail_out = static_cast<std::uint32_t>(room);
  if (isal_deflate(&stream) != COMP_OK || stream.avail_in != 0 || stream.internal_state.state != ZSTATE_END)
    throw RunFailure("a frame could not be compressed");
  return stream.total_out;
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image) {
  std::vector<std::uint8_t> rows = filtered_rows(image);
  const std::size_t room = most_compressed(rows.size());
  const std::size_t data_chunk = signature.size() + chunk_overhead + header_length;
  std::vector<std::uint8_t> png(data_chunk + chunk_overhead + room + end_chunk.size());

  std::memcpy(png.data(), signature.data(), signature.size());
  write_header(png.data() + signature.size(), image);
  const std::size_t length = compress(rows, png.data() + data_chunk + 8, room);
  finish_chunk(png.data() + data_chunk, "IDAT", length);
  const std::size_t end = data_chunk + chunk_overhead + length;
  std::memcpy(png.data() + end, end_chunk.data(), end_chunk.size());
  png.resize(end + end_chunk.size());
  return png;
}

}  // namespace taut
