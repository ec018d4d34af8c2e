#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "base/json_text.h"
#include "colour_names.h"
#include "scene/scene.h"
#include "section.h"

namespace taut {
namespace {

using Json = nlohmann::ordered_json;

// A cell of a Markdown table: bars would end it.
std::string cell(std::string_view text) {
  if (text.empty()) return "–";
  std::string out;
  for (const char c : text) {
    if (c == '|') out += '\\';
    out += c;
  }
  return out;
}

std::string default_cell(const KeyInfo& info) {
  if (info.required) return "**required**";
  // Values are code, words are not: words are what needs no TOML syntax.
  const bool value = info.fallback.find_first_of("\"[{0123456789") != std::string::npos ||
                     info.fallback == "true" || info.fallback == "false";
  return value ? fmt::format("`{}`", info.fallback) : cell(info.fallback);
}

std::string range_cell(const KeyInfo& info) {
  std::string words;
  for (const std::string_view choice : info.choices)
    words += fmt::format("{}`\"{}\"`", words.empty() ? "" : ", ", choice);
  return words.empty() ? cell(range_signs(info.range)) : words;
}

std::string rows(const std::vector<KeyInfo>& keys, const std::string& prefix) {
  std::string out;
  for (const KeyInfo& info : keys) {
    out += fmt::format("| `{}{}` | {} | {} | {} | {} | {} |\n", prefix, info.name, cell(info.type),
                       cell(info.unit), default_cell(info), range_cell(info), cell(info.help));
    out += rows(info.inner, fmt::format("{}{}.", prefix, info.name));
  }
  return out;
}

std::string table(const std::vector<KeyInfo>& keys) {
  return fmt::format("| key | type | unit | default | range | meaning |\n|---|---|---|---|---|---|\n{}",
                     rows(keys, ""));
}

// The ends of doubles stand for no limit.
Json bound(double value, double none) {
  return value == none ? Json() : Json(value);
}

Json to_json(const std::vector<KeyInfo>& keys) {
  Json list = Json::array();
  for (const KeyInfo& info : keys) {
    const Range open;
    Json key{{"name", info.name},
             {"type", info.type},
             {"unit", info.unit},
             {"required", info.required},
             {"default", info.required ? Json() : Json(info.fallback)},
             {"min", bound(info.range.min, open.min)},
             {"max", bound(info.range.max, open.max)},
             {"above_min", info.range.min_excluded},
             {"choices", info.choices},
             {"help", info.help}};
    if (!info.inner.empty()) key["keys"] = to_json(info.inner);
    list.push_back(std::move(key));
  }
  return list;
}

}  // namespace

std::string key_reference_json() {
  Json list = Json::array();
  for (const Section& section : all_sections()) {
    Json groups = Json::array();
    for (const KeyGroup& group : section.groups)
      groups.push_back({{"title", group.title}, {"keys", to_json(group.keys)}});
    list.push_back({{"section", section.name},
                    {"repeated", section.repeated},
                    {"help", section.help},
                    {"groups", std::move(groups)}});
  }
  return json_text(list, 2);
}

std::string key_reference() {
  std::string out =
      "# Keys of a scene file\n\n"
      "A scene is a TOML file. Numbers are in SI units, angles in degrees unless said otherwise; an integer\n"
      "counts as a number, `nan` and `inf` do not. Every key can be set from the command line by its dotted\n"
      "path, entries of a list by name, by number from 0, or all of them by `*`: `--set world.drag=0.5`, "
      "`--set\n"
      "sheet.cloth.rows=32`, `--set link.0.length=1`, `--set 'ragdoll.*.visible=false'`. A bare name means "
      "a\n"
      "key of `[solve]`.\n\n"
      "A colour is a list of red, green and blue, each 0 to 1 as on a display, text such as `\"#cc8c33\"`, "
      "or one\n"
      "of these names: ";
  out += fmt::format("{}.\n\nThis page is made by the program from the table its parser works with.\n",
                     fmt::join(colour_names(), ", "));
  for (const Section& section : all_sections()) {
    out +=
        fmt::format("\n## {}\n\n{}\n",
                    section.name.empty() ? "Top level" : fmt::format("`{}`", section.label()), section.help);
    for (const KeyGroup& group : section.groups) {
      if (!group.title.empty()) out += fmt::format("\n### {}\n", group.title);
      out += fmt::format("\n{}", table(group.keys));
    }
  }
  return out;
}

}  // namespace taut
