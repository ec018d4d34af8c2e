#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/lattice.h"
#include "geometry/supports.h"
#include "geometry/view_matrices.h"
#include "render/appearance.h"
#include "render/support_reach.h"

namespace taut {
namespace {

double drawn_pin_radius(const Model& model, const Look& look, const Radii& radii) {
  double largest = look.links ? radii.link : 0.0;
  if (!look.masses) return largest;
  for (std::size_t i = 0; i < model.masses.size(); ++i)
    if (model.masses.pinned(i))
      largest = std::max(largest, model.masses.radius[i] > 0.0 ? model.masses.radius[i] : radii.mass);
  return largest;
}

Colour colour_of(Material material, Theme theme) {
  if (theme == Theme::dark)
    return material == Material::wood ? Colour{0.52, 0.44, 0.36} : Colour{0.56, 0.58, 0.61};
  return material == Material::wood ? Colour{0.52, 0.43, 0.34} : Colour{0.46, 0.48, 0.51};
}

void add_part(Bodies& bodies, const SupportPart& part, const PictureSpace& space, const Vec3& origin,
              Theme theme) {
  TaperedRod rod =
      tapered_rod(origin + space.direction(part.start), part.start_radius, origin + space.direction(part.end),
                  part.end_radius, colour_of(part.material, theme));
  rod.squeeze = to_glm(space.direction(part.squeeze));
  bodies.rods.push_back(rod);
}

std::vector<Vec3> corners_of(const Box& box) {
  std::vector<Vec3> corners;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0})
        corners.emplace_back(box.centre + box.axes * Vec3(x, y, z).cwiseProduct(box.half_size));
  return corners;
}

}  // namespace

SceneSupports::SceneSupports(const Model& model, const State& start, const Look& look, const Radii& radii,
                             const Appearance& appearance)
    : model_(&model),
      start_(start.position),
      look_(look),
      pin_radius_(drawn_pin_radius(model, look, radii)),
      seen_(appearance.there) {}

const Supports& SceneSupports::seen_with(const Vec3& up) {
  if (up != up_) {
    const std::vector<Ground> grounds = drawn_grounds(*model_, look_, up);
    supports_ = supports(*model_, start_, {up, grounds, pin_radius_, &seen_});
    up_ = up;
  }
  return supports_;
}

void add_supports(Bodies& bodies, const Supports& supports, const PictureSpace& space, const State& seen,
                  Theme theme) {
  for (const SupportPart& part : supports.fixed) {
    // Seen from its start, which is near: far from the world's origin differences keep their digits.
    SupportPart from_start = part;
    from_start.start = Vec3::Zero();
    from_start.end = part.end - part.start;
    add_part(bodies, from_start, space, space.place(part.start), theme);
  }
  for (const Box& beam : supports.beams)
    add_shape(bodies, space.seen(Shape(beam)), colour_of(Material::wood, theme));
  for (const CarriedPart& carried : supports.carried)
    add_part(bodies, carried.part, space, seen.position.at(carried.mass), theme);
}

SupportReach reach_of_supports(const Model& model, const State& start, const Look& look, const Vec3& up) {
  if (!look.supports) return {};
  SceneSupports scene(model, start, look, radii(model, look), appearance(model, look));
  const Supports& all = scene.seen_with(up);
  double lowest = std::numeric_limits<double>::infinity();  // of pins
  for (std::size_t i = 0; i < model.masses.size(); ++i)
    if (model.masses.pinned(i)) lowest = std::min(lowest, up.dot(start.position.at(i)));
  SupportReach reach;
  const auto add = [&](const Vec3& place, double radius) {
    if (up.dot(place) + radius >= lowest) reach.fixed.push_back({place, radius});
  };
  for (const SupportPart& part : all.fixed) {
    add(part.start, part.start_radius);
    add(part.end, part.end_radius);
  }
  for (const Box& beam : all.beams)
    for (const Vec3& corner : corners_of(beam)) add(corner, 0.0);
  for (const auto& [mass, part] : all.carried) {
    reach.carried.push_back({mass, {part.start, part.start_radius}});
    reach.carried.push_back({mass, {part.end, part.end_radius}});
  }
  return reach;
}

}  // namespace taut
