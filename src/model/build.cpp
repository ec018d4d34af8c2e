#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "base/nearest.h"
#include "builder.h"
#include "model/measures.h"

namespace taut {
namespace {

// Whether a dotted name fits a pattern of as many parts, where a part * fits any.
bool fits(std::string_view name, std::string_view pattern) {
  for (;;) {
    const std::size_t name_dot = name.find('.'), pattern_dot = pattern.find('.');
    const std::string_view name_part = name.substr(0, name_dot),
                           pattern_part = pattern.substr(0, pattern_dot);
    if (pattern_part != "*" && pattern_part != name_part) return false;
    if (name_dot == std::string_view::npos || pattern_dot == std::string_view::npos)
      return name_dot == pattern_dot;
    name.remove_prefix(name_dot + 1);
    pattern.remove_prefix(pattern_dot + 1);
  }
}

void add_masses(Builder& builder, const std::vector<MassSpec>& specs) {
  for (const MassSpec& spec : specs) {
    builder.begin_body(spec.collides);
    const Index mass =
        builder.add_mass(spec.name, spec.position, spec.velocity, spec.mass, spec.pinned, spec.radius);
    if (spec.pinned) builder.drive(mass, spec.motion);
  }
}

void add_links(Builder& builder, const std::vector<LinkSpec>& specs, const MassesByName& by_name,
               std::vector<Problem>& problems) {
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const LinkSpec& spec = specs[i];
    builder.begin_entry("link", i);
    const auto report = [&](std::string key, std::string message, std::string suggestion = "") {
      problems.push_back({"link", i, std::move(key), std::move(message), std::move(suggestion)});
    };
    const auto a = by_name.find(spec.a), b = by_name.find(spec.b);
    if (a == by_name.end())
      report("a", fmt::format("no mass is named \"{}\"", spec.a),
             nearest_mass(spec.a, builder.model.masses, problems));
    if (b == by_name.end())
      report("b", fmt::format("no mass is named \"{}\"", spec.b),
             nearest_mass(spec.b, builder.model.masses, problems));
    if (a == by_name.end() || b == by_name.end()) continue;
    if (a->second == b->second) {
      report("b", fmt::format("a link can't join \"{}\" to itself", spec.a));
      continue;
    }
    const double distance =
        (builder.start.position.at(a->second) - builder.start.position.at(b->second)).norm();
    if (distance == 0.0)
      report("b", fmt::format("\"{}\" and \"{}\" are at the same point, so their link has no direction",
                              spec.a, spec.b));
    else
      builder.add_link(a->second, b->second, spec.length.value_or(distance), spec.properties);
  }
}

void add_loads(Model& model, const std::vector<LoadSpec>& specs, std::vector<Problem>& problems) {
  for (std::size_t i = 0; i < specs.size(); ++i) {
    Load load{{}, specs[i].force, specs[i].from, specs[i].to};
    for (const std::string& pattern : specs[i].masses) {
      const std::size_t before = load.masses.size();
      for (std::size_t mass = 0; mass < model.masses.size(); ++mass)
        if (fits(model.masses.name[mass], pattern)) load.masses.push_back(static_cast<Index>(mass));
      if (load.masses.size() == before)
        problems.push_back({"load", i, "masses", fmt::format("no mass is named \"{}\"", pattern),
                            nearest_mass(pattern, model.masses, problems)});
    }
    // Patterns may overlap; the force acts once on each mass.
    std::sort(load.masses.begin(), load.masses.end());
    load.masses.erase(std::unique(load.masses.begin(), load.masses.end()), load.masses.end());
    model.loads.push_back(std::move(load));
  }
}

Wind wind_of(const WindSpec& spec, const Vec3& up) {
  return {
      spec.velocity,         spec.gust, spec.gust_time, static_cast<std::uint32_t>(spec.seed), spec.density,
      spec.drag_coefficient, up};
}

// Whether the masses can be built, so that names can be looked up: what is wrong elsewhere does not stand in
// the way.
bool masses_are_sound(const std::vector<Problem>& problems) {
  return std::none_of(problems.begin(), problems.end(), [](const Problem& problem) {
    return problem.section == "chain" || problem.section == "sheet" || problem.section == "mass" ||
           problem.section == "ragdoll";
  });
}

}  // namespace

std::string nearest_mass(std::string_view name, const Masses& masses, const std::vector<Problem>& problems) {
  constexpr std::size_t enough = 50;
  if (problems.size() >= enough) return {};
  const std::vector<std::string_view> names(masses.name.begin(), masses.name.end());
  return std::string(nearest_name(name, names));
}

Built build(const Description& description) {
  Built built;
  built.problems = find_problems(description);
  if (!masses_are_sound(built.problems)) return built;

  Builder builder;
  builder.model.gravity = description.gravity;
  builder.model.drag = description.drag;
  for (std::size_t i = 0; i < description.chains.size(); ++i) {
    builder.begin_entry("chain", i);
    add_chain(builder, description.chains[i]);
  }
  for (std::size_t i = 0; i < description.sheets.size(); ++i) {
    builder.begin_entry("sheet", i);
    add_sheet(builder, description.sheets[i]);
  }
  for (std::size_t i = 0; i < description.ragdolls.size(); ++i) {
    builder.begin_entry("ragdoll", i);
    add_ragdoll(builder, description.ragdolls[i], i, built.problems);
  }
  add_masses(builder, description.masses);
  add_solids(builder, description);
  MassesByName by_name;
  for (std::size_t i = 0; i < builder.model.masses.size(); ++i)
    by_name.emplace(builder.model.masses.name[i], static_cast<Index>(i));
  add_links(builder, description.links, by_name, built.problems);
  add_loads(builder.model, description.loads, built.problems);
  add_limits(builder, description, by_name, built.problems);
  if (description.wind && description.wind->density * description.wind->drag_coefficient > 0.0)
    builder.model.wind = wind_of(*description.wind, up_direction(builder.model));
  if (built.problems.empty()) built.notes = find_notes(description, builder);
  built.model = std::move(builder.model);
  built.start = std::move(builder.start);
  return built;
}

}  // namespace taut
