#include "model/model.h"

#include <algorithm>

#include "model/state.h"

namespace taut {

double total_link_length(const Model& model) {
  double sum = 0.0;
  for (const double length : model.links.length) sum += length;
  return sum;
}

double free_mass(const Model& model) {
  double sum = 0.0;
  for (std::size_t i = 0; i < model.masses.size(); ++i)
    if (!model.masses.pinned(i)) sum += model.masses.mass[i];
  return sum;
}

std::vector<bool> in_ragdoll(const Model& model) {
  std::vector<bool> inside(model.masses.size(), false);
  for (const Ragdoll& ragdoll : model.ragdolls)
    std::fill_n(inside.begin() + ragdoll.first_mass, ragdoll.mass_count, true);
  return inside;
}

bool is_plain(const ContactPoint& point) {
  return point.weights[0] == 1.0 && point.body == no_body && !point.static_friction;
}

const HalfSpace* as_ground(const Collider& collider) {
  return collider.restitution == 0.0 && !collider.motion ? std::get_if<HalfSpace>(&collider.shape) : nullptr;
}

bool touches_only_ground(const Model& model) {
  return std::ranges::all_of(model.colliders, as_ground) && std::ranges::all_of(model.contacts, is_plain);
}

std::string link_name(const Model& model, std::size_t link) {
  return model.masses.name[model.links.a[link]] + " – " + model.masses.name[model.links.b[link]];
}

std::vector<Index> links_with_a_free_end(const Model& model) {
  std::vector<Index> links;
  for (std::size_t i = 0; i < model.links.size(); ++i)
    if (!model.masses.pinned(model.links.a[i]) || !model.masses.pinned(model.links.b[i]))
      links.push_back(static_cast<Index>(i));
  return links;
}

std::vector<Index> solvable_links(const Model& model) {
  std::vector<Index> links = links_with_a_free_end(model);
  if (!model.links.free_range.empty())
    std::erase_if(links, [&](Index link) { return model.links.one_sided(link); });
  return links;
}

bool has_one_sided_links(const Model& model) {
  return std::ranges::any_of(model.limits, [](const Limit& limit) { return limit.kind == LimitKind::reach; });
}

bool limits_angles(const Model& model) {
  return std::ranges::any_of(model.limits, [](const Limit& limit) { return limit.kind != LimitKind::reach; });
}

bool let_go(const Limit& limit, const State& state) {
  return limit.link != no_link && state.broken(limit.link);
}

}  // namespace taut
