#include "scene/scene.h"
#include "section.h"

namespace taut {

std::string resolved_toml(const Scene& scene) {
  std::string out;
  for (const Section& section : all_sections()) {
    const std::string text = section.write(scene);
    if (!text.empty()) out += (out.empty() ? "" : "\n") + text;
  }
  return out;
}

}  // namespace taut
