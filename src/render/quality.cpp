#include <algorithm>
#include <cmath>

#include "render/renderer.h"

namespace taut {

std::optional<Quality> quality_named(std::string_view name) {
  if (name == "draft") return Quality::draft;
  if (name == "standard") return Quality::standard;
  if (name == "fine") return Quality::fine;
  return std::nullopt;
}

namespace {

RenderSettings usual_settings(Quality quality) {
  switch (quality) {
    case Quality::draft:
      return {.size = {640, 360}, .samples = 1, .shadow_map_size = 0, .transparent = false};
    case Quality::fine:
      return {.size = {1920, 1080}, .samples = 8, .shadow_map_size = 2048, .transparent = false};
    case Quality::standard:
      break;
  }
  return {.size = {1280, 720}, .samples = 4, .shadow_map_size = 1024, .transparent = false};
}

// Shadows in a larger picture need a larger map to look the same; in a smaller one they can do with the
// usual.
int map_size_for(int usual, int usual_height, int height) {
  constexpr int step = 256, most = 8192;
  if (usual == 0 || height <= usual_height) return usual;
  const double wanted = static_cast<double>(usual) * height / usual_height;
  return std::min(most, static_cast<int>(std::ceil(wanted / step)) * step);
}

}  // namespace

RenderSettings render_settings_for(Quality quality, std::optional<Size> size) {
  RenderSettings settings = usual_settings(quality);
  if (!size) return settings;
  settings.shadow_map_size = map_size_for(settings.shadow_map_size, settings.size.height,
                                          std::max(size->height, size->width * 9 / 16));
  settings.size = *size;
  return settings;
}

}  // namespace taut
