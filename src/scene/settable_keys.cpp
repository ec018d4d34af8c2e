#include <fmt/format.h>

#include <string>
#include <vector>

#include "scene/scene.h"
#include "section.h"
#include "toml_text.h"

namespace taut {
namespace {

void append_keys(const std::string& before, const std::vector<KeyInfo>& keys, std::vector<std::string>& all) {
  for (const KeyInfo& info : keys) {
    all.push_back(before + info.name);
    append_keys(all.back() + ".", info.inner, all);
  }
}

// A name as a part of a dotted path.
std::string as_path_part(const std::string& name) {
  return name.find('.') == std::string::npos ? name : fmt::format("\"{}\"", name);
}

// What the entries of a list go by: their names, else their numbers.
std::vector<std::string> entries_of(const Node::List& list) {
  std::vector<std::string> parts{"*"};
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Entry* entry = list[i].get<Node::Table>() ? find_entry(list[i], "name") : nullptr;
    const auto* name = entry ? entry->node.get<std::string>() : nullptr;
    parts.push_back(name ? as_path_part(*name) : fmt::format("{}", i));
  }
  return parts;
}

}  // namespace

std::vector<std::string> settable_keys(const std::string& text) {
  std::optional<SyntaxError> error;
  const Node document = parse_toml(text, error);
  std::vector<std::string> all;
  for (const Section& section : all_sections()) {
    std::vector<std::string> before{section.name.empty() ? "" : section.name + "."};
    if (section.repeated) {
      const Entry* entries = error ? nullptr : find_entry(document, section.name);
      const auto* list = entries ? entries->node.get<Node::List>() : nullptr;
      before.clear();
      // Without a scene it is not known what there is; with one, what is not there can't be changed.
      if (list)
        for (const std::string& part : entries_of(*list))
          before.push_back(fmt::format("{}.{}.", section.name, part));
      else if (!entries && (error || text.empty()))
        before.push_back(section.name + ".*.");
    }
    for (const std::string& path : before)
      for (const KeyGroup& group : section.groups) append_keys(path, group.keys, all);
  }
  return all;
}

}  // namespace taut
