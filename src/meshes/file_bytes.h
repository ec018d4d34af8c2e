#pragma once

#include <filesystem>
#include <string>

namespace taut {

/// All bytes of a file that messages call `called`. Throws BadRequest where there is none, where it can't be
/// read, is empty, or is larger than 1 GiB.
std::string file_bytes(const std::filesystem::path& file, const std::string& called);

}  // namespace taut
