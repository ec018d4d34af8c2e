#pragma once

#include <filesystem>
#include <vector>

#include "model/description.h"

namespace taut {

/// Reads the files that a description names, which lie in a folder, into it, and writes their hashes down.
/// Reports what can't be read, is no cloth, or is not what the description says it was; `notes` are told what
/// was done to it.
std::vector<Problem> read_files(Description& description, const std::filesystem::path& folder,
                                std::vector<Problem>& notes);

}  // namespace taut
