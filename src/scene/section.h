#pragma once

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "key.h"
#include "scene/scene.h"

namespace taut {

/// Keys that are documented together.
struct KeyGroup {
  std::string title;  ///< empty for a section's only group
  std::vector<KeyInfo> keys;
};

/// A section of a scene file, whatever its keys are stored in.
struct Section {
  std::string name;       ///< empty: the keys above the first section
  bool repeated = false;  ///< [[name]], any number of them
  std::string help;
  std::vector<KeyGroup> groups;
  std::function<void(const Node&, Scene&, Reader&)> read;  ///< the section's node: a table, or a list of them
  std::function<std::string(const Scene&)> write;          ///< the section as TOML, header included

  /// `[name]` or `[[name]]`.
  std::string label() const { return repeated ? fmt::format("[[{}]]", name) : fmt::format("[{}]", name); }
};

/// Every section, in the order in which it is documented and written.
std::vector<Section> all_sections();

/// A section that occurs once, stored in what `access` gives of a Scene.
template <class T, class Access>
Section single_section(std::string name, std::string help, Keys<T> keys, Access access) {
  Section section{std::move(name), false, std::move(help), {{"", infos(keys)}}, {}, {}};
  const std::string id = section.name, label = section.label();
  section.read = [id, label, keys, access](const Node& node, Scene& scene, Reader& reader) {
    reader.begin_entry(id, 0);
    read_table(node, keys, label, TableKind::entry, std::invoke(access, scene), reader);
  };
  section.write = [label, keys, access](const Scene& scene) {
    return label + "\n" + write_lines(keys, std::invoke(access, scene));
  };
  return section;
}

/// A section that occurs once or not at all, stored in the std::optional that `access` gives of a Scene.
template <class T, class Access>
Section optional_section(std::string name, std::string help, Keys<T> keys, Access access) {
  Section section{std::move(name), false, std::move(help), {{"", infos(keys)}}, {}, {}};
  const std::string id = section.name, label = section.label();
  section.read = [id, label, keys, access](const Node& node, Scene& scene, Reader& reader) {
    reader.begin_entry(id, 0);
    read_table(node, keys, label, TableKind::entry, std::invoke(access, scene).emplace(), reader);
  };
  section.write = [label, keys, access](const Scene& scene) {
    const std::optional<T>& entry = std::invoke(access, scene);
    return entry ? label + "\n" + write_lines(keys, *entry) : std::string();
  };
  return section;
}

/// Has each table of a list read by `read_entry(table, number)`; reports what is no list of tables.
template <class ReadEntry>
void read_entries(const Node& node, const std::string& id, const std::string& label, Reader& reader,
                  const ReadEntry& read_entry) {
  const auto* list = node.get<Node::List>();
  if (!list) {
    reader.begin_entry("", 0);
    reader.unreadable(node.origin, node.origin.change < 0
                                       ? fmt::format("write {} in place of [{}]", label, id)
                                       : fmt::format("the scene has no {} to change", label));
    return;
  }
  for (std::size_t i = 0; i < list->size() && !reader.full(); ++i) {
    reader.begin_entry(id, i);
    if (!(*list)[i].get<Node::Table>()) {
      // A list of something else was meant for another place: to say so of each element helps nobody.
      report_no_table((*list)[i], label, reader);
      return;
    }
    read_entry((*list)[i], i);
  }
}

/// A section that occurs any number of times, stored in the std::vector that `access` gives of a Scene.
template <class T, class Access>
Section repeated_section(std::string name, std::string help, Keys<T> keys, Access access) {
  Section section{std::move(name), true, std::move(help), {{"", infos(keys)}}, {}, {}};
  const std::string id = section.name, label = section.label();
  section.read = [id, label, keys, access](const Node& node, Scene& scene, Reader& reader) {
    std::vector<T>& entries = std::invoke(access, scene);
    read_entries(node, id, label, reader, [&](const Node& entry, std::size_t) {
      read_table(entry, keys, label, TableKind::entry, entries.emplace_back(), reader);
    });
  };
  section.write = [label, keys, access](const Scene& scene) {
    std::string out;
    for (const T& entry : std::invoke(access, scene))
      out += (out.empty() ? "" : "\n") + label + "\n" + write_lines(keys, entry);
    return out;
  };
  return section;
}

/// The sections of each part of a scene.
std::vector<Section> physics_sections();
std::vector<Section> file_sections();
std::vector<Section> body_sections();
std::vector<Section> surroundings_sections();
std::vector<Section> view_sections();
Section world_section();
Section title_section();
Section solve_section();

/// What runs when a scene says nothing: xpbd, 600 steps per second.
Settings default_settings();

}  // namespace taut
