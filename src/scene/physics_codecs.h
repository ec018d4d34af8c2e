#pragma once

#include "key.h"
#include "model/description.h"

namespace taut {

/// The largest coordinate (m), speed (m/s) and time (s) a scene may name: beyond it, double precision leaves
/// a simulation no room for detail.
inline constexpr double far = 1e6;

/// The keys of LinkProperties, for whatever holds them; `access` gives the LinkProperties of a T.
template <class T, class Access>
Keys<T> link_property_keys(Access access) {
  return {
      key<T>("acts", [access](auto& t) -> auto& { return std::invoke(access, t).acts; },
             {.help = "both: a link pulls when it is longer than its length and pushes when it is shorter; "
                      "pull: a rope, slack when it is shorter; push: a buffer, free when it is longer; "
                      "between: free from its length up to its longest"}),
      key<T>("longest", [access](auto& t) -> auto& { return std::invoke(access, t).longest; },
             {.unit = "× length",
              .range = above_to(1, 1e6),
              .fallback = "none",
              .help = "at which a link that acts between begins to pull"}),
      key<T>("stiffness", [access](auto& t) -> auto& { return std::invoke(access, t).stiffness; },
             {.unit = "N/m",
              .range = above_to(0, 1e15),
              .fallback = "rigid",
              .help = "how hard a link pulls for each metre it is stretched"}),
      key<T>("damping", [access](auto& t) -> auto& { return std::invoke(access, t).damping; },
             {.unit = "N s/m",
              .range = between(0, 1e12),
              .help = "how hard a link resists the speed at which it is stretched; not for rigid links"}),
      key<T>("break_stretch", [access](auto& t) -> auto& { return std::invoke(access, t).break_stretch; },
             {.unit = "× length",
              .range = above_to(1, 1e6),
              .fallback = "never",
              .help = "a link longer than this share of its length breaks"}),
      key<T>("break_tension", [access](auto& t) -> auto& { return std::invoke(access, t).break_tension; },
             {.unit = "N",
              .range = above_to(0, 1e15),
              .fallback = "never",
              .help = "a link that pulls harder than this breaks"}),
      key<T>("break_at", [access](auto& t) -> auto& { return std::invoke(access, t).break_at; },
             {.unit = "s",
              .range = above_to(0, far),
              .fallback = "never",
              .help = "when a link breaks, whatever it bears"}),
      key<T>("scatter", [access](auto& t) -> auto& { return std::invoke(access, t).scatter; },
             {.range = between(0, 0.999999),
              .help = "share up to which links bear more or less than their thresholds, each its own"}),
      key<T>("scatter_seed", [access](auto& t) -> auto& { return std::invoke(access, t).scatter_seed; },
             {.range = between(0, 1e9), .help = "which of them more, and which less"}),
  };
}

/// How a solid is moved: a sinusoid's keys or a path.
template <>
struct Codec<WaySpec> {
  static std::string type() { return "a table"; }
  static std::vector<KeyInfo> inner();
  static bool read(const Node& node, const KeyInfo& info, WaySpec& out, Reader& reader);
  static std::string write(const WaySpec& value);
};

/// How a pin is driven: as a solid, or with one.
template <>
struct Codec<MotionSpec> {
  static std::string type() { return "a table"; }
  static std::vector<KeyInfo> inner();
  static bool read(const Node& node, const KeyInfo& info, MotionSpec& out, Reader& reader);
  static std::string write(const MotionSpec& value);
};

/// A table that may be left out, by its keys.
template <class Spec, const Keys<Spec>& (*keys)()>
struct OptionalTable {
  static std::string type() { return "a table"; }
  static std::vector<KeyInfo> inner() { return infos(keys()); }
  static bool read(const Node& node, const KeyInfo& info, std::optional<Spec>& out, Reader& reader) {
    return read_table(node, keys(), in_quotes(info.name), TableKind::value, out.emplace(), reader);
  }
  static std::string write(const std::optional<Spec>& value) {
    return value ? write_inline(keys(), *value) : std::string();
  }
};

/// How a chain is wound around a solid, where it is.
const Keys<WindingSpec>& winding_keys();
template <>
struct Codec<std::optional<WindingSpec>> : OptionalTable<WindingSpec, winding_keys> {};

/// How a solid turns: at a rate, or through angles.
const Keys<RotationSpec>& rotation_keys();
template <>
struct Codec<std::optional<RotationSpec>> : OptionalTable<RotationSpec, rotation_keys> {};

template <>
struct Codec<HookSpec> {
  static std::string type() { return "a table"; }
  static std::vector<KeyInfo> inner();
  static bool read(const Node& node, const KeyInfo& info, HookSpec& out, Reader& reader);
  static std::string write(const HookSpec& value);
};

/// How faces touch; absent: they don't.
const Keys<FacesSpec>& faces_keys();
template <>
struct Codec<std::optional<FacesSpec>> : OptionalTable<FacesSpec, faces_keys> {};

/// How a chain, and a sheet, resist being bent; absent: they don't.
const Keys<BendingSpec>& bending_keys();
template <>
struct Codec<std::optional<BendingSpec>> : OptionalTable<BendingSpec, bending_keys> {};

const Keys<SheetBendingSpec>& sheet_bending_keys();
template <>
struct Codec<std::optional<SheetBendingSpec>> : OptionalTable<SheetBendingSpec, sheet_bending_keys> {};

/// One more family of links: not there, there and rigid (true), or there with properties of its own.
template <>
struct Codec<ExtraLinks> {
  static std::string type() { return "true, false or a table"; }
  static std::vector<KeyInfo> inner();
  static bool read(const Node& node, const KeyInfo& info, ExtraLinks& out, Reader& reader);
  static std::string write(const ExtraLinks& value);
};

}  // namespace taut
