#include "chain_ways.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/nearest.h"
#include "checker.h"
#include "curves.h"

namespace taut {
namespace {

// The solid of a section that a name such as "drum" or "capsule.1" means.
template <typename Spec>
const Spec* entry_named(std::string_view name, std::string_view section, const std::vector<Spec>& specs) {
  for (const Spec& spec : specs)
    if (!name.empty() && spec.moves.name == name) return &spec;
  if (!name.starts_with(section) || name.size() <= section.size() + 1 || name[section.size()] != '.')
    return nullptr;
  const std::string_view digits = name.substr(section.size() + 1);
  std::size_t number = 0;
  const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool whole = code == std::errc{} && end == digits.data() + digits.size();
  return whole && number < specs.size() ? &specs[number] : nullptr;
}

void check_points(Checker& check, const ChainSpec& chain) {
  check.require(chain.points.size() >= 2, "points", "points must be 2 or more");
  for (std::size_t i = 0; i < chain.points.size(); ++i) {
    check.require(chain.points[i].allFinite(), "points", "points must have finite numbers");
    check.require(i == 0 || Checker::apart(chain.points[i - 1], chain.points[i]), "points",
                  fmt::format("points {} and {} are the same point", i, i + 1));
  }
}

void check_winding(Checker& check, const ChainSpec& chain, const Description& description) {
  constexpr double most_turns = 1000.0;
  const WindingSpec& wound = *chain.wound;
  const auto key = [](std::string_view name) { return fmt::format("wound.{}", name); };
  const double turns = std::abs(wound.turns);
  check.require(turns >= 0.01 && turns <= most_turns, key("turns"),
                fmt::format("wound.turns must be from 0.01 to {:g}, or as many the other way, not {:g}",
                            most_turns, wound.turns));
  check.require(wound.start >= 0.0 && wound.start < wound.end && wound.end <= 1.0, key("end"),
                fmt::format("wound.start and wound.end are shares of the solid's length, the first below the "
                            "second: not {:g} and {:g}",
                            wound.start, wound.end));
  check.require(wound.axis.norm() >= smallest_divisor && wound.axis.allFinite(), key("axis"),
                "wound.axis must not be zero");
  if (spool_of(chain, description)) return;
  const std::vector<std::string> names = spool_names(description);
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  check.require(
      false, key("around"),
      names.empty()
          ? fmt::format("wound.around = \"{}\": the scene has no sphere and no capsule", wound.around)
          : fmt::format("wound.around names no sphere or capsule: \"{}\"; there {} {}", wound.around,
                        names.size() == 1 ? "is" : "are", fmt::join(names, ", ")));
  check.problems.back().suggestion = std::string(nearest_name(wound.around, candidates));
}

// What goes only with the one or the other.
void check_kind(Checker& check, const ChainSpec& chain) {
  check.require(chain.points.empty() || !chain.wound, "wound", "a chain has points or is wound, not both");
  check.require(chain.straight() || chain.length == 0.0, "length",
                fmt::format("{} says how long this chain is: it has no \"length\"",
                            chain.points.empty() ? "wound" : "points"));
  check.require(!chain.smooth || !chain.points.empty(), "smooth", "smooth is for a chain that has points");
}

}  // namespace

std::optional<Spool> spool_of(const ChainSpec& chain, const Description& description) {
  const WindingSpec& wound = *chain.wound;
  if (const CapsuleSpec* capsule = entry_named(wound.around, "capsule", description.capsules))
    return Spool{capsule->from, capsule->to, capsule->radius + chain.radius, false};
  if (const SphereSpec* sphere = entry_named(wound.around, "sphere", description.spheres)) {
    const double radius = sphere->radius + chain.radius;
    const Vec3 reach = radius * wound.axis.normalized();
    return Spool{sphere->centre - reach, sphere->centre + reach, radius, true};
  }
  return std::nullopt;
}

std::vector<std::string> spool_names(const Description& description) {
  std::vector<std::string> names;
  const auto add = [&names](std::string_view section, const auto& specs) {
    for (std::size_t i = 0; i < specs.size(); ++i)
      names.push_back(specs[i].moves.name.empty() ? fmt::format("{}.{}", section, i) : specs[i].moves.name);
  };
  add("sphere", description.spheres);
  add("capsule", description.capsules);
  return names;
}

std::optional<std::vector<Vec3>> laid_out_chain(const ChainSpec& chain, const Description& description) {
  if (chain.wound)
    return spread_evenly(
        winding(*spool_of(chain, description), chain.wound->turns, chain.wound->start, chain.wound->end),
        chain.links);
  return spread_evenly(chain.smooth ? smooth_curve(chain.points) : chain.points, chain.links);
}

void check_chain_ways(Checker& check, const Description& description) {
  for (std::size_t i = 0; i < description.chains.size(); ++i) {
    const ChainSpec& chain = description.chains[i];
    check.enter("chain", i);
    check_kind(check, chain);
    if (!chain.points.empty()) check_points(check, chain);
    if (chain.wound) check_winding(check, chain, description);
    // So that nothing is laid out that is wrong, or too much for the memory.
    if (chain.straight() || !check.problems.empty()) continue;
    if (chain.wound &&
        !Checker::apart(spool_of(chain, description)->from, spool_of(chain, description)->to)) {
      check.require(false, "wound.around", "the capsule that it is wound around has no length to wind along");
      continue;
    }
    check.require(
        laid_out_chain(chain, description).has_value(), "links",
        fmt::format("{} links are too few for how sharply this chain turns: they can't all be of one "
                    "length",
                    chain.links));
  }
}

}  // namespace taut
