#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "base/nearest.h"
#include "builder.h"
#include "model/measures.h"
#include "name_patterns.h"

namespace taut {
namespace {

void add_masses(Builder& builder, const std::vector<MassSpec>& specs) {
  builder.model.singles.first_mass = static_cast<Index>(builder.model.masses.size());
  builder.model.singles.mass_count = static_cast<Index>(specs.size());
  for (const MassSpec& spec : specs) {
    builder.begin_body(spec.collides);
    const Index mass =
        builder.add_mass(spec.name, spec.position, spec.velocity, spec.mass, spec.pinned, spec.radius);
    if (spec.pinned) builder.drive(mass, spec.motion);
    builder.release_at(mass, spec.release);
  }
}

void add_links(Builder& builder, const std::vector<LinkSpec>& specs, const MassesByName& by_name,
               std::vector<Problem>& problems) {
  builder.model.singles.first_link = static_cast<Index>(builder.model.links.size());
  builder.model.singles.link_count = static_cast<Index>(specs.size());
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
    if (!(distance >= smallest_divisor))
      report("b", fmt::format("\"{}\" and \"{}\" are at the same point, so their link has no direction",
                              spec.a, spec.b));
    else
      builder.add_link(a->second, b->second, spec.length.value_or(distance), spec.properties);
  }
}

// Adds the masses that a load names; says of each pattern that fits none what may have been meant.
void add_loaded_masses(Load& load, const std::vector<std::string>& patterns, std::size_t index,
                       const Masses& masses, NamePatterns& names, std::vector<Problem>& problems) {
  std::unordered_set<std::string_view> known;  // a pattern twice adds nothing
  for (const std::string& pattern : patterns) {
    if (!known.insert(pattern).second) continue;
    const std::vector<Index>& fitting = names.fitting(pattern);
    load.masses.insert(load.masses.end(), fitting.begin(), fitting.end());
    if (fitting.empty())
      problems.push_back({"load", index, "masses", fmt::format("no mass is named \"{}\"", pattern),
                          nearest_mass(pattern, masses, problems)});
  }
  // Patterns may overlap; the force acts once on each mass.
  std::sort(load.masses.begin(), load.masses.end());
  load.masses.erase(std::unique(load.masses.begin(), load.masses.end()), load.masses.end());
}

void add_loads(Model& model, const std::vector<LoadSpec>& specs, std::vector<Problem>& problems) {
  constexpr std::size_t most = 100'000'000;  // masses that loads may name, all of them together
  NamePatterns names(model.masses);
  std::size_t loaded = 0;
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const double until = specs[i].until.value_or(infinity);
    Load load{{}, specs[i].force, specs[i].from, specs[i].to, until, specs[i].gone.value_or(until)};
    add_loaded_masses(load, specs[i].masses, i, model.masses, names, problems);
    loaded += load.masses.size();
    if (loaded > most) {
      problems.push_back(
          {"load", i, "masses",
           fmt::format("the loads up to here act on {} masses in all; {} is the most they may", loaded, most),
           ""});
      return;
    }
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
           problem.section == "mesh" || problem.section == "points" || problem.section == "ragdoll" ||
           problem.section == "plane" || problem.section == "sphere" || problem.section == "capsule" ||
           problem.section == "box" || problem.section == "solid";
  });
}

// Masses by their names, where anything is going to be looked up.
MassesByName names_in_use(const Description& description, const Masses& masses) {
  MassesByName by_name;
  if (description.links.empty() && description.angles.empty() && description.hinges.empty() &&
      description.cones.empty())
    return by_name;
  by_name.reserve(masses.size());
  for (std::size_t i = 0; i < masses.size(); ++i) by_name.emplace(masses.name[i], static_cast<Index>(i));
  return by_name;
}

}  // namespace

SectionEntry sheet_entry(const Description& description, std::size_t sheet) {
  const std::size_t sheets = description.sheets.size();
  return sheet < sheets ? SectionEntry{"sheet", sheet} : SectionEntry{"mesh", sheet - sheets};
}

std::string nearest_mass(std::string_view name, const Masses& masses, const std::vector<Problem>& problems) {
  constexpr std::size_t enough = 50, most_names = 2'000'000;  // names to compare with, all problems together
  if (problems.size() >= enough || problems.size() * masses.size() > most_names) return {};
  const std::vector<std::string_view> names(masses.name.begin(), masses.name.end());
  return std::string(nearest_name(name, names));
}

Built build(const Description& description) {
  Built built;
  built.problems = find_problems(description);
  if (!masses_are_sound(built.problems)) {
    build_names_alone(description, built);
    return built;
  }

  Builder builder;
  builder.model.gravity = description.gravity;
  builder.model.drag = description.drag;
  add_solids(builder, description);
  for (std::size_t i = 0; i < description.chains.size(); ++i) {
    builder.begin_entry("chain", i);
    add_chain(builder, description.chains[i], description);
  }
  for (std::size_t i = 0; i < description.sheets.size(); ++i) {
    builder.begin_entry("sheet", i);
    add_sheet(builder, description.sheets[i]);
  }
  for (std::size_t i = 0; i < description.meshes.size(); ++i) {
    builder.begin_entry("mesh", i);
    add_mesh(builder, description.meshes[i]);
  }
  for (std::size_t i = 0; i < description.points.size(); ++i) {
    builder.begin_entry("points", i);
    add_points(builder, description.points[i]);
  }
  for (std::size_t i = 0; i < description.ragdolls.size(); ++i) {
    builder.begin_entry("ragdoll", i);
    add_ragdoll(builder, description.ragdolls[i], i, built.problems);
  }
  add_masses(builder, description.masses);
  add_contact_points(builder);
  find_starts_inside(builder, description, built.problems);
  find_crowds(builder, description, built.problems);
  const MassesByName by_name = names_in_use(description, builder.model.masses);
  add_links(builder, description.links, by_name, built.problems);
  add_ties(builder, description.ties, built.problems);
  find_overreach(builder, built.problems);
  add_seams(builder, description, built.problems);
  add_loads(builder.model, description.loads, built.problems);
  add_limits(builder, description, by_name, built.problems);
  find_face_problems(builder, description, built.problems);
  if (description.wind && description.wind->density * description.wind->drag_coefficient > 0.0)
    builder.model.wind = wind_of(*description.wind, up_direction(builder.model));
  if (built.problems.empty()) built.notes = find_notes(description, builder);
  built.model = std::move(builder.model);
  built.start = std::move(builder.start);
  built.names_known = true;
  return built;
}

}  // namespace taut
