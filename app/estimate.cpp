#include "estimate.h"

#include <fmt/format.h>

#include "base/memory.h"
#include "host/progress.h"
#include "measure/cost.h"
#include "methods/registry.h"

namespace taut {
namespace {

constexpr double much_memory = 1e9;                                              // bytes
constexpr double long_build = 1.0, long_simulation = 60.0, long_drawing = 60.0;  // s

}  // namespace

std::string size_note(const Counts& counts) {
  const double bytes = bytes_needed(counts), seconds = seconds_to_build(counts);
  if (seconds < long_build && bytes < much_memory) return {};
  return fmt::format("{:.4g} masses and {:.4g} links: about {}, and {} to build", counts.masses, counts.links,
                     format_bytes(bytes), duration_text(seconds));
}

std::string run_note(const Scene& scene, double picture_bytes) {
  const double bytes = bytes_needed(count(scene.description)) + picture_bytes +
                       memory_of_step(method_called(scene.settings.method), scene.model);
  const double seconds = predicted_seconds(scene.model, scene.settings, scene.duration);
  if (seconds < long_simulation && bytes < much_memory) return {};
  const std::string memory = bytes < much_memory ? "" : fmt::format("{} and ", format_bytes(bytes));
  return fmt::format("to simulate all {:.4g} s with {} takes about {}{}", scene.duration,
                     scene.settings.method, memory, duration_text(seconds));
}

std::string drawing_note(std::size_t frames, double seconds) {
  if (seconds < long_drawing) return {};
  return fmt::format("to draw {} frames takes about {}", frames, duration_text(seconds));
}

}  // namespace taut
