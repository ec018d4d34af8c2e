#pragma once

#include <string_view>
#include <vector>

namespace taut {

/// The parts of a text between its separators; one part where there is none.
std::vector<std::string_view> split(std::string_view text, char separator);

}  // namespace taut
