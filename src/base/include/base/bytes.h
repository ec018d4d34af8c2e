#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "base/failure.h"
#include "base/vectors.h"

namespace taut {

// Numbers and lists of them as bytes, for files that are read on machines of the same byte order.

template <class T>
inline constexpr bool lies_in_one_piece = std::is_trivially_copyable_v<T> || std::is_same_v<T, Vec3>;

/// Appends a plain value as it lies in memory; a list of plain values, or of structs of such, with its length
/// before it.
template <class T>
void append_bytes(const T& value, std::string& bytes) {
  if constexpr (requires { value.data(); } && !std::is_same_v<T, Vec3>) {
    append_bytes(static_cast<std::uint64_t>(value.size()), bytes);
    bytes.append(reinterpret_cast<const char*>(value.data()), value.size() * sizeof(typename T::value_type));
  } else {
    static_assert(lies_in_one_piece<T>);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
}

/// How many bytes append_bytes() takes for it.
template <class T>
std::size_t size_in_bytes(const T& value) {
  if constexpr (requires { value.data(); } && !std::is_same_v<T, Vec3>)
    return sizeof(std::uint64_t) + value.size() * sizeof(typename T::value_type);
  else
    return sizeof value;
}

/// Takes values off the front of what append_bytes() made. Throws BadRequest where there are too few bytes.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : left_(bytes) {}

  template <class T>
  void take(T& value) {
    if constexpr (requires { value.data(); } && !std::is_same_v<T, Vec3>) {
      std::uint64_t count = 0;
      take(count);
      if (count > left_.size() / sizeof(typename T::value_type)) throw too_short();
      value.resize(count);
      take(static_cast<void*>(value.data()), count * sizeof(typename T::value_type));
    } else {
      static_assert(lies_in_one_piece<T>);
      take(static_cast<void*>(&value), sizeof value);
    }
  }
  /// Takes a list of bytes that stay where they are.
  std::string_view take_in_place() {
    std::uint64_t count = 0;
    take(count);
    if (count > left_.size()) throw too_short();
    const std::string_view bytes = left_.substr(0, count);
    left_.remove_prefix(count);
    return bytes;
  }
  bool at_end() const { return left_.empty(); }

 private:
  static BadRequest too_short() { return BadRequest("the bytes end too early"); }
  void take(void* to, std::size_t size) {
    if (left_.size() < size) throw too_short();
    if (size > 0) std::memcpy(to, left_.data(), size);
    left_.remove_prefix(size);
  }

  std::string_view left_;
};

}  // namespace taut
