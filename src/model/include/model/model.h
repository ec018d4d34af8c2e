#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/vectors.h"
#include "model/bends.h"
#include "model/colliders.h"
#include "model/faces.h"
#include "model/joints.h"
#include "model/limits.h"
#include "model/motion.h"
#include "model/wind.h"

namespace taut {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// The constant side of masses, one entry a mass in every array.
struct Masses {
  std::vector<std::string> name;
  std::vector<double> mass;          ///< kg
  std::vector<double> inverse_mass;  ///< 1/kg; 0 when pinned
  std::vector<double> radius;        ///< m, of contact; 0: a point
  std::vector<double> release_at;    ///< s, when a pin lets go of it; infinity = never; empty where none does

  std::size_t size() const { return mass.size(); }
  /// Whether it is a pin at the start of a run.
  bool pinned(std::size_t i) const { return inverse_mass[i] == 0.0; }
  /// Whether it is a pin at a time.
  bool held(std::size_t i, double time) const {
    return pinned(i) && (release_at.empty() || time < release_at[i]);
  }
};

/// What a link is for: to carry, or to stand in for a sheet's stiffness against shear or bending.
enum class LinkFamily : std::uint8_t { structural, diagonals, skip_one };

/// The distances (m) between which a link does nothing: it pulls beyond the longest, and pushes below the
/// shortest. Where the two are one, it does both about its length.
struct FreeRange {
  double shortest = 0.0, longest = 0.0;

  /// How far (m) a distance is beyond: above 0 the link pulls, below 0 it pushes.
  double beyond(double distance) const { return distance - std::clamp(distance, shortest, longest); }
};

/// The constant side of links, one entry a link in every array.
struct Links {
  std::vector<Index> a, b;
  std::vector<LinkFamily> family;
  std::vector<double> length;         ///< m
  std::vector<double> stiffness;      ///< N/m; infinity = rigid
  std::vector<double> damping;        ///< N s/m; 0 for rigid links
  std::vector<double> break_stretch;  ///< × length; infinity = never
  std::vector<double> break_tension;  ///< N; infinity = never
  std::vector<FreeRange> free_range;  ///< empty where no link of the model has one

  std::size_t size() const { return a.size(); }
  /// Whether there are distances at which the link does nothing. It is solved as the limit on its reach then.
  bool one_sided(std::size_t i) const {
    return !free_range.empty() && free_range[i].shortest < free_range[i].longest;
  }
  /// How far (m) a link is beyond where it does nothing: above 0 it pulls, below 0 it pushes.
  double stretch(std::size_t i, double distance) const {
    return one_sided(i) ? free_range[i].beyond(distance) : distance - length[i];
  }
  /// The same as a share of its length.
  double strain(std::size_t i, double distance) const {
    return one_sided(i) ? stretch(i, distance) / length[i] : distance / length[i] - 1.0;
  }
  bool rigid(std::size_t i) const { return stiffness[i] == infinity; }
  double compliance(std::size_t i) const { return 1.0 / stiffness[i]; }  ///< m/N; 0 = rigid
};

/// A pinned mass that moves as prescribed.
struct DrivenPin {
  Index mass = 0;
  Motion motion;
};

/// What happens at a time whatever the masses do: links break, and pins let go of their masses.
struct Change {
  double time = 0.0;  ///< s, above 0
  std::vector<Index> links, pins;
};

/// A force on each of some masses that grows linearly from nothing at `from` to `force` at `to`, stays until
/// `until`, and is gone, as linearly, at `gone`.
struct Load {
  std::vector<Index> masses;
  Vec3 force = Vec3::Zero();                                             ///< N on each mass
  double from = 0.0;                                                     ///< s
  double to = 0.0;                                                       ///< s
  double until = std::numeric_limits<double>::infinity(), gone = until;  ///< s

  /// The share of the full force at a time, 0 to 1.
  double share(double time) const {
    if (time >= until) return time >= gone ? 0.0 : (gone - time) / (gone - until);
    return time >= to ? 1.0 : time <= from ? 0.0 : (time - from) / (to - from);
  }
};

/// A triangle of a sheet or a mesh, whole while none of its edges that are links is broken.
struct Triangle {
  std::array<Index, 3> masses;
  std::array<Index, 3> links;  ///< link along each edge, no_link where the edge is none
};

/// Where the masses, links and triangles of a sheet, or of a mesh, lie in the arrays. A sheet's masses are
/// row after row; a mesh is a sheet without rows.
struct Sheet {
  std::string name;
  Index first_mass = 0, mass_count = 0;
  Index rows = 0, columns = 0;  ///< 0 and 0: a mesh
  Index first_triangle = 0, triangle_count = 0;
  Index first_link = 0, link_count = 0;
  std::vector<Index> along_curve{};  ///< of a mesh: its masses, from 0, so that what is near at the start is
                                     ///< near in the list

