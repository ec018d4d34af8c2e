#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace taut {

/// Where a part of a scene was written: in the file, or in one of the command line's changes.
struct Origin {
  std::uint32_t line = 0;    ///< from 1; 0: not in the file
  std::uint32_t column = 0;  ///< in characters, from 1
  std::int32_t change = -1;  ///< index of a change from the command line; −1: the file
};

struct Entry;

/// A date or a time, which no key of a scene takes.
struct Moment {};

/// A value of a scene file, with its place. Independent of the library that parsed it.
struct Node {
  using List = std::vector<Node>;
  using Table = std::vector<Entry>;  ///< in the order of the file
  std::variant<Table, List, bool, std::int64_t, double, std::string, Moment> value;
  Origin origin;

  template <class T>
  const T* get() const {
    return std::get_if<T>(&value);
  }
  template <class T>
  T* get() {
    return std::get_if<T>(&value);
  }
};

/// A key of a table and its value.
struct Entry {
  std::string key;
  Origin origin;  ///< of the key
  Node node;
};

/// The entry of that key, or nullptr when the node is no table or has none.
const Entry* find_entry(const Node& node, std::string_view key);
Entry* find_entry(Node& node, std::string_view key);

/// True for an integer or a real number; then `number` is it.
bool is_number(const Node& node, double& number);

/// What a value is, in words that fit behind "not": `-1`, `"heavy"`, `a list of 2`, `a table`.
std::string describe(const Node& node);

}  // namespace taut
