#include "document.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/diagnostic.h"

namespace taut {

const Entry* find_entry(const Node& node, std::string_view key) {
  const auto* table = node.get<Node::Table>();
  if (!table) return nullptr;
  const auto found = std::ranges::find(*table, key, &Entry::key);
  return found == table->end() ? nullptr : &*found;
}

Entry* find_entry(Node& node, std::string_view key) {
  return const_cast<Entry*>(find_entry(std::as_const(node), key));
}

bool is_number(const Node& node, double& number) {
  if (const auto* whole = node.get<std::int64_t>()) {
    number = static_cast<double>(*whole);
    return true;
  }
  if (const auto* real = node.get<double>()) {
    number = *real;
    return true;
  }
  return false;
}

std::string describe(const Node& node) {
  if (const auto* text = node.get<std::string>()) return in_quotes(*text);
  if (const auto* truth = node.get<bool>()) return *truth ? "true" : "false";
  if (const auto* whole = node.get<std::int64_t>()) return fmt::format("{}", *whole);
  if (const auto* real = node.get<double>()) return fmt::format("{}", *real);
  if (const auto* list = node.get<Node::List>())
    return list->empty() ? "an empty list" : fmt::format("a list of {}", list->size());
  return node.get<Node::Table>() ? "a table" : "a date or time";
}

}  // namespace taut
