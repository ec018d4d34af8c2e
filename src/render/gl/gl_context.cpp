#include "render/gl_context.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <thread>

#include "base/failure.h"
#include "base/memory.h"
#include "gl/gl.h"
#include "gl/gl_backends.h"

namespace taut {
namespace {

struct Backend {
  GlBackend backend;
  std::string_view name;
  std::unique_ptr<GlContext> (*make)(std::optional<int> device);
};

// In the order in which `automatic` tries them.
constexpr std::array backends{
    Backend{GlBackend::osmesa, "osmesa", [](std::optional<int> /*device*/) { return make_osmesa_context(); }},
    Backend{GlBackend::egl, "egl", make_egl_context}};

std::string known_backends() {
  std::string names;
  for (const Backend& backend : backends) names += (names.empty() ? "" : ", ") + std::string(backend.name);
  return names;
}

// Mesa and the compiler in it don't survive that there are no more addresses, so there have to be enough
// before they are begun with: for themselves, and for the stack and the heap of each thread that draws.
void require_room_to_draw() {
  constexpr double for_all = 600e6, for_a_thread = 100e6;  // bytes
  const double threads = std::clamp(std::thread::hardware_concurrency(), 1U, 32U);
  const double needed = for_all + for_a_thread * threads, room = room_for_addresses();
  if (room < needed)
    throw RunFailure("there is not enough memory to draw: OpenGL may take " + format_bytes(needed) +
                     ", and the limit of this process (ulimit -v) leaves " + format_bytes(room));
}

GlDevice tried(const GlChoice& choice) {
  GlDevice device{choice.name(), {}, {}};
  try {
    device.description = make_gl_context(choice)->description();
  } catch (const RunFailure& failure) {
    device.problem = failure.what();
  }
  return device;
}

}  // namespace

std::string GlContext::description() {
  const CurrentContext current(*this);
  const Gl gl(*this);
  const auto text = [&](GLenum what) {
    return std::string(reinterpret_cast<const char*>(gl.get_string(what)));
  };
  return name() + ": " + text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

std::string GlChoice::name() const {
  const auto found = std::ranges::find(backends, backend, &Backend::backend);
  const std::string text(found == backends.end() ? "auto" : found->name);
  return device ? text + ":" + std::to_string(*device) : text;
}

std::optional<GlChoice> gl_choice_named(std::string_view name) {
  if (name == "auto") return GlChoice();
  for (const Backend& backend : backends)
    if (backend.name == name) return GlChoice(backend.backend);
  constexpr std::string_view egl_device = "egl:";
  if (!name.starts_with(egl_device)) return std::nullopt;
  name.remove_prefix(egl_device.size());
  int number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (error != std::errc() || end != name.data() + name.size() || number < 0) return std::nullopt;
  return GlChoice(GlBackend::egl, number);
}

std::unique_ptr<GlContext> make_gl_context(const GlChoice& choice) {
  require_room_to_draw();
  std::string reasons;
  for (const Backend& backend : backends) {
    if (choice.backend != GlBackend::automatic && choice.backend != backend.backend) continue;
    try {
      return backend.make(choice.device);
    } catch (const RunFailure& failure) {
      reasons += "\n  " + std::string(backend.name) + ": " + failure.what();
    }
  }
  throw RunFailure("no OpenGL context could be made (known back ends: " + known_backends() + ")" + reasons);
}

std::vector<GlDevice> gl_devices() {
  std::vector<GlDevice> devices{tried(GlBackend::osmesa), tried(GlBackend::egl)};
  for (int number = 0; number < count_egl_devices(); ++number)
    devices.push_back(tried({GlBackend::egl, number}));
  return devices;
}

}  // namespace taut
