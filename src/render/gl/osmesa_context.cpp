#include "base/failure.h"
#include "gl/gl_backends.h"

#ifdef TAUT_HAS_OSMESA
#include <GL/osmesa.h>

#include <array>
#endif

namespace taut {

#ifdef TAUT_HAS_OSMESA
namespace {

class OsmesaContext final : public GlContext {
 public:
  OsmesaContext() {
    const std::array<int, 15> attributes{OSMESA_FORMAT,
                                         OSMESA_RGBA,
                                         OSMESA_DEPTH_BITS,
                                         24,
                                         OSMESA_STENCIL_BITS,
                                         0,
                                         OSMESA_ACCUM_BITS,
                                         0,
                                         OSMESA_PROFILE,
                                         OSMESA_CORE_PROFILE,
                                         OSMESA_CONTEXT_MAJOR_VERSION,
                                         3,
                                         OSMESA_CONTEXT_MINOR_VERSION,
                                         3,
                                         0};
    context_ = OSMesaCreateContextAttribs(attributes.data(), nullptr);
    if (context_ == nullptr) throw RunFailure("OSMesa offers no OpenGL 3.3 core context");
  }

  ~OsmesaContext() override { OSMesaDestroyContext(context_); }

  void make_current() override {
    if (OSMesaMakeCurrent(context_, unused_.data(), GL_UNSIGNED_BYTE, side, side) == GL_FALSE) {
      throw RunFailure("OSMesa can't make its context current");
    }
  }

  void release() override { OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }

  Function function(const char* name) const override { return OSMesaGetProcAddress(name); }

  std::string name() const override { return "osmesa"; }

 private:
  // OSMesa insists on a buffer of its own; everything is drawn into framebuffer objects instead.
  static constexpr int side = 16;
  std::array<unsigned char, std::size_t{side} * side * 4> unused_{};
  OSMesaContext context_ = nullptr;
};

}  // namespace

std::unique_ptr<GlContext> make_osmesa_context() {
  return std::make_unique<OsmesaContext>();
}

#else

std::unique_ptr<GlContext> make_osmesa_context() {
  throw RunFailure("this program was built without OSMesa");
}

#endif

}  // namespace taut
