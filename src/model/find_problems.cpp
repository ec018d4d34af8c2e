#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/memory.h"
#include "builder.h"
#include "checker.h"

namespace taut {
namespace {

void check_world(Checker& check, const Description& description) {
  check.enter("world", 0);
  check.finite(description.gravity, "gravity");
  check.not_negative(description.drag, "drag", "1/s");
}

void check_chain(Checker& check, const ChainSpec& chain) {
  check.name(chain.name);
  check.finite(chain.from, "from");
  check.finite(chain.to, "to");
  check.require(chain.links >= 1, "links", fmt::format("links must be 1 or more, not {}", chain.links));
  check.positive(chain.mass, "mass", "kg");
  check.not_negative(chain.length, "length", "m");
  check.not_negative(chain.last_mass, "last_mass", "kg");
  check.require(chain.length > 0.0 || chain.from != chain.to, "to",
                "from and to are the same point, and no length is given");
  check.require(chain.from != chain.to || chain.links > 1, "to",
                "one link can't begin and end at the same point");
  bool first = false, last = false;
  for (const std::string& end : chain.pinned) {
    first = first || end == "first";
    last = last || end == "last";
    check.require(end == "first" || end == "last", "pinned",
                  fmt::format("pinned is a list of \"first\" and \"last\", not \"{}\"", end));
  }
  check.not_negative(chain.radius, "radius", "m");
  check.motion(chain.first_motion, first, "first_motion");
  check.motion(chain.last_motion, last, "last_motion");
  check.properties(chain.properties);
}

void check_hooks(Checker& check, const SheetSpec& sheet) {
  const HookSpec& hooks = sheet.hooks;
  check.require(hooks.every >= 0, "hooks", fmt::format("hooks.every must be 0 or more, not {}", hooks.every));
  check.require(hooks.every > 0 || hooks.draw.empty(), "hooks", "hooks.draw needs hooks.every");
  if (hooks.every <= 0) return;
  check.require(
      (sheet.columns - 1) % hooks.every == 0, "hooks",
      fmt::format("hooks.every = {} does not divide columns − 1 = {}", hooks.every, sheet.columns - 1));
  check.require(sheet.fullness == 1.0 || hooks.every >= 3, "hooks",
                fmt::format("a pleat needs at least 3 columns between hooks, not {}", hooks.every));
  check.require(
      hooks.draw.empty() || hooks.draw.front()[0] >= 0.0, "hooks",
      "hooks.draw must begin at 0 s or later: the pleats at the start are those of its first share");
  double last = -infinity;
  for (const auto& [time, share] : hooks.draw) {
    check.require(std::isfinite(time) && time > last, "hooks", "hooks.draw: times must increase");
    check.require(
        std::isfinite(share) && share > 0.0 && share <= sheet.fullness, "hooks",
        fmt::format("hooks.draw: the share of the rail must be above 0 and at most the fullness {}, not {}",
                    sheet.fullness, share));
    last = time;
  }
}

void check_sheet(Checker& check, const SheetSpec& sheet) {
  check.name(sheet.name);
  check.require(sheet.rows >= 2, "rows", fmt::format("rows must be 2 or more, not {}", sheet.rows));
  check.require(sheet.columns >= 2, "columns",
                fmt::format("columns must be 2 or more, not {}", sheet.columns));
  check.finite(sheet.from, "from");
  check.finite(sheet.to, "to");
  check.finite(sheet.down, "down");
  check.require((sheet.to - sheet.from).cross(sheet.down).norm() > 0.0, "down",
                "from → to and down must span a rectangle, not a line");
  check.positive(sheet.mass, "mass", "kg");
  check.require(std::isfinite(sheet.fullness) && sheet.fullness >= 1.0, "fullness",
                fmt::format("fullness must be 1 or more, not {}", sheet.fullness));
  check_hooks(check, sheet);
  for (const std::string& edge : sheet.pinned) {
    static const std::vector<std::string> edges{"top",      "bottom",    "left",        "right",
                                                "top-left", "top-right", "bottom-left", "bottom-right"};
    check.require(
        std::find(edges.begin(), edges.end(), edge) != edges.end(), "pinned",
        fmt::format("pinned names edges (top, bottom, left, right) or corners (top-left …), not \"{}\"",
                    edge));
  }
  check.not_negative(sheet.radius, "radius", "m");
  check.properties(sheet.properties);
  if (sheet.diagonals) check.properties(*sheet.diagonals, "diagonals.");
  if (sheet.skip_one) check.properties(*sheet.skip_one, "skip_one.");
}

void check_mass(Checker& check, const MassSpec& mass) {
  check.name(mass.name);
  check.finite(mass.position, "position");
  check.finite(mass.velocity, "velocity");
  check.positive(mass.mass, "mass", "kg");
  check.not_negative(mass.radius, "radius", "m");
  check.motion(mass.motion, mass.pinned, "motion");
}

void check_link(Checker& check, const LinkSpec& link) {
  if (link.length) check.positive(*link.length, "length", "m");
  check.properties(link.properties);
}

void check_load(Checker& check, const LoadSpec& load) {
  check.finite(load.force, "force");
  check.not_negative(load.from, "from", "s");
  check.require(std::isfinite(load.to) && load.to >= load.from, "to",
                fmt::format("to = {} s is before from = {} s", load.to, load.from));
}

// Counts that the machine's memory can't hold, or the indices can't number, are refused before anything is
// built.
void check_memory(Checker& check, const Description& description) {
  constexpr double bytes_per_mass = 400.0, bytes_per_link = 280.0, bytes_per_triangle = 48.0;
  double total = 0.0;
  const auto add = [&](std::string_view section, std::size_t index, std::string_view key,
                       const Counts& counts) {
    const double bytes = counts.masses * bytes_per_mass + counts.links * bytes_per_link +
                         counts.triangles * bytes_per_triangle;
    total += bytes;
    check.enter(section, index);
    const bool numbered = std::max(counts.masses, counts.links) < std::numeric_limits<Index>::max();
    check.require(
        numbered && total < 0.8 * physical_memory(), key,
        fmt::format("{:.3g} masses and {:.3g} links need about {}; this machine has {}", counts.masses,
                    counts.links, format_bytes(bytes), format_bytes(physical_memory())));
  };
  for (std::size_t i = 0; i < description.chains.size(); ++i)
    add("chain", i, "links", count(description.chains[i]));
  for (std::size_t i = 0; i < description.sheets.size(); ++i)
    add("sheet", i, "rows", count(description.sheets[i]));
}

}  // namespace

std::vector<Problem> find_problems(const Description& description) {
  Checker check;
  check_world(check, description);
  check_each(check, "chain", description.chains, check_chain);
  check_each(check, "sheet", description.sheets, check_sheet);
  check_each(check, "mass", description.masses, check_mass);
  check_each(check, "link", description.links, check_link);
  check_each(check, "load", description.loads, check_load);
  check_surroundings(check, description);
  check_bodies(check, description);
  check_memory(check, description);
  return std::move(check.problems);
}

}  // namespace taut
