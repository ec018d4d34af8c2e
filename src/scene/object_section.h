#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "section.h"

namespace taut {

/// An object of a scene as it is written: what it is, and how it is drawn, which physics knows nothing of.
template <class Spec>
struct Dressed {
  Spec spec;
  ObjectLook look;
};

/// What a kind of objects may be told of its look, beside its colour.
struct LookFacts {
  std::string_view visible;                      ///< what `visible` means for it, in words
  std::string_view colour;                       ///< the same of `colour`
  std::span<const std::string_view> parts = {};  ///< what it may be drawn as; none: it is one thing
  bool two_sides = false;                        ///< whether it has a back
};

/// The keys of an object's look.
Keys<ObjectLook> object_look_keys(const LookFacts& facts);

/// Keys of a part of something, as keys of the whole.
template <class Whole, class Part>
Keys<Whole> keys_of_part(const Keys<Part>& keys, Part Whole::*part) {
  Keys<Whole> lifted;
  for (const Key<Part>& each : keys)
    lifted.push_back({each.info,
                      [read = each.read, part](const Node& node, const KeyInfo& info, Whole& out,
                                               Reader& reader) { read(node, info, out.*part, reader); },
                      [write = each.write, part](const Whole& value) { return write(value.*part); }});
  return lifted;
}

/// A section of objects: what they are is stored in the description, how they are drawn in the look.
/// `check_table` may report what is wrong with which keys an object has.
template <class Spec>
Section object_section(std::string name, std::string help, const Keys<Spec>& keys, const LookFacts& facts,
                       std::vector<Spec> Description::*specs, std::vector<ObjectLook> ObjectLooks::*looks,
                       void (*check_table)(const Node&, Reader&) = nullptr) {
  using Object = Dressed<Spec>;
  Keys<Object> all = keys_of_part(keys, &Object::spec);
  for (Key<Object>& each : keys_of_part(object_look_keys(facts), &Object::look))
    all.push_back(std::move(each));
  Section section{std::move(name), true, std::move(help), {{"", infos(all)}}, {}, {}};
  const std::string id = section.name, label = section.label();
  section.read = [id, label, all, specs, looks, check_table](const Node& node, Scene& scene, Reader& reader) {
    read_entries(node, id, label, reader, [&](const Node& entry, std::size_t) {
      Object read;
      read_table(entry, all, label, TableKind::entry, read, reader);
      if (check_table != nullptr) check_table(entry, reader);
      (scene.description.*specs).push_back(std::move(read.spec));
      (scene.look.objects.*looks).push_back(std::move(read.look));
    });
  };
  section.write = [label, all, specs, looks](const Scene& scene) {
    const std::vector<ObjectLook>& written = scene.look.objects.*looks;
    std::string out;
    std::size_t number = 0;
    for (const Spec& spec : scene.description.*specs) {
      const Object object{spec, number < written.size() ? written[number] : ObjectLook{}};
      out += (out.empty() ? "" : "\n") + label + "\n" + write_lines(all, object);
      ++number;
    }
    return out;
  };
  return section;
}

}  // namespace taut
