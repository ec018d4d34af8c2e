#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace taut {

/// The folders in which bare scene names are looked up, in this order: what TAUT_SCENES says, the scenes that
/// came with the program, ./scenes. Only those that exist. The program's own are found from where it lies, so
/// that it may be moved with them: ../share/taut/scenes, or share/taut/scenes beside it, as in a build
/// folder.
std::vector<std::filesystem::path> scene_folders();

/// The scene files of all those folders, each name once, in alphabetical order.
std::vector<std::filesystem::path> all_scene_files();

/// The file that a scene argument means: a path, or the bare name of a file in one of the scene folders.
/// Throws BadRequest, naming the nearest scene, when there is none, or when it is no regular file.
std::filesystem::path find_scene(const std::string& argument);

}  // namespace taut
