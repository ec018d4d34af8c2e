#pragma once

#include <span>
#include <string_view>

namespace taut {

/// A scene to begin with, with comments that teach its keys.
struct SceneTemplate {
  std::string_view kind;  ///< what it is made of, as --kind names it
  std::string_view text;  ///< TOML; NAME stands for the scene's name
  std::string_view look;  ///< a flag and its value to try on it, besides; may be empty
};

std::span<const SceneTemplate> scene_templates();

}  // namespace taut
