#include "key.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/nearest.h"

namespace taut {

std::string_view nearest_key(std::string_view key, const std::vector<KeyInfo>& known) {
  std::vector<std::string_view> names;
  names.reserve(known.size());
  for (const KeyInfo& info : known) names.push_back(info.name);
  return nearest_name(key, names);
}

void report_unknown(const Entry& entry, const std::vector<KeyInfo>& known, std::string_view label,
                    Reader& reader) {
  const std::string_view nearest = nearest_key(entry.key, known);
  const auto meant = std::ranges::find(known, nearest, &KeyInfo::name);
  reader.unreadable(entry.origin, fmt::format("unknown key {} in {}", in_quotes(entry.key), label),
                    meant == known.end() ? reader.home_hint(entry.key) : did_you_mean(nearest, meant->unit));
}

void report_no_table(const Node& node, std::string_view label, Reader& reader) {
  reader.unreadable(node.origin, fmt::format("{} must be a table, not {}", label, describe(node)));
}

}  // namespace taut
