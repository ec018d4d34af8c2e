#include "output/png_check.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string_view>

#include "base/failure.h"
#include "output/content_hash.h"
#include "output/png_read.h"

namespace taut {
namespace {

using namespace std::string_view_literals;

// What a PNG begins with: its signature, then the length and the type of the chunk that holds its size.
constexpr std::string_view beginning = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR"sv;
constexpr std::string_view ending = "\0\0\0\0IEND\xae\x42\x60\x82"sv;

int number_at(const char* bytes) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes[i]);
  return static_cast<int>(value);
}

}  // namespace

bool is_whole_png(const std::filesystem::path& file, Size size) {
  std::ifstream in(file, std::ios::binary);
  std::array<char, beginning.size() + 8> head{};
  std::array<char, ending.size()> tail{};
  in.read(head.data(), head.size());
  in.seekg(-static_cast<std::streamoff>(tail.size()), std::ios::end);
  in.read(tail.data(), tail.size());
  if (!in) return false;
  return std::string_view(head.data(), beginning.size()) == beginning &&
         std::string_view(tail.data(), tail.size()) == ending &&
         number_at(head.data() + beginning.size()) == size.width &&
         number_at(head.data() + beginning.size() + 4) == size.height;
}

bool is_blank_png(const std::filesystem::path& file) {
  const std::optional<std::string> bytes = bytes_of_file(file);
  if (!bytes) return true;
  try {
    const Image image = decode_png(*bytes, file);
    // Alike with its neighbour, each.
    return std::equal(image.pixels.begin() + image.channels, image.pixels.end(), image.pixels.begin());
  } catch (const RunFailure&) {
    return true;
  }
}

}  // namespace taut
