#include "render/gl_context.h"

#include <array>

#include "base/failure.h"
#include "gl_backends.h"

namespace taut {
namespace {

struct Backend {
  GlBackend backend;
  std::string_view name;
  std::unique_ptr<GlContext> (*make)();
};

// In the order in which `automatic` tries them.
constexpr std::array backends{Backend{GlBackend::osmesa, "osmesa", make_osmesa_context},
                              Backend{GlBackend::egl, "egl", make_egl_context}};

std::string known_backends() {
  std::string names;
  for (const Backend& backend : backends) names += (names.empty() ? "" : ", ") + std::string(backend.name);
  return names;
}

}  // namespace

std::optional<GlBackend> gl_backend_named(std::string_view name) {
  if (name == "auto") return GlBackend::automatic;
  for (const Backend& backend : backends) {
    if (backend.name == name) return backend.backend;
  }
  return std::nullopt;
}

std::unique_ptr<GlContext> make_gl_context(GlBackend wanted) {
  std::string reasons;
  for (const Backend& backend : backends) {
    if (wanted != GlBackend::automatic && wanted != backend.backend) continue;
    try {
      return backend.make();
    } catch (const RunFailure& failure) {
      reasons += "\n  " + std::string(backend.name) + ": " + failure.what();
    }
  }
  throw RunFailure("no OpenGL context could be made (known back ends: " + known_backends() + ")" + reasons);
}

}  // namespace taut
