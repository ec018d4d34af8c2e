#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "document.h"

namespace taut {

inline constexpr std::size_t most_bytes = std::size_t{8} << 20U;  ///< of a scene file: 8 MiB
inline constexpr int deepest_key = 16;                            ///< parts of a dotted key
inline constexpr int deepest_nesting = 32;                        ///< brackets within each other

/// Why a text can't be parsed at all, and where.
struct SyntaxError {
  std::string message;
  Origin origin;
};

/// What is wrong with a text before it is parsed: too large, not UTF-8, keys or brackets too deep for a
/// parser that works by recursion. One pass over the bytes.
std::optional<SyntaxError> check_limits(std::string_view text);

/// The document of a TOML text (a table), or what is wrong with it; `error` is set then. Checks the limits
/// first.
Node parse_toml(std::string_view text, std::optional<SyntaxError>& error);

}  // namespace taut
