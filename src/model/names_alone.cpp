#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "builder.h"
#include "name_patterns.h"

namespace taut {
namespace {

bool decides_names(const Problem& problem) {
  static constexpr std::array<std::string_view, 6> naming{"chain",  "sheet",   "mesh",
                                                          "points", "ragdoll", "mass"};
  static constexpr std::array<std::string_view, 6> keys{"name", "links", "rows", "columns", "file", "masses"};
  return std::ranges::find(naming, problem.section) != naming.end() &&
         (problem.key.empty() || std::ranges::find(keys, problem.key) != keys.end());
}

// Entries that have nothing but their names and counts, apart from one another.
Description stand_ins(const Description& description) {
  Description sound;
  double place = 0.0;  // m
  const auto next = [&place] { return Vec3(place += 10.0, 0.0, 0.0); };
  for (const ChainSpec& spec : description.chains) {
    ChainSpec& chain = sound.chains.emplace_back();
    chain.name = spec.name;
    chain.links = spec.links;
    chain.from = next();
    chain.to = chain.from + Vec3::UnitY();
  }
  for (const SheetSpec& spec : description.sheets) {
    SheetSpec& sheet = sound.sheets.emplace_back();
    sheet.name = spec.name;
    sheet.rows = spec.rows;
    sheet.columns = spec.columns;
    sheet.from = next();
    sheet.to = sheet.from + Vec3::UnitX();
    sheet.down = -Vec3::UnitY();
  }
  for (const MeshSpec& spec : description.meshes) {
    MeshSpec& mesh = sound.meshes.emplace_back();
    mesh.name = spec.name;
    mesh.data = spec.data;
  }
  for (const PointsSpec& spec : description.points) {
    PointsSpec& points = sound.points.emplace_back();
    points.name = spec.name;
    points.data = spec.data;
  }
  for (const RagdollSpec& spec : description.ragdolls) {
    RagdollSpec& ragdoll = sound.ragdolls.emplace_back();
    ragdoll.name = spec.name;
    ragdoll.position = next();
  }
  for (const MassSpec& spec : description.masses) {
    MassSpec& mass = sound.masses.emplace_back();
    mass.name = spec.name;
    mass.position = next();
  }
  return sound;
}

// Reports the names of some entries that no mass has.
class NameSearch {
 public:
  NameSearch(const Masses& masses, std::vector<Problem>& problems)
      : masses_(masses), names_(masses), problems_(problems) {}

  void look(std::string_view section, std::size_t index, std::string_view key, const std::string& name) {
    if (!names_.fitting(name).empty()) return;
    problems_.push_back({std::string(section), index, std::string(key),
                         fmt::format("no mass is named \"{}\"", name),
                         nearest_mass(name, masses_, problems_)});
  }
  void look(std::string_view section, std::size_t index, std::string_view key,
            const std::vector<std::string>& names) {
    for (const std::string& name : names) look(section, index, key, name);
  }

 private:
  const Masses& masses_;
  NamePatterns names_;
  std::vector<Problem>& problems_;
};

void look_for_names(const Description& description, NameSearch& search) {
  const auto each = [](const auto& specs, const auto& look) {
    for (std::size_t i = 0; i < specs.size(); ++i) look(specs[i], i);
  };
  each(description.links, [&](const LinkSpec& spec, std::size_t i) {
    search.look("link", i, "a", spec.a);
    search.look("link", i, "b", spec.b);
  });
  each(description.ties, [&](const TieSpec& spec, std::size_t i) {
    search.look("tie", i, "a", spec.a);
    search.look("tie", i, "b", spec.b);
  });
  each(description.seams, [&](const SeamSpec& spec, std::size_t i) {
    search.look("seam", i, "a", spec.a);
    search.look("seam", i, "b", spec.b);
  });
  each(description.loads,
       [&](const LoadSpec& spec, std::size_t i) { search.look("load", i, "masses", spec.masses); });
  each(description.angles,
       [&](const AngleSpec& spec, std::size_t i) { search.look("angle", i, "masses", spec.masses); });
  each(description.hinges, [&](const HingeSpec& spec, std::size_t i) {
    search.look("hinge", i, "masses", spec.masses);
    search.look("hinge", i, "axis", spec.axis);
  });
  each(description.cones, [&](const ConeSpec& spec, std::size_t i) {
    search.look("cone", i, "frame", spec.frame);
    search.look("cone", i, "limb", spec.limb);
  });
}

}  // namespace

Built build_names(const Description& description) {
  Built built;
  built.problems = find_problems(description);
  build_names_alone(description, built);
  return built;
}

void build_names_alone(const Description& description, Built& built) {
  if (std::ranges::any_of(built.problems, decides_names)) return;
  const Description sound = stand_ins(description);
  if (!find_problems(sound).empty()) return;
  Built names = build(sound);
  if (!names.problems.empty()) return;
  NameSearch search(names.model.masses, built.problems);
  look_for_names(description, search);
  built.model.masses.name = std::move(names.model.masses.name);
  built.names_known = true;
}

}  // namespace taut
