#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace taut {

/// Length in bytes of the well-formed UTF-8 character at the start of `text`; 0 when there is none (a stray
/// or overlong byte sequence, a surrogate, a code point above U+10FFFF, or an empty text).
std::size_t utf8_length(std::string_view text);

/// Offset of the first byte that is not part of a well-formed UTF-8 character; npos when all are.
std::size_t find_invalid_utf8(std::string_view text);

/// The text with everything that is no printable character replaced by U+FFFD; tabs stay when asked.
std::string printable(std::string_view text, bool keep_tabs = false);

}  // namespace taut
