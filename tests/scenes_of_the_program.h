#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace taut::test {

/// A scene that comes with the program.
inline Scene scene_called(const std::string& name, const SceneOverrides& overrides = {}) {
  return load_scene(std::filesystem::path(TAUT_SCENE_FOLDER) / (name + ".toml"), overrides);
}

/// The names of all scenes that come with the program, sorted.
inline std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(TAUT_SCENE_FOLDER))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

}  // namespace taut::test
