#pragma once

#include <string_view>
#include <utility>

#include "physics_codecs.h"
#include "section.h"

namespace taut {

template <class T>
Keys<T> operator+(Keys<T> a, Keys<T> b) {
  for (Key<T>& each : b) a.push_back(std::move(each));
  return a;
}

/// The facts of a required place.
constexpr Facts where(std::string_view help) {
  return {.unit = "m", .range = between(-far, far), .required = true, .help = help};
}

/// The facts of a required name.
constexpr Facts named(std::string_view help) {
  return {.required = true, .help = help};
}

/// What gives a member of the description, of a Scene or of a const one.
template <class Member>
auto description_of(Member Description::*member) {
  return [member](auto& scene) -> auto& {
    return scene.description.*member;
  };
}

/// The keys of what masses touch.
template <class T>
Keys<T> contact_keys() {
  return {
      key<T>(
          "radius", &T::radius,
          {.unit = "m", .range = between(0, far), .help = "of each mass as a ball, for contact; 0: points"}),
      key<T>("collides", &T::collides,
             {.help = "whether its masses touch those of other bodies that collide: chains, sheets, "
                      "ragdolls and single masses are a body each"}),
  };
}

}  // namespace taut
