#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace taut {

/// A 64-bit FNV-1a hash, fed piece by piece. The same bytes give the same value on every machine of one byte
/// order.
class Hash {
 public:
  Hash& add(std::span<const std::byte> bytes);
  Hash& add(std::span<const double> values) { return add(std::as_bytes(values)); }
  Hash& add(std::string_view text) { return add(std::as_bytes(std::span(text))); }
  std::uint64_t value() const { return value_; }
  /// The value as 16 hexadecimal digits.
  std::string hex() const;

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

}  // namespace taut
