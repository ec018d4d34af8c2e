#pragma once

#include <string>

#include "base/failure.h"
#include "scene/scene.h"

namespace taut {

/// What is said about a scene; empty when nothing is wrong with it.
inline std::string errors_of(const std::string& text, const SceneOverrides& overrides = {}) {
  try {
    parse_scene(text, "f.toml", overrides);
    return {};
  } catch (const BadRequest& failure) {
    return failure.what();
  }
}

/// A chain that is right, with more lines behind it: those start on line 5.
inline std::string chain_with(const std::string& lines) {
  return "[[chain]]\nname = \"rope\"\nfrom = [0, 2, 0]\nto = [2, 2, 0]\n" + lines;
}

inline std::string masses_with(const std::string& lines) {
  return "[[mass]]\nname = \"hand\"\nposition = [0, 0, 0]\npinned = true\n"
         "[[mass]]\nname = \"bob\"\nposition = [1, 0, 0]\n" +
         lines;  // starts on line 8
}

}  // namespace taut
