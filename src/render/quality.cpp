#include "render/renderer.h"

namespace taut {

std::optional<Quality> quality_named(std::string_view name) {
  if (name == "draft") return Quality::draft;
  if (name == "standard") return Quality::standard;
  if (name == "fine") return Quality::fine;
  return std::nullopt;
}

RenderSettings render_settings_for(Quality quality) {
  switch (quality) {
    case Quality::draft:
      return {.size = {640, 360}, .samples = 1, .shadow_map_size = 0, .transparent = false};
    case Quality::fine:
      return {.size = {1920, 1080}, .samples = 4, .shadow_map_size = 2048, .transparent = false};
    case Quality::standard:
      break;
  }
  return {.size = {1280, 720}, .samples = 4, .shadow_map_size = 1024, .transparent = false};
}

}  // namespace taut
