#include "key.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/nearest.h"

namespace taut {

void report_unknown(const Entry& entry, const std::vector<KeyInfo>& known, std::string_view label,
                    Reader& reader) {
  std::vector<std::string_view> names;
  names.reserve(known.size());
  for (const KeyInfo& info : known) names.push_back(info.name);
  const std::string_view nearest = nearest_name(entry.key, names);
  const auto meant = std::ranges::find(known, nearest, &KeyInfo::name);
  reader.unreadable(entry.origin, fmt::format("unknown key {} in {}", in_quotes(entry.key), label),
                    meant == known.end() ? reader.home_hint(entry.key) : did_you_mean(nearest, meant->unit));
}

void report_no_table(const Node& node, std::string_view label, Reader& reader) {
  reader.unreadable(node.origin, fmt::format("{} must be a table, not {}", label, describe(node)));
}

}  // namespace taut
