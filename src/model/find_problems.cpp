#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "base/memory.h"
#include "builder.h"
#include "chain_ways.h"
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
  check.not_nearly_zero(chain.length, "length");
  check.not_negative(chain.last_mass, "last_mass", "kg");
  check.not_nearly_zero(chain.last_mass, "last_mass");
  if (chain.straight()) {
    check.require(chain.length > 0.0 || Checker::apart(chain.from, chain.to), "to",
                  "from and to are the same point, and no length is given");
    check.require(Checker::apart(chain.from, chain.to) || chain.links > 1, "to",
                  "one link can't begin and end at the same point");
  }
  bool first = false, last = false;
  for (const std::string& end : chain.pinned) {
    first = first || end == "first";
    last = last || end == "last";
    check.require(end == "first" || end == "last", "pinned",
                  fmt::format("pinned is a list of \"first\" and \"last\", not \"{}\"", end));
  }
  check.not_negative(chain.radius, "radius", "m");
  check.release(chain.first_release, first, "first_release");
  check.release(chain.last_release, last, "last_release");
  if (chain.bending) check.not_negative(chain.bending->stiffness, "bending", "N m/rad");
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
    check.later(time, last, "hooks", "hooks.draw: times");
    check.require(
        std::isfinite(share) && share > 0.0 && share <= sheet.fullness, "hooks",
        fmt::format("hooks.draw: the share of the rail must be above 0 and at most the fullness {}, not {}",
                    sheet.fullness, share));
  }
}

// Corners are part of two edges.
void check_edge_motions(Checker& check, const SheetSpec& sheet) {
  struct Edge {
    std::string_view name;
    const MotionSpec* motion;
  };
  const std::array<Edge, 4> edges{{{"top", &sheet.top_motion},
                                   {"bottom", &sheet.bottom_motion},
                                   {"left", &sheet.left_motion},
                                   {"right", &sheet.right_motion}}};
  const auto moves = [](const Edge& edge) { return edge.motion->given(); };
  const auto same_way = [](const MotionSpec& a, const MotionSpec& b) {
    return a.path.empty() && b.path.empty() && a.sinusoid == b.sinusoid && a.with == b.with;
  };
  for (const Edge& edge : edges) {
    const bool pinned = std::ranges::find(sheet.pinned, edge.name) != sheet.pinned.end();
    const std::string key = fmt::format("{}_motion", edge.name);
    if (moves(edge))
      check.require(pinned, key, fmt::format("{} is only for an edge that \"pinned\" names", key));
    check.motion(*edge.motion, true, key);
  }
  for (std::size_t level = 0; level < 2; ++level)
    for (std::size_t upright = 2; upright < 4; ++upright)
      check.require(!moves(edges.at(level)) || !moves(edges.at(upright)) ||
                        same_way(*edges.at(level).motion, *edges.at(upright).motion),
                    fmt::format("{}_motion", edges.at(upright).name),
                    fmt::format("{0}_motion and {1}_motion differ, and the corner {0}-{1} can't follow both",
                                edges.at(level).name, edges.at(upright).name));
  check.require(!moves(edges[0]) || sheet.hooks.draw.empty(), "top_motion",
                "hooks.draw moves masses of the top edge already");
}

// The least height of a face at rest: its right angle over the diagonal.
double face_height(const SheetSpec& sheet) {
  const double along = sheet.fullness * (sheet.to - sheet.from).norm() / (sheet.columns - 1);
  const double down = sheet.down.norm() / (sheet.rows - 1);
  return along * down / std::hypot(along, down);
}

void check_faces(Checker& check, const SheetSpec& sheet) {
  check.positive(sheet.faces->thickness, "faces", "m thick");
  check.not_negative(sheet.faces->friction, "faces", "");
  check.require(sheet.radius == 0.0, "radius",
                "a sheet whose faces touch has a thickness in place of a radius: write one of the two");
  const double most = 0.5 * face_height(sheet);
  check.require(
      !(sheet.faces->thickness > most), "faces",
      fmt::format("faces must be at most half as thick as the least height of one, {:.4g} m, not {:.4g} m: "
                  "else neighbours are in each other's way",
                  most, sheet.faces->thickness));
}

void check_sheet(Checker& check, const SheetSpec& sheet) {
  check.name(sheet.name);
  check.require(sheet.rows >= 2, "rows", fmt::format("rows must be 2 or more, not {}", sheet.rows));
  check.require(sheet.columns >= 2, "columns",
                fmt::format("columns must be 2 or more, not {}", sheet.columns));
  check.finite(sheet.from, "from");
  check.finite(sheet.to, "to");
  check.finite(sheet.down, "down");
  check.require((sheet.to - sheet.from).cross(sheet.down).norm() > 0.0 &&
                    Checker::apart(sheet.from, sheet.to) && Checker::apart(sheet.down, Vec3::Zero()),
                "down", "from → to and down must span a rectangle, not a line");
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
  check_edge_motions(check, sheet);
  check.not_negative(sheet.radius, "radius", "m");
  if (sheet.faces && sheet.rows >= 2 && sheet.columns >= 2) check_faces(check, sheet);
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
  check.release(mass.release, mass.pinned, "release");
}

