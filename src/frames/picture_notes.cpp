#include "frames/picture_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "model/measures.h"
#include "render/appearance.h"
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

std::size_t masses_outside(const Scene& scene, const std::vector<bool>& seen_masses, Size size,
                           const State& state) {
  const CameraPose pose = camera_pose(scene.camera, scene.model, scene.start, state);
  // Of all masses at once, so what is the same for them is worked out before.
  const Eigen::Matrix3d to_picture = sight_axes(pose.eye - pose.target, pose.up).transpose();
  const double up = std::tan(0.5 * pose.field_of_view * std::numbers::pi / 180.0);
  const double right = up * size.width / size.height;
  std::size_t outside = 0;
  for (std::size_t i = 0; i < state.position.size(); ++i) {
    if (!seen_masses[i]) continue;
    const Vec3 seen = to_picture * (state.position.at(i) - pose.eye);
    const double depth = -seen.z();
    const bool inside =
        depth > 0.0 && std::abs(seen.x()) <= right * depth && std::abs(seen.y()) <= up * depth;
    if (!inside) ++outside;
  }
  return outside;
}

}  // namespace

std::optional<std::string> ground_note(const Scene& scene, const std::vector<bool>& seen,
                                       const State& state) {
  const CameraPose pose = camera_pose(scene.camera, scene.model, scene.start, state);
  for (const Ground& ground : drawn_grounds(scene.model, scene.look, pose.up)) {
    const auto height = [&](const Vec3& place) { return ground.normal.dot(place - ground.point); };
    if (ground.solid || height(pose.eye) <= 0.0) continue;
    const double rounding = 1e-9 * scene_size(scene.model, scene.start);
    std::size_t below = 0;
    for (std::size_t i = 0; i < state.position.size(); ++i)
      if (seen[i] && height(state.position.at(i)) < -rounding) ++below;
    if (below > 0)
      return fmt::format(
          "at {:.4g} s {} of {} masses {} below the drawn ground at {}, which stops nothing: add a "
          "[[plane]], or "
          "set look.ground_height or look.ground = false",
          state.time, below, std::ranges::count(seen, true), below == 1 ? "is" : "are", place_of(ground));
  }
  return std::nullopt;
}

void PictureNotes::see(const Scene& scene, Size size, bool ground, const State& state) {
  if (seen_masses_.empty()) {
    seen_masses_ = masses_in_view(scene.model, scene.look);
    masses_ = static_cast<std::size_t>(std::ranges::count(seen_masses_, true));
  }
  if (ground && !ground_) ground_ = ground_note(scene, seen_masses_, state);
  const std::size_t outside = masses_outside(scene, seen_masses_, size, state);
  least_out_ = seen_any_ ? std::min(least_out_, outside) : outside;
  seen_any_ = true;
  if (outside > 0 && most_out_ == 0) out_since_ = state.time;
  most_out_ = std::max(most_out_, outside);
}

std::optional<std::string> PictureNotes::text() const {
  if (most_out_ == 0) return ground_;
  const std::string cure = "leave out camera.eye, or let camera.show be a box around all";
  const std::string outside =
      least_out_ == masses_
          ? fmt::format("nothing is in view: all masses are outside the picture; {}", cure)
          : fmt::format("from {:.4g} s on up to {} of {} masses are outside the picture; {}", out_since_,
                        most_out_, masses_, cure);
  return ground_ ? fmt::format("{}; {}", *ground_, outside) : outside;
}

}  // namespace taut
