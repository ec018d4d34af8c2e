#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace taut {

/// Throws BadRequest: the flag is one of these, not what was given, and which of them may be meant.
[[noreturn]] void not_one_of(std::string_view flag, std::string_view given,
                             std::span<const std::string_view> names);

/// The names as a flag's words.
std::vector<std::string> as_words(std::span<const std::string_view> names);

}  // namespace taut
