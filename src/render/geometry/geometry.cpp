#include "geometry/geometry.h"

#include <algorithm>
#include <optional>

#include "geometry/contact_shade.h"
#include "geometry/figures.h"
#include "geometry/frame_block.h"
#include "geometry/loose_threads.h"
#include "geometry/picture_space.h"
#include "geometry/supports.h"
#include "geometry/turning_marks.h"
#include "geometry/view_matrices.h"
#include "model/measures.h"
#include "model/solid_mesh.h"

namespace taut {
namespace {

// Every fourth grid line is a strong one; see shaders/ground.frag.
constexpr double lines_a_period = 4.0;

DrawnBox bounds_of(const Geometry& geometry) {
  DrawnBox bounds{glm::vec3(1e30F), glm::vec3(-1e30F)};
  for_each_ball(geometry, [&](const glm::vec3& centre, float radius) {
    bounds.low = glm::min(bounds.low, centre - radius);
    bounds.high = glm::max(bounds.high, centre + radius);
  });
  return geometry.empty() ? DrawnBox{} : bounds;
}

// What is left of an appearance without the masses and links of what is drawn as cloth.
Appearance beside_cloth(const Model& model, const Appearance& all) {
  Appearance rest = all;
  for (std::size_t mass = 0; mass < rest.masses.size(); ++mass)
    if (all.shading[mass]) rest.masses[mass] = false;
  for (std::size_t link = 0; link < rest.links.size(); ++link)
    if (all.shading[model.links.a[link]] && all.shading[model.links.b[link]]) rest.links[link] = false;
  return rest;
}

// What one appearance draws and another does not.
Appearance without(const Appearance& all, const Appearance& others) {
  Appearance rest = all;
  for (std::size_t mass = 0; mass < rest.masses.size(); ++mass)
    if (others.masses[mass]) rest.masses[mass] = false;
  for (std::size_t link = 0; link < rest.links.size(); ++link)
    if (others.links[link]) rest.links[link] = false;
  return rest;
}

// Adds spheres and rods; those of `beside`, where it has any, come first and throw shadows beside cloth.
void add_lattice(Geometry& geometry, const Drawn& drawn, const Appearance& beside) {
  if (beside.masses.empty()) {
    geometry.spheres = sphere_records(drawn);
    geometry.links = link_records(drawn);
    return;
  }
  const Appearance rest = without(drawn.appearance, beside);
  const auto of = [&](const Appearance& part) {
    return Drawn{drawn.model, drawn.state, drawn.look, part, drawn.radii, drawn.quantity, drawn.scale};
  };
  geometry.spheres = sphere_records(of(beside));
  geometry.links = link_records(of(beside));
  geometry.sphere_shadows = geometry.spheres.size();
  geometry.link_shadows = geometry.links.size();
  geometry.line_shadows = true;
  for (const SphereRecord& sphere : sphere_records(of(rest))) geometry.spheres.push_back(sphere);
  for (const RodRecord& link : link_records(of(rest))) geometry.links.push_back(link);
}

// Of each collider what is drawn as a mesh; nothing of others.
std::vector<std::shared_ptr<const SolidSurface>> solid_surfaces(const Model& model,
                                                                const Appearance& appearance) {
  std::vector<std::shared_ptr<const SolidSurface>> surfaces(model.colliders.size());
  for (std::size_t i = 0; i < model.colliders.size(); ++i)
    if (const auto* solid = std::get_if<MeshSolid>(&model.colliders[i].shape);
        solid != nullptr && appearance.solids[i])
      surfaces[i] = std::make_shared<const SolidSurface>(solid_surface(*solid->mesh));
  return surfaces;
}

Colour solid_colour(const Look& look, const Appearance& appearance, std::size_t solid) {
  if (appearance.solid_colours.empty()) return look.collider_colour;
  return appearance.solid_colours[solid].value_or(look.collider_colour);
}

}  // namespace

struct GeometryMaker::Parts {
  const Model& model;
  Look look;
  Radii radii;
  Appearance appearance;
  Appearance beside_cloth;     // the same without what is drawn as cloth; empty where that is all or nothing
  Vec3 anchor;                 // m
  double size;                 // m, of the scene
  std::optional<State> exact;  // drawn as a ghost
  std::vector<BodyParts> bodies;
  std::vector<std::shared_ptr<const SolidSurface>> solids;  // of colliders out of meshes that are drawn
  std::optional<State> start;                               // only where orientations are drawn
  std::optional<SceneSupports> supports;                    // only where they are drawn
  std::optional<Cloth> cloth;                               // only where a surface is drawn
  std::shared_ptr<const SurfaceTopology> topology;          // of the last surface
};

GeometryMaker::GeometryMaker(const Model& model, const State& start, const Look& look,
                             const std::optional<Sight>& sight, const std::optional<State>& exact)
    : parts_(new Parts{model,
                       look,
                       radii(model, look),
                       appearance(model, look),
                       {},
                       Vec3::Zero(),
                       scene_size(model, start),
                       exact,
                       body_parts(model),
                       {},
                       {},
                       {},
                       {},
                       {}}) {
  parts_->solids = solid_surfaces(model, parts_->appearance);
  if (start.position.size() > 0) parts_->anchor = start.position.at(0);
  if (look.mass_shape == MassShape::box) parts_->start = start;
  if (look.supports) parts_->supports.emplace(model, start, look, parts_->radii, parts_->appearance);
  if (std::ranges::find(parts_->appearance.sheets, true) != parts_->appearance.sheets.end()) {
    const float pixels_a_metre =
        sight ? 1.0F / (reach_of(sight->pose) * pixel_height(sight->pose, sight->size)) : 0.0F;
    parts_->cloth = cloth_of(model, start, look, pixels_a_metre);
    if (parts_->appearance.own_parts) parts_->beside_cloth = beside_cloth(model, parts_->appearance);
  }
}

GeometryMaker::~GeometryMaker() = default;

std::shared_ptr<const Geometry> GeometryMaker::make(const State& state, const CameraPose& pose,
                                                    const Trails* trails) {
  const auto& [model, look, radii, appearance, beside, anchor, size, exact, bodies, solids, start, supports,
               cloth, topology] = *parts_;
  const PictureSpace space(pose);
  const State seen = space.seen(state);
  const Quantity values = quantity(model, state, look.colour_by);

  const auto geometry = std::make_shared<Geometry>();
  geometry->pose = pose;
  if (look.colour_by != ColourBy::plain) geometry->scale = colour_scale(look, model, state);
  geometry->legend = appearance.scale;
  const Drawn drawn{model, seen, look, appearance, radii, values, geometry->scale};
  add_lattice(*geometry, drawn, beside);
  add_linked(geometry->lines, geometry->spheres, drawn);
  add_loads(geometry->lines, drawn, space, size);
  if (trails != nullptr) add_trails(geometry->lines, drawn, space, *trails);
  if (exact) add_ghost(geometry->lines, drawn, space.seen(*exact));
  for (std::size_t i = 0; i < model.colliders.size(); ++i) {
    if (!appearance.solids[i]) continue;
    const Collider& collider = model.colliders[i];
    const Colour colour = solid_colour(look, appearance, i);
    const Shape shape = space.seen(shape_at(collider, state.time));
    if (solids[i]) add_mesh(geometry->bodies, std::get<MeshSolid>(shape), solids[i], colour);
    add_shape(geometry->bodies, shape, colour);
    add_turning_marks(geometry->bodies, collider, state.time, space, colour);
  }
  add_figures(geometry->bodies, bodies, drawn);
  if (start) add_mass_boxes(geometry->bodies, space.seen(*start), drawn);
  if (supports) add_supports(geometry->bodies, parts_->supports->seen_with(pose.up), space, seen, look.theme);
  for (const Ground& ground : drawn_grounds(model, look, pose.up, state.time)) {
    const GroundPatch patch = ground_patch(ground, space, lines_a_period * grid_spacing(pose));
    // From below there is no ground in the way of the scene.
    if (patch.height > 0.0F) geometry->grounds.push_back(patch);
  }
  if (shows_contact(look)) add_contact_shades(geometry->bodies, geometry->grounds, shade_reach(pose));
  if (cloth) {
    parts_->topology = surface_topology(*cloth, state, topology);
    geometry->surface = surface_mesh(*cloth, *topology, seen, space, values, geometry->scale,
                                     {geometry->bodies, geometry->grounds});
    const Vec3 down = space.direction(model.gravity.stableNormalized());
    const std::vector<RodRecord> threads =
        loose_threads(*cloth, *topology, geometry->surface, seen, to_glm(down), look);
    geometry->links.insert(geometry->links.end(), threads.begin(), threads.end());
  }
  geometry->bounds = bounds_of(*geometry);
  const Vec3 place = space.place(anchor);
  geometry->anchor = {place.x(), place.y(), place.z()};
  return geometry;
}

}  // namespace taut
