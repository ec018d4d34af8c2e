#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "gl/gl_objects.h"

namespace taut {

/// What is chosen when a shader is compiled: a name each, or a name and its value.
using Defines = std::vector<std::string>;

/// Texts of shaders: from a folder where it has the file, else as embedded when the program was built.
class ShaderLibrary {
 public:
  /// `folder` may be empty; `constants` are defined in all shaders. Throws RunFailure when a folder is given
  /// and is none.
  ShaderLibrary(std::filesystem::path folder, Defines constants);

  /// One shader with every line #include "name" replaced by that file's text, each file once, and after its
  /// first a line #define for each of the constants and of the given words. Throws RunFailure for a name that
  /// is neither in the folder nor embedded.
  std::string source(std::string_view name, const Defines& defines = {}) const;

 private:
  std::string text(std::string_view name) const;

  std::filesystem::path folder_;
  Defines constants_;
};

/// A linked program of a vertex and a fragment shader. Its uniform block Frame reads from binding 0, its
/// samplers shadow_map, light_map, blocker_map and shade_map from texture units 0, 1, 5 and 6.
class Program {
 public:
  /// Throws RunFailure with the log of the compiler or linker.
  Program(const Gl& gl, const ShaderLibrary& library, std::string_view vertex, std::string_view fragment,
          const Defines& defines = {});

  void use() const { gl_->use_program(program_.name()); }
  void set(const char* uniform, int value) const;
  void set(const char* uniform, const glm::vec3& vector) const;

 private:
  const Gl* gl_;
  GlObject program_;
};

}  // namespace taut
