#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "document.h"
#include "model/description.h"
#include "reader.h"
#include "view/view.h"

namespace taut {

/// What a number (or each number of a list) may be.
struct Range {
  double min = -std::numeric_limits<double>::max();
  double max = std::numeric_limits<double>::max();
  bool min_excluded = false;     ///< must be above min
  bool zero_is_special = false;  ///< 0 stands for something else; whatever is above it is divided by

  /// Whether something is divided by what is above 0.
  bool divides() const { return min == 0.0 && (min_excluded || zero_is_special); }
  bool contains(double x) const { return (min_excluded ? x > min : x >= min) && x <= max; }
};

constexpr Range at_least(double min) {
  return {.min = min};
}
constexpr Range above(double min) {
  return {.min = min, .min_excluded = true};
}
constexpr Range between(double min, double max) {
  return {.min = min, .max = max};
}
constexpr Range zero_or_up_to(double max) {
  return {.min = 0.0, .max = max, .zero_is_special = true};
}
constexpr Range above_to(double min, double max) {
  return {.min = min, .max = max, .min_excluded = true};
}

/// The range in words behind "must be": `above 0 and at most 3600 s`; empty when there is none.
std::string range_words(const Range& range, std::string_view unit);

/// The range for a table: `> 0, ≤ 3600`; empty when there is none.
std::string range_signs(const Range& range);

/// Everything about a key but how it is stored.
struct KeyInfo {
  std::string name;
  std::string type;      ///< in words, behind "must be"
  std::string unit;      ///< empty for a pure number and for what is no number
  std::string fallback;  ///< the value where the key is left out, as TOML or in words
  Range range;
  std::span<const std::string_view> choices;  ///< words that a text, or each text of a list, is out of
  std::string help;
  bool required = false;
  std::vector<KeyInfo> inner;  ///< keys of the table that is the value
};

/// The name of the key's unit behind a type: ` in m`; empty without one.
std::string in_unit(const KeyInfo& info);

/// The shortest text that reads back as the same number, always as a TOML float.
std::string toml_number(double x);
/// The text as a TOML string.
std::string toml_string(std::string_view text);

/// How values of a type are read from a document and written as TOML. read() reports what is wrong and then
/// leaves `out` alone, but for a value out of range. write() gives an empty text for a value left out.
template <class V>
struct Codec;

template <>
struct Codec<double> {
  static std::string type() { return "a number"; }
  static bool read(const Node& node, const KeyInfo& info, double& out, Reader& reader);
  static std::string write(double value) { return toml_number(value); }
};

template <>
struct Codec<int> {
  static std::string type() { return "a whole number"; }
  static bool read(const Node& node, const KeyInfo& info, int& out, Reader& reader);
  static std::string write(int value) { return std::to_string(value); }
};

template <>
struct Codec<bool> {
  static std::string type() { return "true or false"; }
  static bool read(const Node& node, const KeyInfo& info, bool& out, Reader& reader);
  static std::string write(bool value) { return value ? "true" : "false"; }
};

template <>
struct Codec<std::string> {
  static std::string type() { return "text"; }
  static bool read(const Node& node, const KeyInfo& info, std::string& out, Reader& reader);
  static std::string write(const std::string& value) { return toml_string(value); }
};

template <>
struct Codec<std::vector<std::string>> {
  static std::string type() { return "a list of texts"; }
  static bool read(const Node& node, const KeyInfo& info, std::vector<std::string>& out, Reader& reader);
  static std::string write(const std::vector<std::string>& value);
};

/// Reads a list of exactly as many numbers as `out` has; each must be finite and in the range.
bool read_numbers(const Node& node, const KeyInfo& info, std::string_view type, std::span<double> out,
                  Reader& reader);
std::string write_numbers(std::span<const double> numbers);

template <>
struct Codec<std::vector<int>> {
  static std::string type() { return "a list of whole numbers"; }
  static bool read(const Node& node, const KeyInfo& info, std::vector<int>& out, Reader& reader);
  static std::string write(const std::vector<int>& value);
};

template <>
struct Codec<Vec3> {
  static std::string type() { return "a list of 3 numbers"; }
  static bool read(const Node& node, const KeyInfo& info, Vec3& out, Reader& reader);
  static std::string write(const Vec3& value);
};

template <>
struct Codec<std::array<double, 2>> {
  static std::string type() { return "a list of 2 numbers"; }
  static bool read(const Node& node, const KeyInfo& info, std::array<double, 2>& out, Reader& reader);
  static std::string write(const std::array<double, 2>& value) { return write_numbers(value); }
};

template <>
struct Codec<Colour> {
  static std::string type() { return "a list of 3 numbers, text \"#rrggbb\" or a name"; }
  static bool read(const Node& node, const KeyInfo& info, Colour& out, Reader& reader);
  static std::string write(const Colour& value) { return write_numbers(value); }
};

template <>
struct Codec<std::vector<Knot>> {
  static std::string type() { return "a list of [t, x, y, z]"; }
  static bool read(const Node& node, const KeyInfo& info, std::vector<Knot>& out, Reader& reader);
  static std::string write(const std::vector<Knot>& value);
};

template <>
struct Codec<std::vector<Vec3>> {
  static std::string type() { return "a list of [x, y, z]"; }
  static bool read(const Node& node, const KeyInfo& info, std::vector<Vec3>& out, Reader& reader);
  static std::string write(const std::vector<Vec3>& value);
};

/// Writes a list of what `write` makes of each element.
template <class List, class Write>
std::string write_list(const List& list, Write write) {
  std::string out = "[";
  for (const auto& element : list) out += (out.size() > 1 ? ", " : "") + write(element);
  return out + "]";
}

template <>
struct Codec<std::vector<std::array<double, 2>>> {
  static std::string type() { return "a list of [number, number]"; }
  static bool read(const Node& node, const KeyInfo& info, std::vector<std::array<double, 2>>& out,
                   Reader& reader);
  static std::string write(const std::vector<std::array<double, 2>>& value);
};

template <>
struct Codec<std::array<Vec3, 2>> {
  static std::string type() { return "a list of 2 corners [x, y, z]"; }
  static bool read(const Node& node, const KeyInfo& info, std::array<Vec3, 2>& out, Reader& reader);
  static std::string write(const std::array<Vec3, 2>& value);
};

template <class V>
struct Codec<std::optional<V>> {
  static std::string type() { return Codec<V>::type(); }
  static bool read(const Node& node, const KeyInfo& info, std::optional<V>& out, Reader& reader) {
    V value{};
    if (!Codec<V>::read(node, info, value, reader)) return false;
    out = value;
    return true;
  }
  static std::string write(const std::optional<V>& value) {
    return value ? Codec<V>::write(*value) : std::string();
  }
};

/// The words of an enumeration, in the order of its values.
template <class E>
struct Words;
template <>
struct Words<ColourBy> {
  static constexpr std::array<std::string_view, 5> list{"plain", "strain", "tension", "speed", "limit"};
};
template <>
struct Words<ColourSteps> {
  static constexpr std::array<std::string_view, 2> list{"linear", "log"};
};
template <>
struct Words<LinkAction> {
  static constexpr std::array<std::string_view, 4> list{"both", "pull", "push", "between"};
};
template <>
struct Words<MassShares> {
  static constexpr std::array<std::string_view, 2> list{"area", "equal"};
};
template <>
struct Words<UpAxis> {
  static constexpr std::array<std::string_view, 2> list{"y", "z"};
};
template <>
struct Words<MassShape> {
  static constexpr std::array<std::string_view, 2> list{"sphere", "box"};
};
template <>
struct Words<LinkShape> {
  static constexpr std::array<std::string_view, 3> list{"rod", "rope", "chain"};
};
template <>
struct Words<Theme> {
  static constexpr std::array<std::string_view, 2> list{"light", "dark"};
};
template <>
struct Words<Pattern> {
  static constexpr std::array<std::string_view, 3> list{"plain", "checker", "woven"};
};

/// An enumeration whose words are the key's choices.
template <class E>
requires std::is_enum_v<E>
struct Codec<E> {
  static std::string type() { return "text"; }
  static bool read(const Node& node, const KeyInfo& info, E& out, Reader& reader) {
    std::string word;
    if (!Codec<std::string>::read(node, info, word, reader)) return false;
    for (std::size_t i = 0; i < Words<E>::list.size(); ++i)
      if (Words<E>::list[i] == word) out = static_cast<E>(i);
    return true;
  }
  static std::string write(E value) { return toml_string(Words<E>::list[static_cast<std::size_t>(value)]); }
};

}  // namespace taut
