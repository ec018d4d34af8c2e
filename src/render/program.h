#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "gl_objects.h"

namespace taut {

/// Texts of shaders: from a folder where it has the file, else as embedded when the program was built.
class ShaderLibrary {
 public:
  /// `folder` may be empty. Throws RunFailure when it is given and is no folder.
  explicit ShaderLibrary(std::filesystem::path folder);

  /// One shader with every line #include "name" replaced by that file's text, each file once. Throws
  /// RunFailure for a name that is neither in the folder nor embedded.
  std::string source(std::string_view name) const;

 private:
  std::string text(std::string_view name) const;

  std::filesystem::path folder_;
};

/// A linked program of a vertex and a fragment shader. Its uniform block Frame reads from binding 0, its
/// sampler shadow_map from texture unit 0.
class Program {
 public:
  /// Throws RunFailure with the log of the compiler or linker.
  Program(const Gl& gl, const ShaderLibrary& library, std::string_view vertex, std::string_view fragment);

  void use() const { gl_->use_program(program_.name()); }
  void set(const char* uniform, int value) const;
  void set(const char* uniform, float x, float y, float z) const;

 private:
  const Gl* gl_;
  GlObject program_;
};

}  // namespace taut
