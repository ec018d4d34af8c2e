#include "output/packed.h"

#include <isa-l/igzip_lib.h>

#include <array>
#include <cstdint>
#include <limits>
#include <memory>

#include "base/failure.h"

namespace taut {
namespace {

constexpr std::size_t number_size = 8;
// ISA-L counts in 32 bits.
constexpr std::size_t most_at_once = std::numeric_limits<std::uint32_t>::max() / 2;

// All first bytes of the numbers, then all second ones …; what is left over stays at the end.
std::string sorted_by_place(std::string_view bytes) {
  std::string sorted(bytes);
  const std::size_t count = bytes.size() / number_size;
  for (std::size_t place = 0; place < number_size; ++place)
    for (std::size_t i = 0; i < count; ++i) sorted[place * count + i] = bytes[i * number_size + place];
  return sorted;
}

std::string back_in_order(std::string_view sorted) {
  std::string bytes(sorted);
  const std::size_t count = sorted.size() / number_size;
  for (std::size_t place = 0; place < number_size; ++place)
    for (std::size_t i = 0; i < count; ++i) bytes[i * number_size + place] = sorted[place * count + i];
  return bytes;
}

std::uint8_t* raw(std::string& text) {
  return reinterpret_cast<std::uint8_t*>(text.data());
}

}  // namespace

std::string packed(std::string_view bytes) {
  if (bytes.size() > most_at_once) throw RunFailure("a state is too large to be stored");
  std::string from = sorted_by_place(bytes);
  std::array<std::uint8_t, ISAL_DEF_LVL1_DEFAULT> workspace;
  isal_zstream stream;
  isal_deflate_init(&stream);
  stream.level = 1;
  stream.level_buf = workspace.data();
  stream.level_buf_size = static_cast<std::uint32_t>(workspace.size());
  stream.gzip_flag = IGZIP_ZLIB;
  stream.end_of_stream = 1;
  stream.next_in = raw(from);
  stream.avail_in = static_cast<std::uint32_t>(from.size());
  // Deflate's worst case is stored blocks: five bytes for every 65,535, and a few at the ends.
  std::string to(from.size() + 5 * (from.size() / 65535 + 1) + 512, '\0');
  stream.next_out = raw(to);
  stream.avail_out = static_cast<std::uint32_t>(to.size());
  if (isal_deflate(&stream) != COMP_OK || stream.internal_state.state != ZSTATE_END)
    throw RunFailure("a state could not be compressed");
  to.resize(stream.total_out);
  return to;
}

std::string unpacked(std::string_view bytes, std::size_t size) {
  if (bytes.size() > most_at_once || size > most_at_once) throw BadRequest("the packed bytes are damaged");
  std::string from(bytes), to(size, '\0');
  const auto stream = std::make_unique<inflate_state>();
  isal_inflate_init(stream.get());
  stream->crc_flag = ISAL_ZLIB;
  stream->next_in = raw(from);
  stream->avail_in = static_cast<std::uint32_t>(from.size());
  stream->next_out = raw(to);
  stream->avail_out = static_cast<std::uint32_t>(size);
  if (isal_inflate(stream.get()) != ISAL_DECOMP_OK || stream->total_out != size ||
      stream->block_state != ISAL_BLOCK_FINISH)
    throw BadRequest("the packed bytes are damaged");
  return back_in_order(to);
}

}  // namespace taut