  bool is_mesh() const { return rows == 0; }
};

/// Where the masses and links of a set of points lie in the arrays.
struct PointSet {
  std::string name;
  Index first_mass = 0, mass_count = 0;
  Index first_link = 0, link_count = 0;
};

/// Where a chain's masses and links lie in the arrays, in order along the chain.
struct Chain {
  std::string name;
  Index first_mass = 0, first_link = 0;
  Index link_count = 0;
};

/// A straight part of a body, drawn as a capsule. Each end is the middle of two masses, which may be one.
struct Bone {
  std::array<Index, 2> from{}, to{};
  double radius = 0.0;  ///< m
};

/// Where a ragdoll's masses, links, bones and limits lie in the arrays.
struct Ragdoll {
  std::string name;
  Index first_mass = 0, mass_count = 0;
  Index first_link = 0, link_count = 0;
  Index first_bone = 0, bone_count = 0;
  Index first_limit = 0, limit_count = 0;
};

/// Where the masses and links that a scene names one by one lie in the arrays, in its order.
struct Singles {
  Index first_mass = 0, mass_count = 0;
  Index first_link = 0, link_count = 0;
};

struct State;

/// Everything about a scene's physics that never changes during a run.
struct Model {
  Vec3 gravity{0.0, -9.81, 0.0};  ///< m/s²
  double drag = 0.0;              ///< 1/s; force −drag·m·v
  Masses masses;
  Links links;
  std::vector<DrivenPin> driven_pins;
  std::vector<Load> loads;
  std::vector<Collider> colliders;     ///< all solids, the ground among them
  std::vector<ContactPoint> contacts;  ///< what touches them; none without colliders and touching bodies
  std::vector<Limit> limits;
  std::vector<Joint> joints;  ///< those that resist
  std::vector<Bend> bends;
  std::vector<Change> changes;  ///< in order of time, no two at the same
  std::optional<Wind> wind;
  std::vector<Triangle> triangles;
  std::vector<Sheet> sheets;  ///< those of a scene, then its meshes
  std::vector<PointSet> point_sets;
  std::vector<SheetFaces> faces;  ///< of sheets whose faces touch; those of the others are only drawn
  std::vector<Chain> chains;
  std::vector<Ragdoll> ragdolls;
  std::vector<Bone> bones;
  Singles singles;
  std::vector<Index> breakable_links;  ///< those with a finite break_stretch or break_tension, or that
                                       ///< break at a time, in file order
};

/// Sum of the lengths of all links (m): the size that relative accuracies refer to.
double total_link_length(const Model& model);

/// Sum of the masses that are not pinned (kg).
double free_mass(const Model& model);

/// Whether each mass belongs to a ragdoll.
std::vector<bool> in_ragdoll(const Model& model);

/// Whether a contact point is a single mass that touches no other body and keeps no memory of where it
/// sticks.
bool is_plain(const ContactPoint& point);

/// The half-space that a collider is, where it is one that stays and gives nothing back: ground; else null.
const HalfSpace* as_ground(const Collider& collider);

/// Whether all there is to touch are half-spaces that stay and give nothing back, and all that touches them
/// are single masses: what methods that know only the ground can do.
bool touches_only_ground(const Model& model);

/// A link by its masses, for people: "rope.1 – rope.2".
std::string link_name(const Model& model, std::size_t link);

/// Every link that has at least one free end.
std::vector<Index> links_with_a_free_end(const Model& model);

/// The links that a method solves: every one that has at least one free end and acts both ways.
std::vector<Index> solvable_links(const Model& model);

/// Whether there are links that are one-sided, and limits on angles, which are limits of the other kinds.
bool has_one_sided_links(const Model& model);
bool limits_angles(const Model& model);

/// Whether a limit holds nothing, because its link is broken.
bool let_go(const Limit& limit, const State& state);

}  // namespace taut
