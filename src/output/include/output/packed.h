#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace taut {

/// Bytes that are mostly numbers of eight bytes, compressed: sorted by their place in the number first, since
/// neighbours are alike in sign and exponent, then by zlib's format. Throws RunFailure where there is no
/// memory.
std::string packed(std::string_view bytes);

/// The other way round; `size` is how many bytes there were. Throws BadRequest for what is none of packed().
std::string unpacked(std::string_view bytes, std::size_t size);

}  // namespace taut
