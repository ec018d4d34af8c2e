#include "frames/settled_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include "look_ahead.h"
#include "model/measures.h"
#include "render/appearance.h"
#include "render/camera.h"
#include "render/camera_fit.h"
#include "render/ground.h"
#include "render/support_reach.h"

namespace taut {
namespace {

// More of the picture is left free around what a look ahead found than around a given box: it is coarse.
constexpr double margin_of_look_ahead = 0.10;
// How far below the lowest mass a ground goes that would hide it, as a share of what there is to show.
constexpr double ground_clearance = 0.04;
constexpr double widest = 16.0 / 9.0;

// A ball that there is to show, and when (s).
using Visit = std::function<void(const Vec3& place, double radius, double time)>;

struct Box {
  Vec3 low = Vec3::Constant(1e301), high = Vec3::Constant(-1e301);  // m

  void add(const Vec3& place, double radius) {
    low = low.cwiseMin(place - Vec3::Constant(radius));
    high = high.cwiseMax(place + Vec3::Constant(radius));
  }
  Vec3 middle() const { return 0.5 * (low + high); }
  double diagonal() const { return (high - low).norm(); }
};

// As far as masses reach around their centres when drawn.
std::vector<double> drawn_radii(const Model& model, const Look& look) {
  std::vector<double> radii = model.masses.radius;
  if (look.bones)
    for (const Bone& bone : model.bones)
      for (const Index mass : {bone.from[0], bone.from[1], bone.to[0], bone.to[1]})
        radii[mass] = std::max(radii[mass], bone.radius);
  for (double& radius : radii) radius = std::max(radius, look.mass_radius);
  return radii;
}

// What stands still: an orbiting camera sees it from all sides.
void visit_standing(const Camera& camera, const Vec3& place, double radius, const Visit& visit) {
  const int times = camera.orbit == 0.0 ? 1 : 48;
  for (int turn = 0; turn < times; ++turn)
    visit(place, radius, turn == 0 ? 0.0 : 360.0 / camera.orbit * turn / times);
}

void visit_corners(const Camera& camera, const Visit& visit) {
  const auto& [low, high] = *camera.show;
  for (int corner = 0; corner < 8; ++corner)
    visit_standing(camera,
                   {(corner & 1) != 0 ? high.x() : low.x(), (corner & 2) != 0 ? high.y() : low.y(),
                    (corner & 4) != 0 ? high.z() : low.z()},
                   0.0, visit);
}

void visit_motion(const Scene& scene, const StopTest& stop, const Visit& visit) {
  const std::vector<double> radii = drawn_radii(scene.model, scene.look);
  const std::vector<bool> seen = masses_in_view(scene.model, scene.look);
  const SupportReach supports =
      reach_of_supports(scene.model, scene.start, scene.look, up_direction(scene.camera, scene.model));
  if (scene.camera.follow.empty())  // else they are left behind
    for (const auto& [place, radius] : supports.fixed) visit_standing(scene.camera, place, radius, visit);
  look_ahead(scene, stop, [&](const State& state) {
    const Vec3 shift = displacement(scene.camera.follow, scene.model, scene.start, state);
    for (std::size_t i = 0; i < radii.size(); ++i)
      if (seen[i]) visit(state.position.at(i) - shift, radii[i], state.time);
    for (const auto& [mass, reach] : supports.carried)
      visit(state.position.at(mass) - shift + reach.place, reach.radius, state.time);
  });
}

bool has_open_ground(const Scene& scene) {
  const std::vector<Ground> grounds =
      drawn_grounds(scene.model, scene.look, up_direction(scene.camera, scene.model));
  return grounds.size() == 1 && !grounds.front().solid && !scene.look.ground_height;
}

void add_start(const Scene& scene, Box& box) {
  const std::vector<bool> seen = masses_in_view(scene.model, scene.look);
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (seen[i]) box.add(scene.start.position.at(i), 0.0);
}

// What was learnt about what there is to show.
struct Shown {
  CameraFit fit;
  Box box;
  double lowest = 1e301;  // upwards (m)
};

Shown shown(const Scene& scene, double aspect, const StopTest& stop) {
  const Camera& camera = scene.camera;
  const Vec3 up = up_direction(camera, scene.model);
  std::optional<Vec3> centre = camera.target;
  if (!centre && camera.orbit != 0.0) {
    Box box;
    const auto add = [&](const Vec3& place, double radius, double) { box.add(place, radius); };
    if (camera.show)
      visit_corners(camera, add);
    else
      add_start(scene, box);
    centre = box.middle();
  }
  Shown result{CameraFit(sight_axes(camera.direction, up), camera.field_of_view, aspect,
                         camera.show ? usual_margin : margin_of_look_ahead, centre),
               {}};
  const Vec3 middle = centre.value_or(Vec3::Zero());
  const Visit add = [&](const Vec3& place, double radius, double time) {
    if (!place.allFinite()) return;
    // Turned back, so that the eye stands still.
    const Vec3 seen =
        camera.orbit == 0.0 ? place : middle + orbit_turn(camera, up, -time) * Vec3(place - middle);
    result.fit.add(seen, radius);
    result.box.add(place, radius);
    result.lowest = std::min(result.lowest, up.dot(place) - radius);
  };
  if (camera.show)
    visit_corners(camera, add);
  else
    visit_motion(scene, stop, add);
  return result;
}

// From the lower to the upper edge, for a picture that sees as far to the sides as one of 16:9 (degrees).
double widened(double field_of_view, double aspect) {
  if (aspect >= widest) return field_of_view;
  const double slope = std::tan(0.5 * field_of_view * std::numbers::pi / 180.0);
  return 2.0 * std::atan(slope * widest / aspect) * 180.0 / std::numbers::pi;
}

void settle_camera(Camera& camera, const Shown& what, const Model& model, const State& start, double aspect) {
  if (camera.eye) {
    if (!camera.target) camera.target = what.box.middle();
    camera.field_of_view = widened(camera.field_of_view, aspect);
    return;
  }
  const CameraFit::Place place = what.fit.place(0.3 * scene_size(model, start));
  camera.eye = place.eye;
  if (!camera.target) camera.target = place.target;
}

void settle_ground(Look& look, const Shown& what) {
  const double clearance = ground_clearance * what.box.diagonal();
  if (what.lowest < -1e-9 * what.box.diagonal()) look.ground_height = what.lowest - clearance;
}

}  // namespace

void settle_views(std::span<Scene> scenes, Size size, const StopTest& stop) {
  Scene& first = scenes.front();
  const double aspect = static_cast<double>(size.width) / size.height;
  const bool open_ground = has_open_ground(first);
  if (first.camera.eye && first.camera.target && !open_ground) {
    first.camera.field_of_view = widened(first.camera.field_of_view, aspect);
  } else {
    const Shown what = shown(first, aspect, stop);
    settle_camera(first.camera, what, first.model, first.start, aspect);
    if (open_ground) settle_ground(first.look, what);
  }
  for (Scene& other : scenes.subspan(1)) {
    other.camera = first.camera;
    other.look.ground_height = first.look.ground_height;
  }
}

}  // namespace taut
