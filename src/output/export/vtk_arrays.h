#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/bytes.h"
#include "base/vectors.h"
#include "export/binary.h"

namespace taut {

/// The arrays of one of VTK's XML files: what stands in its elements, and the bytes appended after them, raw,
/// each array with how many bytes it has before it.
class VtkArrays {
 public:
  /// An element for an array of numbers, of so many components each. Its bytes are appended.
  template <class Number>
  std::string add(std::string_view name, const std::vector<Number>& numbers, int components = 1) {
    const std::string element = begin(name, type_of<Number>(), components);
    append_bytes(static_cast<std::uint64_t>(numbers.size() * sizeof(Number)), appended_);
    for (const Number number : numbers) append_bytes(number, appended_);
    return element;
  }
  std::string add(std::string_view name, const Vectors& vectors);

  const std::string& appended() const { return appended_; }

 private:
  template <class Number>
  static std::string_view type_of() {
    if constexpr (std::is_same_v<Number, double>) return "Float64";
    if constexpr (std::is_same_v<Number, std::int64_t>) return "Int64";
    if constexpr (std::is_same_v<Number, std::int8_t>) return "Int8";
  }
  std::string begin(std::string_view name, std::string_view type, int components) const;

  std::string appended_;
};

}  // namespace taut
