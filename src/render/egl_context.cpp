#include "base/failure.h"
#include "gl_backends.h"

#ifdef TAUT_HAS_EGL
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#endif

namespace taut {

#ifdef TAUT_HAS_EGL
namespace {

EGLDisplay surfaceless_display() {
  const auto get_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (get_display == nullptr) throw RunFailure("EGL knows no platforms");
  EGLDisplay display = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY) throw RunFailure("EGL has no surfaceless platform");
  return display;
}

class EglContext final : public GlContext {
 public:
  EglContext() : display_(surfaceless_display()) {
    if (eglInitialize(display_, nullptr, nullptr) == EGL_FALSE) {
      throw RunFailure("EGL's surfaceless platform can't be initialised");
    }
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) throw RunFailure("EGL offers no desktop OpenGL");
    const std::array<EGLint, 7> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                           3,
                                           EGL_CONTEXT_MINOR_VERSION,
                                           3,
                                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                           EGL_NONE};
    context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
    if (context_ == EGL_NO_CONTEXT) throw RunFailure("EGL offers no OpenGL 3.3 core context");
  }

  // The display stays initialised: it is shared by every context of the process.
  ~EglContext() override { eglDestroyContext(display_, context_); }

  void make_current() override {
    // The bound interface is a setting of the thread, and this may be another one than the constructor's.
    eglBindAPI(EGL_OPENGL_API);
    if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE) {
      throw RunFailure("EGL can't make its context current");
    }
  }

  void release() override { eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

  Function function(const char* name) const override { return eglGetProcAddress(name); }

  std::string name() const override { return "egl"; }

 private:
  EGLDisplay display_;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<GlContext> make_egl_context() {
  return std::make_unique<EglContext>();
}

#else

std::unique_ptr<GlContext> make_egl_context() {
  throw RunFailure("this program was built without EGL");
}

#endif

}  // namespace taut