void check_link(Checker& check, const LinkSpec& link) {
  if (link.length) check.positive(*link.length, "length", "m");
  check.properties(link.properties);
}

void check_tie(Checker& check, const TieSpec& tie) {
  check.require(tie.every >= 1, "every", fmt::format("every must be 1 or more, not {}", tie.every));
  check.properties(tie.properties);
}

void check_load(Checker& check, const LoadSpec& load) {
  check.finite(load.force, "force");
  check.not_negative(load.from, "from", "s");
  check.require(std::isfinite(load.to) && load.to >= load.from, "to",
                fmt::format("to = {} s is before from = {} s", load.to, load.from));
  if (load.until)
    check.require(std::isfinite(*load.until) && *load.until >= load.to, "until",
                  fmt::format("until = {} s is before to = {} s", *load.until, load.to));
  check.require(!load.gone || load.until, "gone", "gone is when a load has fallen away; it needs an until");
  if (load.gone && load.until)
    check.require(std::isfinite(*load.gone) && *load.gone >= *load.until, "gone",
                  fmt::format("gone = {} s is before until = {} s", *load.gone, *load.until));
}

void check_seam(Checker& check, const SeamSpec& seam) {
  const bool of_sheet = !seam.sheet.empty(), between = !seam.a.empty() || !seam.b.empty();
  check.require(of_sheet != between, "sheet",
                "a seam lies either in a \"sheet\", beyond a \"row\" or a \"column\", or between the masses "
                "\"a\" and \"b\"");
  if (between) check.require(!seam.a.empty() && !seam.b.empty(), "b", "a seam needs both \"a\" and \"b\"");
  check.require(of_sheet ? seam.row.has_value() != seam.column.has_value() : !seam.row && !seam.column, "row",
                of_sheet ? "a seam in a sheet needs either a \"row\" or a \"column\""
                         : "\"row\" and \"column\" are for a seam in a \"sheet\"");
  if (seam.strength) check.positive(*seam.strength, "strength", "");
  check.require(
      !seam.strength || (!seam.break_stretch && !seam.break_tension), "strength",
      "strength is a share of what links bear otherwise; with a threshold of its own a seam has none");
  if (seam.break_stretch)
    check.require(std::isfinite(*seam.break_stretch) && *seam.break_stretch > 1.0, "break_stretch",
                  fmt::format("break_stretch must be above 1, not {}", *seam.break_stretch));
  if (seam.break_tension) check.positive(*seam.break_tension, "break_tension", "N");
  if (seam.break_at) check.positive(*seam.break_at, "break_at", "s");
  check.require(seam.strength || seam.break_stretch || seam.break_tension || seam.break_at, "strength",
                "a seam needs a \"strength\", a threshold, or a \"break_at\"");
}

// Counts that the machine's memory can't hold, or the indices can't number, are refused before anything is
// built.
class MemoryCheck {
 public:
  explicit MemoryCheck(Checker& check) : check_(check) {}

  template <typename Spec>
  void add(std::string_view section, std::string_view key, const std::vector<Spec>& specs) {
    for (std::size_t i = 0; i < specs.size(); ++i) {
      total_ += count(specs[i]);
      check_.enter(section, i);
      refuse_what_is_too_much(key, count(specs[i]));
    }
  }

 private:
  void refuse_what_is_too_much(std::string_view key, const Counts& here) {
    constexpr double most = std::numeric_limits<Index>::max();
    const double memory = usable_memory();
    const bool refused =
        std::max(total_.masses, total_.links) >= most || bytes_needed(total_) >= 0.8 * memory;
    const bool alone = bytes_needed(here) > 0.9 * bytes_needed(total_);
    check_.require(!refused, key,
                   fmt::format("{:.3g} masses and {:.3g} links{} need about {}; this machine has {}",
                               total_.masses, total_.links, alone ? "" : ", with what stands before them,",
                               format_bytes(bytes_needed(total_)), format_bytes(memory)));
  }

  Checker& check_;
  Counts total_;
};

void check_memory(Checker& check, const Description& description) {
  MemoryCheck memory(check);
  memory.add("chain", "links", description.chains);
  memory.add("sheet", "rows", description.sheets);
  memory.add("mesh", "file", description.meshes);
  memory.add("points", "masses", description.points);
  memory.add("ragdoll", "", description.ragdolls);
}

}  // namespace

std::vector<Problem> find_problems(const Description& description) {
  Checker check;
  check.know_solids(description);
  check_world(check, description);
  check_each(check, "chain", description.chains, check_chain);
  check_each(check, "sheet", description.sheets, check_sheet);
  check_files(check, description);
  check_each(check, "mass", description.masses, check_mass);
  check_each(check, "link", description.links, check_link);
  check_each(check, "tie", description.ties, check_tie);
  check_each(check, "load", description.loads, check_load);
  check_each(check, "seam", description.seams, check_seam);
  check_surroundings(check, description);
  check_bodies(check, description);
  check_memory(check, description);
  check_chain_ways(check, description);
  return std::move(check.problems);
}

}  // namespace taut
