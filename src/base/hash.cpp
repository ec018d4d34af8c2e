#include "base/hash.h"

#include <fmt/format.h>

namespace taut {

Hash& Hash::add(std::span<const std::byte> bytes) {
  for (const std::byte byte : bytes) {
    value_ ^= static_cast<std::uint64_t>(byte);
    value_ *= 0x100000001b3U;
  }
  return *this;
}

std::string Hash::hex() const {
  return fmt::format("{:016x}", value_);
}

}  // namespace taut
