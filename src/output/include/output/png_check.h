#pragma once

#include <filesystem>

#include "base/image.h"

namespace taut {

/// True when the file is a PNG of that size with its last chunk in place. Reads only its head and its tail.
bool is_whole_png(const std::filesystem::path& file, Size size);

/// True when all its pixels are alike, or it can't be read as a picture. Reads all of it.
bool is_blank_png(const std::filesystem::path& file);

}  // namespace taut
