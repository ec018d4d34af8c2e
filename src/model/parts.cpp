#include "model/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

namespace taut {
namespace {

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return count == 0 ? "" : fmt::format("{} {}", count, count == 1 ? one : many);
}

std::size_t count_links(const Model& model, bool (*holds)(const Links&, std::size_t)) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < model.links.size(); ++i) count += holds(model.links, i) ? 1 : 0;
  return count;
}

double largest_free_mass(const Model& model) {
  double largest = 0.0;
  for (std::size_t i = 0; i < model.masses.size(); ++i)
    if (!model.masses.pinned(i)) largest = std::max(largest, model.masses.mass[i]);
  return largest;
}

std::string masses_extent(const Model& model) {
  return equal_masses(model) ? "" : "masses differ";
}

void remove_unequal_masses(Model& model) {
  const double mass = largest_free_mass(model);
  for (std::size_t i = 0; i < model.masses.size(); ++i) {
    if (model.masses.pinned(i)) continue;
    model.masses.mass[i] = mass;
    model.masses.inverse_mass[i] = 1.0 / mass;
  }
}

std::string drag_extent(const Model& model) {
  return model.drag == 0.0 ? "" : fmt::format("{:.4g}/s", model.drag);
}

std::string compliance_extent(const Model& model) {
  return counted(count_links(model, [](const Links& links, std::size_t i) { return !links.rigid(i); }),
                 "link with stiffness", "links with stiffness");
}

void remove_damping(Model& model) {
  std::fill(model.links.damping.begin(), model.links.damping.end(), 0.0);
}

void remove_compliance(Model& model) {
  remove_damping(model);
  std::fill(model.links.stiffness.begin(), model.links.stiffness.end(), infinity);
  for (Limit& limit : model.limits)
    if (limit.kind == LimitKind::reach) limit.compliance = 0.0;
}

std::string damping_extent(const Model& model) {
  return counted(count_links(model, [](const Links& links, std::size_t i) { return links.damping[i] > 0.0; }),
                 "damped link", "damped links");
}

std::string breaking_extent(const Model& model) {
  return counted(model.breakable_links.size(), "link that can break", "links that can break");
}

void remove_breaking(Model& model) {
  model.breakable_links.clear();
  std::fill(model.links.break_stretch.begin(), model.links.break_stretch.end(), infinity);
  std::fill(model.links.break_tension.begin(), model.links.break_tension.end(), infinity);
}

std::string pins_extent(const Model& model) {
  return counted(model.driven_pins.size(), "pin", "pins");
}

std::string loads_extent(const Model& model) {
  std::size_t masses = 0;
  for (const Load& load : model.loads) masses += load.masses.size();
  return counted(masses, "mass", "masses");
}

std::string ground_extent(const Model& model) {
  const auto planes = std::ranges::count_if(model.colliders, as_ground);
  if (planes == 0) return "";
  if (planes > 1) return fmt::format("{} planes", planes);
  return fmt::format("a plane, friction {:.4g}", std::ranges::find_if(model.colliders, as_ground)->friction);
}

// Where there is nothing left to touch, nothing touches.
void forget_idle_contacts(Model& model) {
  const bool bodies =
      std::ranges::any_of(model.contacts, [](const ContactPoint& point) { return point.body != no_body; });
  if (model.colliders.empty() && !bodies) model.contacts.clear();
}

void remove_ground(Model& model) {
  std::erase_if(model.colliders, as_ground);
  forget_idle_contacts(model);
}

std::string solids_extent(const Model& model) {
  return touches_only_ground(model)
             ? ""
             : counted(model.contacts.size(), "point that touches", "points that touch");
}

void remove_solids(Model& model) {
  std::erase_if(model.colliders, [](const Collider& collider) { return as_ground(collider) == nullptr; });
  std::erase_if(model.contacts, [](const ContactPoint& point) { return !is_plain(point); });
  forget_idle_contacts(model);
}

bool on_angle(const Limit& limit) {
  return limit.kind != LimitKind::reach;
}

std::string limits_extent(const Model& model) {
  return counted(static_cast<std::size_t>(std::ranges::count_if(model.limits, on_angle)), "angle", "angles");
}

std::string one_sided_extent(const Model& model) {
  const auto count = std::ranges::count_if(model.limits, std::not_fn(on_angle));
  return counted(static_cast<std::size_t>(count), "link", "links");
}

// Links that pull and push about their length, as others do.
void remove_one_sided(Model& model) {
  std::erase_if(model.limits, std::not_fn(on_angle));
  model.links.free_range.clear();
}

