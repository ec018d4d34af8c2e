#include "output/content_hash.h"

#include <fstream>
#include <system_error>

#include "base/hash.h"

namespace taut {

std::optional<std::string> bytes_of_file(const std::filesystem::path& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  std::ifstream stream(file, std::ios::binary);
  if (error || !stream) return std::nullopt;
  std::string bytes(size, '\0');
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(size))) return std::nullopt;
  return bytes;
}

std::string content_hash_of(std::string_view bytes) {
  return Hash().add(bytes).hex();
}

std::optional<std::string> content_hash(const std::filesystem::path& file) {
  const std::optional<std::string> bytes = bytes_of_file(file);
  if (!bytes) return std::nullopt;
  return content_hash_of(*bytes);
}

}  // namespace taut
