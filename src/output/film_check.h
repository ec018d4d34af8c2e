#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace taut {

/// What is wrong with a film of that ending (".mp4", ".webm", ".gif", ".webp" or ".mov") that is to have that
/// many frames: it is cut, it is something else, or it has another number of them. Empty: it is whole. Its
/// own lists and lengths are read, not its pictures. Throws RunFailure where the file can't be read.
std::string film_problem(const std::filesystem::path& file, std::string_view ending, std::size_t frames);

}  // namespace taut