std::string joints_extent(const Model& model) {
  return counted(model.joints.size(), "joint that resists", "joints that resist");
}

std::string faces_extent(const Model& model) {
  std::size_t triangles = 0;
  for (const SheetFaces& faces : model.faces) triangles += model.sheets[faces.sheet].triangle_count;
  return counted(triangles, "triangle that touches", "triangles that touch");
}

void remove_faces(Model& model) {
  model.faces.clear();
  for (ContactPoint& point : model.contacts) point.of_faces = false;
}

std::string wind_extent(const Model& model) {
  if (!model.wind) return "";
  const double speed = model.wind->velocity.norm();
  return speed == 0.0 ? "still air" : fmt::format("{:.4g} m/s", speed);
}

std::string bending_extent(const Model& model) {
  return counted(model.bends.size(), "place", "places");
}

std::string changes_extent(const Model& model) {
  return counted(model.changes.size(), "moment", "moments");
}

void remove_changes(Model& model) {
  model.changes.clear();
  model.masses.release_at.clear();
}

constexpr std::array parts{
    Part{"unequal masses", masses_extent, remove_unequal_masses},
    Part{"compliance", compliance_extent, remove_compliance},
    Part{"damping", damping_extent, remove_damping},
    Part{"breaking", breaking_extent, remove_breaking},
    Part{"drag", drag_extent, [](Model& model) { model.drag = 0.0; }},
    Part{"loads", loads_extent, [](Model& model) { model.loads.clear(); }},
    Part{"driven pins", pins_extent, [](Model& model) { model.driven_pins.clear(); }},
    Part{"ground", ground_extent, remove_ground},
    Part{"solids", solids_extent, remove_solids},
    Part{"faces", faces_extent, remove_faces},
    Part{"limits", limits_extent, [](Model& model) { std::erase_if(model.limits, on_angle); }},
    Part{"one-sided links", one_sided_extent, remove_one_sided},
    Part{"joints", joints_extent, [](Model& model) { model.joints.clear(); }},
    Part{"bending", bending_extent, [](Model& model) { model.bends.clear(); }},
    Part{"breaks and releases at a time", changes_extent, remove_changes},
    Part{"wind", wind_extent, [](Model& model) { model.wind.reset(); }},
};

// Whether a motion has no part along z.
bool stays_flat(const Motion& motion) {
  if (const auto* path = std::get_if<Path>(&motion))
    return std::all_of(path->knots.begin(), path->knots.end(), [&](const Knot& knot) {
      return knot.position.z() == path->knots.front().position.z();
    });
  if (const auto* sinusoid = std::get_if<Sinusoid>(&motion)) return sinusoid->amplitude.z() == 0.0;
  return false;  // carried
}

}  // namespace

std::span<const Part> model_parts() {
  return parts;
}

double share_of_net(double links, double masses) {
  const double rings = links - masses;
  return rings <= 0.0 ? 0.0 : std::min(1.0, 2.0 * rings / links);
}

bool has_rigid_links(const Model& model) {
  return std::ranges::any_of(model.links.stiffness, [](double k) { return k == infinity; });
}

bool equal_masses(const Model& model) {
  const double mass = largest_free_mass(model);
  for (std::size_t i = 0; i < model.masses.size(); ++i)
    if (!model.masses.pinned(i) && model.masses.mass[i] != mass) return false;
  return true;
}

bool stays_in_plane(const Model& model, const State& start) {
  const auto& z = start.position.z;
  const auto zero = [](double value) { return value == 0.0; };
  const bool at_rest_in_it =
      std::all_of(z.begin(), z.end(), [&](double value) { return value == z.front(); }) &&
      std::all_of(start.velocity.z.begin(), start.velocity.z.end(), zero);
  const bool pulled_along_it = zero(model.gravity.z()) &&
                               std::all_of(model.colliders.begin(), model.colliders.end(),
                                           [&](const Collider& collider) {
                                             const HalfSpace* ground = as_ground(collider);
                                             return ground && zero(ground->normal.z());
                                           }) &&
                               std::all_of(model.loads.begin(), model.loads.end(),
                                           [&](const Load& load) { return zero(load.force.z()); }) &&
                               std::all_of(model.driven_pins.begin(), model.driven_pins.end(),
                                           [](const DrivenPin& pin) { return stays_flat(pin.motion); });
  // A limb that is straight may be pushed any way across it, and what touches may be round.
  const bool nothing_round =
      !limits_angles(model) && touches_only_ground(model) && model.faces.empty() && !model.wind;
  return at_rest_in_it && pulled_along_it && nothing_round;
}

}  // namespace taut
