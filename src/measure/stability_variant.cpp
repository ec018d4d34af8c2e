#include "measure/stability_variant.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/failure.h"
#include "base/nearest.h"

namespace taut {
namespace {

constexpr double weightless_stiffness = 1e4;  // N/m, where there is no weight to stretch a spring
constexpr double stretch_by_weight = 0.01;    // of a spring's length

void set_stiffness(Description& description, double stiffness, bool of_rigid_links_only) {
  const auto set = [&](LinkProperties& properties) {
    if (!of_rigid_links_only || !properties.stiffness) properties.stiffness = stiffness;
  };
  for (ChainSpec& chain : description.chains) set(chain.properties);
  for (TieSpec& tie : description.ties) set(tie.properties);
  for (LinkSpec& link : description.links) set(link.properties);
  for (SheetSpec& sheet : description.sheets) {
    set(sheet.properties);
    if (sheet.diagonals) set(*sheet.diagonals);
    if (sheet.skip_one) set(*sheet.skip_one);
  }
  for (MeshSpec& mesh : description.meshes) {
    set(mesh.properties);
    if (mesh.diagonals) set(*mesh.diagonals);
    if (mesh.skip_one) set(*mesh.skip_one);
  }
  for (PointsSpec& points : description.points) set(points.properties);
}

void set_links(Description& description, int links) {
  if (description.chains.size() != 1 || !description.sheets.empty() || !description.meshes.empty() ||
      !description.points.empty() || !description.links.empty() || !description.chains[0].straight())
    throw BadRequest(
        "a map over the number of links needs a scene that is one straight [[chain]] and has no other links");
  ChainSpec& chain = description.chains[0];
  const double factor = static_cast<double>(links) / chain.links;
  chain.mass *= (links + 1.0) / (chain.links + 1.0);
  chain.length *= factor;
  chain.to = chain.from + factor * (chain.to - chain.from);
  chain.links = links;
}

void set_gravity(Description& description, double size) {
  const double now = description.gravity.norm();
  description.gravity = now > 0.0 ? Vec3(description.gravity * (size / now)) : Vec3(0.0, -size, 0.0);
}

Built build_or_throw(const Description& description) {
  Built built = build(description);
  if (!built.problems.empty())
    throw BadRequest(fmt::format("a variant of the scene can't be built: {}", built.problems[0].message));
  return built;
}

std::vector<std::size_t> free_masses(const Model& model) {
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < model.masses.size(); ++i)
    if (!model.masses.pinned(i)) free.push_back(i);
  return free;
}

// The last mass of the file that is free, against the mean of the others.
void set_mass_ratio(Model& model, double ratio) {
  const std::vector<std::size_t> free = free_masses(model);
  if (free.size() < 2) throw BadRequest("a map over the mass ratio needs a scene with two free masses");
  double others = 0.0;
  for (std::size_t i = 0; i + 1 < free.size(); ++i) others += model.masses.mass[free[i]];
  const double mass = ratio * others / static_cast<double>(free.size() - 1);
  model.masses.mass[free.back()] = mass;
  model.masses.inverse_mass[free.back()] = 1.0 / mass;
}

// Springs in place of rigid links, such that the whole weight stretches one of mean length by 1 %.
double spring_for_weight(const Model& model) {
  const double weight = free_mass(model) * model.gravity.norm();
  if (!(weight > 0.0) || model.links.size() == 0) return weightless_stiffness;
  const double mean_length = total_link_length(model) / static_cast<double>(model.links.size());
  return weight / (stretch_by_weight * mean_length);
}

Built built_with(const Description& description, MapColumns columns, double value) {
  Built built = build_or_throw(description);
  if (columns == MapColumns::mass_ratio) set_mass_ratio(built.model, value);
  return built;
}

}  // namespace

const std::array<MapAxes, 5>& all_map_axes() {
  static constexpr std::array<MapAxes, 5> axes{{
      {"step,mass-ratio", MapRows::step, MapColumns::mass_ratio, "last mass over the others", 1.0, 1e5,
       false},
      {"step,stiffness", MapRows::step, MapColumns::stiffness, "stiffness of a link (N/m)", 1e1, 1e7, false},
      {"step,links", MapRows::step, MapColumns::links, "links", 2.0, 100.0, true},
      {"passes,links", MapRows::passes, MapColumns::links, "links", 2.0, 40.0, true},
      {"step,gravity", MapRows::step, MapColumns::gravity, "gravity (m/s²)", 1e-1, 1e4, false},
  }};
  return axes;
}

const MapAxes& find_map_axes(std::string_view name) {
  std::vector<std::string_view> names;
  for (const MapAxes& axes : all_map_axes()) {
    if (axes.name == name) return axes;
    names.push_back(axes.name);
  }
  const std::string_view nearest = nearest_name(name, names);
  throw BadRequest(nearest.empty()
                       ? fmt::format("there are no axes \"{}\"; there are {}", name, fmt::join(names, " "))
                       : fmt::format("there are no axes \"{}\"; did you mean \"{}\"?", name, nearest));
}

std::vector<double> spread_values(double least, double most, int count, bool whole) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    const double share = count == 1 ? 0.0 : static_cast<double>(i) / (count - 1);
    const double value = least * std::pow(most / least, share);
    values.push_back(whole ? std::round(value) : value);
  }
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

Built map_variant(const Description& description, MapColumns columns, double value, const Method& method) {
  Description changed = description;
  if (columns == MapColumns::stiffness) set_stiffness(changed, value, false);
  if (columns == MapColumns::links) set_links(changed, static_cast<int>(value));
  if (columns == MapColumns::gravity) set_gravity(changed, value);
  Built built = built_with(changed, columns, value);
  if (method.can.rigid) return built;
  set_stiffness(changed, spring_for_weight(built.model), true);
  return built_with(changed, columns, value);
}

}  // namespace taut
