#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taut {

/// A way to an OpenGL 3.3 core context without a display.
enum class GlBackend { automatic, osmesa, egl };

/// A back end, and which of EGL's devices (graphics cards, and Mesa's software as one).
struct GlChoice {
  GlBackend backend = GlBackend::automatic;
  std::optional<int> device = std::nullopt;

  GlChoice(GlBackend which = GlBackend::automatic, std::optional<int> number = {})
      : backend(which), device(number) {}
  /// As gl_choice_named() takes it.
  std::string name() const;
};

/// The choice called "auto", "osmesa", "egl" or "egl:N"; nothing for any other name.
std::optional<GlChoice> gl_choice_named(std::string_view name);

/// An OpenGL context that draws into framebuffer objects only. It may move between threads, as long as it is
/// current in one at a time.
class GlContext {
 public:
  using Function = void (*)();

  GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  virtual ~GlContext() = default;

  /// Makes this the calling thread's context. Throws RunFailure when that fails.
  virtual void make_current() = 0;

  /// Leaves the calling thread without a context, so that another may take this one.
  virtual void release() = 0;

  /// Address of an OpenGL function by its name ("glClear"); null when there is none.
  virtual Function function(const char* name) const = 0;

  /// The back end's name: "osmesa" or "egl".
  virtual std::string name() const = 0;

  /// The back end and what it draws with, such as "osmesa: llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 3.3 …".
  std::string description();
};

/// Makes a context. `automatic` takes the first back end that works, OSMesa before EGL; EGL without a number
/// Mesa's surfaceless platform, or else the first device that works. Throws RunFailure, with the reasons and
/// the known back ends, when none does.
std::unique_ptr<GlContext> make_gl_context(const GlChoice& choice = {});

/// One way to get a context on this machine.
struct GlDevice {
  std::string name;         ///< of the choice
  std::string description;  ///< GlContext::description(); empty where none can be made
  std::string problem;      ///< why not; empty where one can
};

/// All of them.
std::vector<GlDevice> gl_devices();

/// Keeps a context current in this thread for as long as this object lives.
class CurrentContext {
 public:
  explicit CurrentContext(GlContext& context) : context_(context) { context_.make_current(); }
  CurrentContext(const CurrentContext&) = delete;
  CurrentContext& operator=(const CurrentContext&) = delete;
  ~CurrentContext() { context_.release(); }

 private:
  GlContext& context_;
};

}  // namespace taut
