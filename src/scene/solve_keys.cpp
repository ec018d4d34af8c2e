#include <fmt/format.h>

#include <algorithm>

#include "base/nearest.h"
#include "methods/registry.h"
#include "section.h"

namespace taut {
namespace {

std::vector<std::string_view> method_names() {
  std::vector<std::string_view> names;
  for (const Method& method : all_methods()) names.push_back(method.name);
  return names;
}

KeyInfo method_info() {
  static const std::vector<std::string_view> names = method_names();
  return {.name = "method",
          .type = "text",
          .unit = {},
          .fallback = toml_string(default_settings().method),
          .range = {},
          .choices = names,
          .help = "how the links are kept at their length",
          .required = false,
          .inner = {}};
}

std::string write_value(const std::variant<double, std::string>& value, bool whole) {
  if (const auto* word = std::get_if<std::string>(&value)) return toml_string(*word);
  const double number = std::get<double>(value);
  return whole ? fmt::format("{:.0f}", number) : toml_number(number);
}

// A method's parameter as a key.
KeyInfo info_of(const Param& param) {
  const bool word = !param.choices.empty();
  return {.name = std::string(param.name),
          .type = word          ? Codec<std::string>::type()
                  : param.whole ? Codec<int>::type()
                                : Codec<double>::type(),
          .unit = std::string(param.unit),
          .fallback = word ? toml_string(param.choices.front()) : write_value(param.fallback, param.whole),
          .range = word ? Range{} : between(param.min, param.max),
          .choices = param.choices,
          .help = std::string(param.help),
          .required = false,
          .inner = {}};
}

std::vector<KeyInfo> infos_of(const Method& method) {
  std::vector<KeyInfo> list;
  for (const Param& param : method.params) list.push_back(info_of(param));
  return list;
}

std::string names_of_methods_with(std::string_view param) {
  std::string list;
  for (const Method& method : all_methods())
    if (find_param(method, param)) list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", method.name);
  return list;
}

void report_unknown_method(const Node& node, const std::string& name, Reader& reader) {
  const std::vector<std::string_view> names = method_names();
  const std::string_view nearest = nearest_name(name, names);
  reader.unreadable(
      node.origin, fmt::format("unknown method {}", in_quotes(name)),
      nearest.empty() ? fmt::format("there are {}", fmt::join(names, ", ")) : did_you_mean(nearest));
}

// The method a [solve] names, the default one when it names none, nullptr after an error.
const Method* read_method(const Node& solve, Reader& reader) {
  const Entry* entry = find_entry(solve, "method");
  std::string name = default_settings().method;
  KeyInfo info = method_info();
  info.choices = {};  // an unknown method has a message of its own
  if (entry && !Codec<std::string>::read(entry->node, info, name, reader)) return nullptr;
  const Method* method = find_method(name);
  if (!method && entry) report_unknown_method(entry->node, name, reader);
  return method;
}

void read_param(const Node& node, const Param& param, Settings& settings, Reader& reader) {
  const KeyInfo info = info_of(param);
  const auto* whole = node.get<std::int64_t>();
  if (!param.choices.empty() && whole) {  // order = 4 is as good as order = "4"
    return read_param({std::to_string(*whole), node.origin}, param, settings, reader);
  } else if (!param.choices.empty()) {
    std::string word;
    if (Codec<std::string>::read(node, info, word, reader)) settings.values[info.name] = word;
  } else if (param.whole) {
    int number = 0;
    if (Codec<int>::read(node, info, number, reader))
      settings.values[info.name] = static_cast<double>(number);
  } else {
    double number = 0.0;
    if (Codec<double>::read(node, info, number, reader)) settings.values[info.name] = number;
  }
}

// A key of [solve] that the method does not have: another method's, or nobody's.
void report_foreign(const Entry& entry, const Method* method, Reader& reader) {
  const std::string owners = names_of_methods_with(entry.key);
  if (owners.empty()) {
    std::vector<KeyInfo> known = method ? infos_of(*method) : std::vector<KeyInfo>{};
    known.push_back(method_info());
    report_unknown(entry, known, "[solve]", reader);
  } else if (method) {
    reader.unreadable(entry.origin, fmt::format("{} is a key of the method {}, not of \"{}\"",
                                                in_quotes(entry.key), owners, method->name));
  }
}

void read_solve(const Node& node, Scene& scene, Reader& reader) {
  reader.begin_entry("solve", 0);
  const auto* table = node.get<Node::Table>();
  if (!table) return report_no_table(node, "[solve]", reader);
  const Method* method = read_method(node, reader);
  scene.solve_given = true;
  scene.settings = {method ? std::string(method->name) : std::string(), {}};
  for (const Entry& entry : *table) {
    if (reader.full()) return;
    if (entry.key == "method") continue;
    reader.begin_key(entry.key);
    const Param* param = method ? find_param(*method, entry.key) : nullptr;
    if (param)
      read_param(entry.node, *param, scene.settings, reader);
    else
      report_foreign(entry, method, reader);
  }
}

std::string write_solve(const Scene& scene) {
  std::string out = fmt::format("[solve]\nmethod = {}\n", toml_string(scene.settings.method));
  const Method* method = find_method(scene.settings.method);
  for (const Param& param : method->params)
    out += fmt::format("{} = {}\n", param.name,
                       write_value(scene.settings.values.find(param.name)->second, param.whole));
  return out;
}

}  // namespace

Settings default_settings() {
  return complete_settings({"xpbd", {{"steps_per_second", 600.0}}});
}

Section solve_section() {
  Section section{"solve", false, "How the scene is simulated. Each method has keys of its own.", {}, {}, {}};
  section.groups.push_back({"", {method_info()}});
  for (const Method& method : all_methods())
    section.groups.push_back(
        {fmt::format("method = \"{}\": {}", method.name, method.title), infos_of(method)});
  section.read = read_solve;
  section.write = write_solve;
  return section;
}

}  // namespace taut
