#include "file_bytes.h"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

#include "base/failure.h"

namespace taut {

std::string file_bytes(const std::filesystem::path& file, const std::string& called) {
  constexpr std::uintmax_t most = std::uintmax_t{1} << 30U;
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) throw BadRequest(fmt::format("{}: no such file", called));
  if (!std::filesystem::is_regular_file(status)) throw BadRequest(fmt::format("{}: not a file", called));
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (!error && size == 0) throw BadRequest(fmt::format("{}: the file is empty", called));
  if (!error && size > most) throw BadRequest(fmt::format("{}: larger than 1 GiB", called));
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(error ? 0 : size, '\0');
  if (error || !stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
    throw BadRequest(fmt::format("{}: can't be read", called));
  return bytes;
}

}  // namespace taut
