#include "geometry/geometry.h"

#include <optional>

#include "geometry/figures.h"
#include "geometry/frame_block.h"
#include "geometry/loose_threads.h"
#include "geometry/picture_space.h"
#include "geometry/supports.h"
#include "geometry/turning_marks.h"
#include "geometry/view_matrices.h"
#include "model/measures.h"

namespace taut {
namespace {

// Every fourth grid line is a strong one; see shaders/ground.frag.
constexpr double lines_a_period = 4.0;

Bounds bounds_of(const Geometry& geometry) {
  Bounds bounds{glm::vec3(1e30F), glm::vec3(-1e30F)};
  for_each_ball(geometry, [&](const glm::vec3& centre, float radius) {
    bounds.low = glm::min(bounds.low, centre - radius);
    bounds.high = glm::max(bounds.high, centre + radius);
  });
  return geometry.empty() ? Bounds{} : bounds;
}

}  // namespace

struct GeometryMaker::Parts {
  const Model& model;
  Look look;
  Radii radii;
  Vec3 anchor;                 // m
  double size;                 // m, of the scene
  std::optional<State> exact;  // drawn as a ghost
  std::vector<BodyParts> bodies;
  std::optional<State> start;                       // only where orientations are drawn
  std::optional<SceneSupports> supports;            // only where they are drawn
  std::optional<Cloth> cloth;                       // only where a surface is drawn
  std::shared_ptr<const SurfaceTopology> topology;  // of the last surface
};

GeometryMaker::GeometryMaker(const Model& model, const State& start, const Look& look,
                             const std::optional<Sight>& sight, const std::optional<State>& exact)
    : parts_(new Parts{model,
                       look,
                       radii(model, look),
                       Vec3::Zero(),
                       scene_size(model, start),
                       exact,
                       body_parts(model),
                       {},
                       {},
                       {},
                       {}}) {
  if (start.position.size() > 0) parts_->anchor = start.position.at(0);
  if (look.masses && look.mass_shape == MassShape::box) parts_->start = start;
  if (look.supports) parts_->supports.emplace(model, start, look, parts_->radii);
  if (look.surface && !model.triangles.empty()) {
    const float pixels_a_metre =
        sight ? 1.0F / (reach_of(sight->pose) * pixel_height(sight->pose, sight->size)) : 0.0F;
    parts_->cloth = cloth_of(model, start, look, pixels_a_metre);
  }
}

GeometryMaker::~GeometryMaker() = default;

std::shared_ptr<const Geometry> GeometryMaker::make(const State& state, const CameraPose& pose,
                                                    const Trails* trails) {
  const auto& [model, look, radii, anchor, size, exact, bodies, start, supports, cloth, topology] = *parts_;
  const PictureSpace space(pose);
  const State seen = space.seen(state);
  const Quantity values = quantity(model, state, look.colour_by);

  const auto geometry = std::make_shared<Geometry>();
  geometry->pose = pose;
  if (look.colour_by != ColourBy::plain) geometry->scale = colour_scale(look, model, state);
  geometry->spheres = sphere_records(model, seen, look, radii, values, geometry->scale);
  geometry->links = link_records(model, seen, look, radii, values, geometry->scale);
  const Seen in_lines{model, seen, look, radii, values, geometry->scale};
  add_linked(geometry->lines, geometry->spheres, in_lines);
  add_loads(geometry->lines, in_lines, space, size);
  if (trails != nullptr) add_trails(geometry->lines, in_lines, space, *trails);
  if (exact) add_ghost(geometry->lines, in_lines, space.seen(*exact));
  if (cloth) {
    parts_->topology = surface_topology(*cloth, state, topology);
    geometry->surface = surface_mesh(*cloth, *topology, seen, space, values, geometry->scale);
    const Vec3 down = space.direction(model.gravity.stableNormalized());
    const std::vector<RodRecord> threads =
        loose_threads(*cloth, *topology, geometry->surface, seen, to_glm(down), look);
    geometry->links.insert(geometry->links.end(), threads.begin(), threads.end());
  }
  if (look.colliders)
    for (const Collider& collider : model.colliders) {
      add_shape(geometry->bodies, space.seen(shape_at(collider, state.time)), look.collider_colour);
      add_turning_marks(geometry->bodies, collider, state.time, space, look.collider_colour);
    }
  if (look.bones) add_figures(geometry->bodies, bodies, seen, look, values, geometry->scale);
  if (start)
    add_mass_boxes(geometry->bodies, model, space.seen(*start), seen, look, radii, values, geometry->scale);
  if (supports) add_supports(geometry->bodies, parts_->supports->seen_with(pose.up), space, seen, look.theme);
  for (const Ground& ground : drawn_grounds(model, look, pose.up, state.time)) {
    const GroundPatch patch = ground_patch(ground, space, lines_a_period * grid_spacing(pose));
    // From below there is no ground in the way of the scene.
    if (patch.height > 0.0F) geometry->grounds.push_back(patch);
  }
  geometry->bounds = bounds_of(*geometry);
  const Vec3 place = space.place(anchor);
  geometry->anchor = {place.x(), place.y(), place.z()};
  return geometry;
}

}  // namespace taut
