#include "changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "base/nearest.h"
#include "methods/registry.h"
#include "toml_text.h"

namespace taut {
namespace {

Origin from_change(std::size_t index) {
  return {0, 0, static_cast<std::int32_t>(index)};
}

void set_origin(Node& node, const Origin& origin) {
  node.origin = origin;
  if (auto* list = node.get<Node::List>())
    for (Node& element : *list) set_origin(element, origin);
  if (auto* table = node.get<Node::Table>())
    for (Entry& entry : *table) {
      entry.origin = origin;
      set_origin(entry.node, origin);
    }
}

// The value as TOML; what is no TOML is meant as text, so that `look.theme=dark` needs no quotes.
Node parse_value(const std::string& text, const Origin& origin) {
  std::optional<SyntaxError> error;
  Node document = parse_toml("value = " + text, error);
  const auto* table = document.get<Node::Table>();
  Node value;
  if (!error && table->size() == 1 && table->front().key == "value")
    value = table->front().node;
  else
    value.value = text;
  set_origin(value, origin);
  return value;
}

// The parts of a dotted path; a part between double quotes may contain dots.
std::vector<std::string> split_path(std::string_view path) {
  std::vector<std::string> parts(1);
  bool inside_quotes = false;
  for (const char c : path) {
    if (c == '"')
      inside_quotes = !inside_quotes;
    else if (c == '.' && !inside_quotes)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

std::string name_of(const Node& node) {
  const Entry* entry = find_entry(node, "name");
  const auto* name = entry ? entry->node.get<std::string>() : nullptr;
  return name ? *name : std::string();
}

// One step of a path failed: why, and what may have been meant.
struct PathError {
  std::string message, hint;
};

// The element of a list that a part of a path names, by its number from 0 or by its name.
Node* find_element(Node::List& list, const std::string& part, std::string_view what, PathError& error) {
  std::size_t number = 0;
  const auto [end, code] = std::from_chars(part.data(), part.data() + part.size(), number);
  if (code == std::errc{} && end == part.data() + part.size()) {
    if (number < list.size()) return &list[number];
    error = {
        fmt::format("{} has {} entries, counted from 0: there is no {}", in_quotes(what), list.size(), part),
        {}};
    return nullptr;
  }
  std::vector<std::string> names;
  for (Node& element : list) {
    names.push_back(name_of(element));
    if (names.back() == part) return &element;
  }
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  error = {fmt::format("{} has no entry named {}", in_quotes(what), in_quotes(part)),
           did_you_mean(nearest_name(part, candidates))};
  return nullptr;
}

// A value that the first parts of a path lead to, and the entry that it is of, where it is of one.
struct PathEnd {
  Node* node = nullptr;
  Entry* entry = nullptr;
};

// One part further; nothing where that leads nowhere.
std::vector<PathEnd> step_on(Node& node, const std::string& part, std::string_view last, const Origin& origin,
                             PathError& error) {
  if (auto* list = node.get<Node::List>()) {
    std::vector<PathEnd> all;
    if (part == "*")
      for (Node& element : *list) all.push_back({&element, nullptr});
    else if (Node* element = find_element(*list, part, last, error))
      all.push_back({element, nullptr});
    return all;
  }
  if (auto* table = node.get<Node::Table>()) {
    Entry* entry = find_entry(node, part);
    if (!entry) entry = &table->emplace_back(Entry{part, origin, {Node::Table{}, origin}});
    return {{&entry->node, entry}};
  }
  error = {fmt::format("{} has no keys of its own, and so no {}", in_quotes(last), in_quotes(part)), {}};
  return {};
}

// The places of the value that a path leads to: of several where a part is * for each entry of a list. Tables
// on the way are made where there are none. From then on the key is where the change says.
std::vector<Node*> find_places(Node& document, const std::vector<std::string>& path, const Origin& origin,
                               PathError& error) {
  std::vector<PathEnd> ends{{&document, nullptr}};
  std::string_view last = "scene";
  for (const std::string& part : path) {
    std::vector<PathEnd> next;
    for (const PathEnd& end : ends) {
      const std::vector<PathEnd> further = step_on(*end.node, part, last, origin, error);
      if (further.empty() && !error.message.empty()) return {};
      next.insert(next.end(), further.begin(), further.end());
    }
    ends = std::move(next);
    last = part;
  }
  std::vector<Node*> places;
  for (const PathEnd& end : ends) {
    if (end.entry) end.entry->origin = origin;
    places.push_back(end.node);
  }
  return places;
}

// Where one change belongs in the document: the path of its key, with solve. before a bare name that is no
// key of the top level.
std::vector<std::string> path_of(std::string_view key) {
  std::vector<std::string> path = split_path(key);
  if (path.size() == 1 && path.front() != "title") path.insert(path.begin(), "solve");
  return path;
}

std::optional<PathError> apply_set(const std::string& set, const Origin& origin, Node& document) {
  const std::size_t equals = set.find('=');
  if (equals == std::string::npos || equals == 0)
    return PathError{"must be key=value, such as world.drag=0.5", {}};
  const std::vector<std::string> path = path_of(std::string_view(set).substr(0, equals));
  if (std::ranges::find(path, std::string()) != path.end() || path.size() > deepest_key)
    return PathError{fmt::format("{} is no dotted path of a key", in_quotes(set.substr(0, equals))), {}};
  PathError error;
  const std::vector<Node*> places = find_places(document, path, origin, error);
  if (!error.message.empty()) return error;
  for (Node* place : places) *place = parse_value(set.substr(equals + 1), origin);
  return std::nullopt;
}

bool belongs_to_another(const Entry& entry, const Method& method) {
  if (entry.origin.change >= 0 || entry.key == "method" || find_param(method, entry.key)) return false;
  return std::ranges::any_of(all_methods(),
                             [&](const Method& other) { return find_param(other, entry.key) != nullptr; });
}

// Leaves out the file's keys of other methods, where the command line chose the method.
void drop_keys_of_other_methods(Node& document) {
  Entry* solve = find_entry(document, "solve");
  const Entry* chosen = solve ? find_entry(solve->node, "method") : nullptr;
  if (!chosen || chosen->node.origin.change < 0) return;
  const auto* name = chosen->node.get<std::string>();
  const Method* method = name ? find_method(*name) : nullptr;
  if (method)
    std::erase_if(*solve->node.get<Node::Table>(),
                  [&](const Entry& entry) { return belongs_to_another(entry, *method); });
}

}  // namespace

std::vector<std::string> change_names(const SceneOverrides& overrides) {
  std::vector<std::string> names;
  for (const std::string& set : overrides.sets) names.push_back("--set " + set);
  if (overrides.method) names.push_back("--method " + *overrides.method);
  return names;
}

std::vector<Diagnostic> apply_changes(const SceneOverrides& overrides, Node& document) {
  std::vector<Diagnostic> diagnostics;
  const std::vector<std::string> names = change_names(overrides);
  const auto note = [&](std::size_t index, const std::optional<PathError>& error) {
    if (error) diagnostics.push_back({names[index], 0, 0, error->message, error->hint});
  };
  for (std::size_t i = 0; i < overrides.sets.size(); ++i)
    note(i, apply_set(overrides.sets[i], from_change(i), document));
  if (overrides.method) {
    PathError error;
    const Origin origin = from_change(overrides.sets.size());
    for (Node* place : find_places(document, {"solve", "method"}, origin, error))
      *place = Node{*overrides.method, origin};
    if (!error.message.empty()) note(overrides.sets.size(), error);
  }
  drop_keys_of_other_methods(document);
  return diagnostics;
}

}  // namespace taut
