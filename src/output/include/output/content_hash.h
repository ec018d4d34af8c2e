#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace taut {

/// The bytes of a file; nothing where it can't be read.
std::optional<std::string> bytes_of_file(const std::filesystem::path& file);

/// A hash of bytes, as manifests have it.
std::string content_hash_of(std::string_view bytes);

/// The hash of a file's bytes; nothing where it can't be read.
std::optional<std::string> content_hash(const std::filesystem::path& file);

}  // namespace taut
