#include "base/failure.h"
#include "gl/gl_backends.h"

#ifdef TAUT_HAS_EGL
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <string>
#include <vector>
#endif

namespace taut {

#ifdef TAUT_HAS_EGL
namespace {

template <typename Function>
Function egl_function(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

EGLDisplay platform_display(EGLenum platform, void* native) {
  const auto get_display = egl_function<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  return get_display != nullptr ? get_display(platform, native, nullptr) : EGL_NO_DISPLAY;
}

std::vector<EGLDeviceEXT> all_devices() {
  const auto query = egl_function<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  EGLint count = 0;
  if (query == nullptr || query(0, nullptr, &count) == EGL_FALSE) return {};
  std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
  if (query(count, devices.data(), &count) == EGL_FALSE) return {};
  devices.resize(static_cast<std::size_t>(count));
  return devices;
}

bool initialised(EGLDisplay display) {
  return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE;
}

EGLDisplay display_of(std::optional<int> number) {
  const std::vector<EGLDeviceEXT> devices = all_devices();
  if (number && static_cast<std::size_t>(*number) >= devices.size())
    throw RunFailure("EGL has no device " + std::to_string(*number) + "; it has " +
                     std::to_string(devices.size()) + ", counted from 0");
  if (number) {
    const EGLDisplay display =
        platform_display(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(*number)]);
    if (!initialised(display))
      throw RunFailure("EGL's device " + std::to_string(*number) + " can't be initialised");
    return display;
  }
  const EGLDisplay surfaceless = platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
  if (initialised(surfaceless)) return surfaceless;
  for (EGLDeviceEXT device : devices)
    if (const EGLDisplay display = platform_display(EGL_PLATFORM_DEVICE_EXT, device); initialised(display))
      return display;
  throw RunFailure("EGL has neither a surfaceless platform nor a device that can be initialised");
}

class EglContext final : public GlContext {
 public:
  explicit EglContext(std::optional<int> device) : display_(display_of(device)) {
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

std::unique_ptr<GlContext> make_egl_context(std::optional<int> device) {
  return std::make_unique<EglContext>(device);
}

int count_egl_devices() {
  return static_cast<int>(all_devices().size());
}

#else

std::unique_ptr<GlContext> make_egl_context(std::optional<int> /*device*/) {
  throw RunFailure("this program was built without EGL");
}

int count_egl_devices() {
  return 0;
}

#endif

}  // namespace taut
