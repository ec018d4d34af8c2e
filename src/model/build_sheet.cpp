#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <utility>

#include "builder.h"

namespace taut {
namespace {

// Largest heading θ_max of a pleat of n links with headings θ_max·sin(2πi/n) whose chords, each of length 1,
// together reach n/fullness along the rail. Their mean cosine falls from 1 to its first minimum below 0 (that
// of the Bessel function J₀, near 3.83), so bisection up to there finds every fullness.
double pleat_heading(int n, double fullness) {
  double low = 0.0, high = 3.8317;
  for (int step = 0; step < 200; ++step) {
    const double middle = 0.5 * (low + high);
    double reach = 0.0;
    for (int i = 0; i < n; ++i) reach += std::cos(middle * std::sin(2.0 * std::numbers::pi * i / n));
    (reach / n > 1.0 / fullness ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// Position of each column relative to the first, the pleats lying in the plane of the rail and `outward`.
std::vector<Vec3> column_offsets(const SheetSpec& spec, double fullness, const Vec3& rail,
                                 const Vec3& outward) {
  const int links = spec.columns - 1;
  const int pleat = spec.hooks.every > 0 ? spec.hooks.every : links;
  const double cloth_width = spec.fullness * rail.norm();
  const double chord = cloth_width / links;
  const double largest = fullness > 1.0 ? pleat_heading(pleat, fullness) : 0.0;
  std::vector<Vec3> offsets{Vec3::Zero()};
  for (int i = 0; i < links; ++i) {
    const double heading = largest * std::sin(2.0 * std::numbers::pi * i / pleat);
    offsets.push_back(offsets.back() +
                      chord * (std::cos(heading) * rail.normalized() + std::sin(heading) * outward));
  }
  return offsets;
}

// Each edge once, however often it is named.
std::vector<std::string> different_edges(const SheetSpec& spec) {
  std::vector<std::string> edges = spec.pinned;
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

bool pinned_by_edge(const SheetSpec& spec, const std::vector<std::string>& edges, int row, int column) {
  const bool top = row == 0, bottom = row == spec.rows - 1, left = column == 0,
             right = column == spec.columns - 1;
  return std::any_of(edges.begin(), edges.end(), [&](const std::string& edge) {
    return (edge == "top" && top) || (edge == "bottom" && bottom) || (edge == "left" && left) ||
           (edge == "right" && right) || (edge == "top-left" && top && left) ||
           (edge == "top-right" && top && right) || (edge == "bottom-left" && bottom && left) ||
           (edge == "bottom-right" && bottom && right);
  });
}

bool is_hook(const SheetSpec& spec, int row, int column) {
  return row == 0 && spec.hooks.every > 0 && column % spec.hooks.every == 0;
}

// A hook's way along the rail: its own share of the rail times the share that all hooks span then.
Path hook_path(const SheetSpec& spec, int column) {
  const double place = static_cast<double>(column) / (spec.columns - 1);
  std::vector<Knot> knots;
  for (const auto& [time, share] : spec.hooks.draw)
    knots.push_back({time, spec.from + (spec.to - spec.from) * (place * share)});
  return make_path(std::move(knots));
}

// How an edge is moved, and the mass that its path is that of.
struct EdgeMotion {
  const MotionSpec* motion = nullptr;
  int row = 0, column = 0;
};

EdgeMotion motion_at(const SheetSpec& spec, int row, int column) {
  const int last_row = spec.rows - 1, last_column = spec.columns - 1;
  if (row == 0 && spec.top_motion.given()) return {&spec.top_motion, 0, 0};
  if (row == last_row && spec.bottom_motion.given()) return {&spec.bottom_motion, last_row, 0};
  if (column == 0 && spec.left_motion.given()) return {&spec.left_motion, 0, 0};
  if (column == last_column && spec.right_motion.given()) return {&spec.right_motion, 0, last_column};
  return {};
}

// The same motion from another place.
MotionSpec moved_by(MotionSpec motion, const Vec3& offset) {
  for (Knot& knot : motion.path) knot.position += offset;
  return motion;
}

void add_masses(Builder& builder, const SheetSpec& spec) {
  const double first_share = spec.hooks.draw.empty() ? 1.0 : spec.hooks.draw.front()[1];
  const Vec3 rail = spec.to - spec.from;
  const Vec3 outward = rail.cross(spec.down).normalized();
  const std::vector<Vec3> offsets = column_offsets(spec, spec.fullness / first_share, rail, outward);
  const std::vector<std::string> edges = different_edges(spec);
  const double share = spec.mass / (static_cast<double>(spec.rows) * spec.columns);
  const auto place = [&](int row, int column) -> Vec3 {
    return spec.from + spec.down * (static_cast<double>(row) / (spec.rows - 1)) +
           offsets[static_cast<std::size_t>(column)];
  };
  for (int row = 0; row < spec.rows; ++row) {
    for (int column = 0; column < spec.columns; ++column) {
      const bool hook = is_hook(spec, row, column);
      const Index mass = builder.add_mass(
          spec.name + "." + std::to_string(row) + "." + std::to_string(column), place(row, column),
          Vec3::Zero(), share, hook || pinned_by_edge(spec, edges, row, column),
          spec.faces ? 0.5 * spec.faces->thickness : spec.radius);
      if (hook && !spec.hooks.draw.empty()) builder.drive(mass, hook_path(spec, column));
      if (const EdgeMotion edge = motion_at(spec, row, column); edge.motion != nullptr)
        builder.drive(mass, moved_by(*edge.motion, place(row, column) - place(edge.row, edge.column)));
      builder.release_at(mass, spec.release);
    }
  }
}

// Adds links between masses and knows which link joins which two.
class SheetLinks {
 public:
  SheetLinks(Builder& builder, const SheetSpec& spec, Index first_mass)
      : builder_(builder), spec_(spec), first_mass_(first_mass) {
    const Vec3 rail = spec.to - spec.from;
    along_row_ = rail * (spec.fullness / (spec.columns - 1));
    along_column_ = spec.down / (spec.rows - 1);
  }

  Index mass(int row, int column) const {
    return first_mass_ + static_cast<Index>(row) * static_cast<Index>(spec_.columns) +
           static_cast<Index>(column);
  }

  // A link from every mass to the one (rows, columns) on, where there is one; its length is that of the flat
  // cloth.
  void add_family(int rows, int columns, const LinkProperties& properties, LinkFamily family) {
    const double length = (rows * along_column_ + columns * along_row_).norm();
    families_.push_back({rows, columns, static_cast<Index>(builder_.model.links.size())});
    for (int row = 0; row + rows < spec_.rows; ++row)
      for (int column = std::max(0, -columns); column + std::max(0, columns) < spec_.columns; ++column)
        builder_.add_link(mass(row, column), mass(row + rows, column + columns), length, properties, family);
  }

  // The link that joins two masses, or no_link: families are laid out row after row, so its place is known.
  Index between(Index one, Index other) const {
    const auto [a, b] = std::minmax(one, other);
    const int row = row_of(a), column = column_of(a);
    for (const SteppedLinks& links : families_) {
      if (row_of(b) - row != links.rows || column_of(b) - column != links.columns) continue;
      const int a_row_has = spec_.columns - std::abs(links.columns);
      return links.first + static_cast<Index>(row) * static_cast<Index>(a_row_has) +
             static_cast<Index>(column - std::max(0, -links.columns));
    }
    return no_link;
  }

 private:
  // Links from every mass to the one so many rows and columns on.
  struct SteppedLinks {
    int rows, columns;
    Index first;
  };

  int row_of(Index mass) const { return static_cast<int>((mass - first_mass_) / columns()); }
  int column_of(Index mass) const { return static_cast<int>((mass - first_mass_) % columns()); }
  Index columns() const { return static_cast<Index>(spec_.columns); }

  Builder& builder_;
  const SheetSpec& spec_;
  Index first_mass_;
  Vec3 along_row_, along_column_;
  std::vector<SteppedLinks> families_;
};

void add_triangle(Model& model, const SheetLinks& links, Index a, Index b, Index c) {
  model.triangles.push_back({{a, b, c}, {links.between(a, b), links.between(b, c), links.between(c, a)}});
}

// Along one direction, line by line: what is in a line comes one after another.
void add_bends_along(Builder& builder, const SheetLinks& links, const SheetSpec& spec, int rows, int columns,
                     double stiffness) {
  const auto inside = [&](int row, int column) {
    return row >= 0 && row < spec.rows && column >= 0 && column < spec.columns;
  };
  for (int row = 0; row < spec.rows; ++row)
    for (int column = 0; column < spec.columns; ++column) {
      if (inside(row - rows, column - columns)) continue;  // a line begins at the edge
      for (int i = 1; inside(row + (i + 1) * rows, column + (i + 1) * columns); ++i) {
        const auto mass = [&](int steps) { return links.mass(row + steps * rows, column + steps * columns); };
        Bend bend{{mass(i - 1), mass(i), mass(i + 1)}, stiffness, 0.0, {no_link, no_link, no_link, no_link}};
        bend.links[0] = links.between(mass(i - 1), mass(i));
        bend.links[1] = links.between(mass(i), mass(i + 1));
        if (rows != 0 && columns != 0) {  // across cells, which hold together by their edges
          bend.links[2] = links.between(mass(i), links.mass(row + (i - 1) * rows, column + i * columns));
          bend.links[3] = links.between(mass(i), links.mass(row + (i + 1) * rows, column + i * columns));
        }
        builder.add_bend(bend, spec.bending->from_start);
      }
    }
}

void add_bends(Builder& builder, const SheetLinks& links, const SheetSpec& spec) {
  const SheetBendingSpec& bending = *spec.bending;
  add_bends_along(builder, links, spec, 1, 0, bending.warp.value_or(bending.stiffness));
  add_bends_along(builder, links, spec, 0, 1, bending.weft.value_or(bending.stiffness));
  add_bends_along(builder, links, spec, 1, 1, bending.bias);
  add_bends_along(builder, links, spec, 1, -1, bending.bias);
}

}  // namespace

Counts count(const SheetSpec& spec) {
  const double rows = spec.rows, columns = spec.columns;
  double links = rows * (columns - 1) + columns * (rows - 1);
  if (spec.diagonals) links += 2.0 * (rows - 1) * (columns - 1);
  if (spec.skip_one) links += rows * (columns - 2) + columns * (rows - 2);
  const double hooks = spec.hooks.every > 0 ? (columns - 1) / spec.hooks.every + 1.0 : 0.0;
  return {rows * columns, links, 2.0 * (rows - 1) * (columns - 1),
          hooks * static_cast<double>(spec.hooks.draw.size())};
}

void add_sheet(Builder& builder, const SheetSpec& spec) {
  Sheet sheet;
  sheet.name = spec.name;
  sheet.first_mass = static_cast<Index>(builder.model.masses.size());
  sheet.mass_count = static_cast<Index>(spec.rows) * static_cast<Index>(spec.columns);
  sheet.rows = static_cast<Index>(spec.rows);
  sheet.columns = static_cast<Index>(spec.columns);
  sheet.first_triangle = static_cast<Index>(builder.model.triangles.size());
  builder.begin_body(spec.collides);
  add_masses(builder, spec);

  sheet.first_link = static_cast<Index>(builder.model.links.size());
  SheetLinks links(builder, spec, sheet.first_mass);
  links.add_family(0, 1, spec.weft.value_or(spec.properties), LinkFamily::structural);
  links.add_family(1, 0, spec.properties, LinkFamily::structural);
  if (spec.diagonals) {
    links.add_family(1, 1, *spec.diagonals, LinkFamily::diagonals);
    links.add_family(1, -1, *spec.diagonals, LinkFamily::diagonals);
  }
  if (spec.skip_one) {
    links.add_family(0, 2, *spec.skip_one, LinkFamily::skip_one);
    links.add_family(2, 0, *spec.skip_one, LinkFamily::skip_one);
  }
  sheet.link_count = static_cast<Index>(builder.model.links.size()) - sheet.first_link;
  for (int row = 0; row + 1 < spec.rows; ++row)
    for (int column = 0; column + 1 < spec.columns; ++column) {
      const Index top_left = links.mass(row, column), top_right = links.mass(row, column + 1);
      const Index bottom_left = links.mass(row + 1, column), bottom_right = links.mass(row + 1, column + 1);
      add_triangle(builder.model, links, top_left, bottom_left, top_right);
      add_triangle(builder.model, links, top_right, bottom_left, bottom_right);
    }
  if (spec.bending) add_bends(builder, links, spec);
  sheet.triangle_count = static_cast<Index>(builder.model.triangles.size()) - sheet.first_triangle;
  builder.model.sheets.push_back(std::move(sheet));
  if (spec.faces)
    builder.model.faces.push_back({static_cast<Index>(builder.model.sheets.size() - 1), spec.faces->thickness,
                                   spec.faces->friction, spec.faces->self_collides, builder.body()});
}

}  // namespace taut
