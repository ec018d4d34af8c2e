#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "codec.h"

namespace taut {

/// A key of a table whose values are kept in a T: the facts, and how it is stored.
template <class T>
struct Key {
  KeyInfo info;
  std::function<void(const Node&, const KeyInfo&, T&, Reader&)> read;
  std::function<std::string(const T&)> write;  ///< as TOML; empty when left out
};

template <class T>
using Keys = std::vector<Key<T>>;

/// What is said of a key where the table is written down.
struct Facts {
  std::string_view unit = {};
  Range range = {};
  std::span<const std::string_view> choices = {};
  std::string_view fallback = {};  ///< in words, where leaving the key out means more than its default value
  bool required = false;
  std::string_view help = {};
};

template <class V>
concept HasInnerKeys = requires {
  Codec<V>::inner();
};

/// A key stored in what `access` (a pointer to a member, or a function from T& to a reference) gives.
template <class T, class Access>
Key<T> key(std::string_view name, Access access, const Facts& facts) {
  using V = std::remove_cvref_t<std::invoke_result_t<Access, T&>>;
  KeyInfo info{.name = std::string(name),
               .type = Codec<V>::type(),
               .unit = std::string(facts.unit),
               .fallback = std::string(facts.fallback),
               .range = facts.range,
               .choices = facts.choices,
               .help = std::string(facts.help),
               .required = facts.required,
               .inner = {}};
  if constexpr (std::is_enum_v<V>) info.choices = Words<V>::list;
  if constexpr (HasInnerKeys<V>) info.inner = Codec<V>::inner();
  const T defaults{};
  if (facts.fallback.empty() && !facts.required)
    info.fallback = Codec<V>::write(std::invoke(access, defaults));
  return {std::move(info),
          [access](const Node& node, const KeyInfo& facts_of_key, T& out, Reader& reader) {
            Codec<V>::read(node, facts_of_key, std::invoke(access, out), reader);
          },
          [access](const T& value) { return Codec<V>::write(std::invoke(access, value)); }};
}

template <class T>
std::vector<KeyInfo> infos(const Keys<T>& keys) {
  std::vector<KeyInfo> list;
  for (const Key<T>& each : keys) list.push_back(each.info);
  return list;
}

/// The one of `known` that a key which is none of them may have been meant to be; empty where none is near.
std::string_view nearest_key(std::string_view key, const std::vector<KeyInfo>& known);

/// Reports a key that is none of `known`, with the nearest one and its unit. `label` says of what it is no
/// key, such as `[[chain]]`.
void report_unknown(const Entry& entry, const std::vector<KeyInfo>& known, std::string_view label,
                    Reader& reader);

/// Reports a value that should be a table.
void report_no_table(const Node& node, std::string_view label, Reader& reader);

/// Whether a table is the entry of a section or a value within one.
enum class TableKind { entry, value };

/// Reads a table key by key; reports unknown and missing keys. False when the node is no table.
template <class T>
bool read_table(const Node& node, const Keys<T>& keys, std::string_view label, TableKind kind, T& out,
                Reader& reader) {
  const auto* table = node.get<Node::Table>();
  if (!table) {
    report_no_table(node, label, reader);
    return false;
  }
  std::vector<KeyInfo> known;  // made for the first key that is none of them
  for (const Entry& entry : *table) {
    if (reader.full()) return true;
    if (kind == TableKind::entry) reader.begin_key(entry.key);
    const auto found = std::ranges::find(keys, entry.key, [](const Key<T>& each) { return each.info.name; });
    if (found != keys.end()) {
      found->read(entry.node, found->info, out, reader);
      continue;
    }
    if (known.empty()) known = infos(keys);
    const std::string_view meant = nearest_key(entry.key, known);
    if (kind == TableKind::entry && !meant.empty()) reader.begin_key(meant);
    report_unknown(entry, known, label, reader);
  }
  for (const Key<T>& each : keys) {
    if (!each.info.required || find_entry(node, each.info.name)) continue;
    if (kind == TableKind::entry) reader.begin_key(each.info.name);
    reader.unreadable(node.origin, std::string(label) + " needs the key " + in_quotes(each.info.name));
  }
  return true;
}

/// A table as `{ a = 1, b = 2 }`, without the keys left out.
template <class T>
std::string write_inline(const Keys<T>& keys, const T& value) {
  std::string out;
  for (const Key<T>& each : keys) {
    const std::string text = each.write(value);
    if (!text.empty()) out += (out.empty() ? "" : ", ") + each.info.name + " = " + text;
  }
  return "{ " + out + " }";
}

/// A table as one line for each key; of a key left out, a comment says what that means.
template <class T>
std::string write_lines(const Keys<T>& keys, const T& value) {
  std::string out;
  for (const Key<T>& each : keys) {
    const std::string text = each.write(value);
    out += text.empty() ? "# " + each.info.name + ": " + each.info.fallback + "\n"
                        : each.info.name + " = " + text + "\n";
  }
  return out;
}

}  // namespace taut
