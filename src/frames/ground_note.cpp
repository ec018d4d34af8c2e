#include "frames/ground_note.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

#include "model/measures.h"
#include "render/camera.h"
#include "render/ground.h"

namespace taut {
namespace {

// "y = 0.5", or where no axis points up a height.
std::string place_of(const Ground& ground) {
  constexpr std::array<std::string_view, 3> names{"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(ground.normal[axis]) == 1.0)
      return fmt::format("{} = {:.6g}", names[static_cast<std::size_t>(axis)], ground.point[axis] + 0.0);
  return fmt::format("height {:.6g} m", ground.normal.dot(ground.point));
}

}  // namespace

std::optional<std::string> ground_note(const Scene& scene, const State& state) {
  const CameraPose pose = camera_pose(scene.camera, scene.model, scene.start, state);
  for (const Ground& ground : drawn_grounds(scene.model, scene.look, pose.up)) {
    const auto height = [&](const Vec3& place) { return ground.normal.dot(place - ground.point); };
    if (ground.solid || height(pose.eye) <= 0.0) continue;
    const double rounding = 1e-9 * scene_size(scene.model, scene.start);
    std::size_t below = 0;
    for (std::size_t i = 0; i < state.position.size(); ++i)
      if (height(state.position.at(i)) < -rounding) ++below;
    if (below > 0)
      return fmt::format(
          "at {:.4g} s {} of {} masses {} below the drawn ground at {}, which stops nothing: add a "
          "[[plane]], or "
          "set look.ground_height or look.ground = false",
          state.time, below, state.position.size(), below == 1 ? "is" : "are", place_of(ground));
  }
  return std::nullopt;
}

}  // namespace taut
