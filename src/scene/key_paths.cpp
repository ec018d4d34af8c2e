#include "key_paths.h"

#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace taut {
namespace {

using Place = std::pair<std::size_t, std::size_t>;  // line and column
using Paths = std::map<Place, std::string>;

void remember(const Origin& origin, const std::string& path, Paths& paths) {
  if (origin.change < 0 && origin.line > 0) paths[{origin.line, origin.column}] = path;
}

// What lies deeper comes later, and takes the place of what begins where it does.
void walk(const Node& node, const std::string& path, Paths& paths) {
  const auto below = [&](std::string_view name) {
    return path.empty() ? std::string(name) : fmt::format("{}.{}", path, name);
  };
  remember(node.origin, path, paths);
  if (const auto* table = node.get<Node::Table>())
    for (const Entry& entry : *table) {
      remember(entry.origin, below(entry.key), paths);
      walk(entry.node, below(entry.key), paths);
    }
  if (const auto* list = node.get<Node::List>())
    for (std::size_t i = 0; i < list->size(); ++i) walk((*list)[i], below(fmt::format("{}", i)), paths);
}

// Of a change of the command line, which is its own origin.
std::string changed_key(std::string_view origin) {
  constexpr std::string_view set = "--set ", method = "--method ";
  if (origin.starts_with(method)) return "solve.method";
  if (!origin.starts_with(set)) return {};
  origin.remove_prefix(set.size());
  const std::string key(origin.substr(0, origin.find('=')));
  return key.find('.') == std::string::npos ? fmt::format("solve.{}", key) : key;
}

}  // namespace

void name_keys(const Node& document, std::vector<Diagnostic>& diagnostics) {
  Paths paths;
  walk(document, {}, paths);
  for (Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.line == 0) {
      diagnostic.key = changed_key(diagnostic.origin);
      continue;
    }
    const auto found = paths.find({diagnostic.line, diagnostic.column});
    if (found != paths.end()) diagnostic.key = found->second;
  }
}

}  // namespace taut
