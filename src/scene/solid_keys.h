#pragma once

#include "object_section.h"

namespace taut {

/// What solids of every shape are told: how they move, and what it is like to touch them.
template <class T>
Keys<T> touch_keys() {
  return {
      key<T>("name", [](auto& t) -> auto& { return t.moves.name; }, {.help = "for pins that it carries"}),
      key<T>("motion", [](auto& t) -> auto& { return t.moves.motion; },
             {.fallback = "stays",
              .help = "how it is moved: where the first of its places is at which time; friction carries "
                      "along what touches it"}),
      key<T>("rotation", [](auto& t) -> auto& { return t.moves.rotation; },
             {.fallback = "stays", .help = "how it is turned, beside its motion"}),
      key<T>("friction", &T::friction, {.range = between(0, 100), .help = "Coulomb's coefficient"}),
      key<T>("restitution", &T::restitution,
             {.range = between(0, 1), .help = "share of the speed of approach that is given back"}),
  };
}

/// What they are told of their look.
inline constexpr LookFacts solid_look{.visible = "whether it is drawn; it is there all the same",
                                      .colour = "of the solid"};

}  // namespace taut
