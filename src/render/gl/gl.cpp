#include "gl/gl.h"

#include <string>

#include "base/failure.h"

namespace taut {

GlLoader::Found GlLoader::operator()(const char* name) const {
  const GlContext::Function function = context_.function(name);
  if (function == nullptr) {
    throw RunFailure("the OpenGL back end \"" + context_.name() + "\" has no function " + name);
  }
  return Found(function);
}

void check_gl(const Gl& gl, const char* doing) {
  const GLenum error = gl.get_error();
  if (error == GL_NO_ERROR) return;
  const std::string what = error == GL_OUT_OF_MEMORY ? "out of memory" : "error " + std::to_string(error);
  throw RunFailure("OpenGL: " + what + " while " + doing);
}

}  // namespace taut
