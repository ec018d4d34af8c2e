#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/vectors.h"
#include "model/mesh_data.h"
#include "model/motion_specs.h"
#include "model/points_data.h"

namespace taut {

// What masses and links are made of, as a person writes it; see description.h.

/// Where a link acts: below and above its length; above it alone, as a rope does; below it alone, as a buffer
/// does; or below its length and above its longest, and not between them.
enum class LinkAction : std::uint8_t { both, pull, push, between };

/// What links made together share.
struct LinkProperties {
  std::optional<double> stiffness;      ///< N/m; rigid when absent
  double damping = 0.0;                 ///< N s/m
  std::optional<double> break_stretch;  ///< × length, > 1
  std::optional<double> break_tension;  ///< N
  LinkAction acts = LinkAction::both;
  std::optional<double> longest{};   ///< × length, > 1: of links that act "between"
  std::optional<double> break_at{};  ///< s
  double scatter = 0.0;              ///< share, up to which thresholds differ from link to link
  int scatter_seed = 1;
};

/// How a chain resists being bent.
struct BendingSpec {
  double stiffness = 0.0;   ///< N m/rad, of each inner mass
  bool from_start = false;  ///< rests as it starts, else straight
};

/// How a sheet does, along its columns (warp), its rows (weft) and its diagonals (bias).
struct SheetBendingSpec {
  double stiffness = 0.0;            ///< N m/rad, of each inner mass along warp and weft
  std::optional<double> warp, weft;  ///< N m/rad, in place of it
  double bias = 0.0;                 ///< N m/rad
  bool from_start = false;           ///< rests as it starts, else flat
};

struct MassSpec {
  std::string name;
  Vec3 position = Vec3::Zero();  ///< m
  Vec3 velocity = Vec3::Zero();  ///< m/s; ignored when pinned
  double mass = 1.0;             ///< kg; ignored when pinned
  bool pinned = false;
  MotionSpec motion;                ///< only for pinned masses
  double radius = 0.0;              ///< m, of contact with colliders
  bool collides = false;            ///< whether it touches other bodies that do so
  std::optional<double> release{};  ///< s, when its pin lets go of it
};

struct LinkSpec {
  std::string a, b;              ///< names of masses
  std::optional<double> length;  ///< m; the distance at the start when absent
  LinkProperties properties;
};

/// How a chain is wound around a solid of its scene, touching it.
struct WindingSpec {
  std::string around;             ///< its name, or section and number, from 0: "sphere.0", "capsule.1"
  double turns = 5.0;             ///< right-handed about the axis; below 0 the other way
  double start = 0.1, end = 0.9;  ///< shares of the solid's length along its axis
  Vec3 axis = Vec3::UnitY();      ///< of a sphere; a capsule has its own
};

/// A row of links + 1 equal masses, named <name>.0 … <name>.<links>: straight, or along points, or wound.
struct ChainSpec {
  std::string name;
  Vec3 from = Vec3::Zero();    ///< m, of a straight one
  Vec3 to = Vec3::Zero();      ///< m, of a straight one
  std::vector<Vec3> points{};  ///< m, along which it is laid, with links of one length
  bool smooth = false;         ///< along a smooth curve through them, else straight from each to the next
  std::optional<WindingSpec> wound = std::nullopt;
  int links = 1;
  double length = 0.0;  ///< m, of a straight one; 0: |to − from|. Longer: starts as a circular arc that sags
                        ///< along gravity; shorter: starts stretched
  double mass = 1.0;                     ///< kg, of the whole, shared equally
  double last_mass = 0.0;                ///< kg; 0: the same as the others
  std::vector<std::string> pinned;       ///< "first", "last"
  MotionSpec first_motion, last_motion;  ///< only for ends that are pinned
  LinkProperties properties;
  double radius = 0.0;                                    ///< m, of every mass, for contact
  bool collides = false;                                  ///< whether it touches other bodies that do so
  std::optional<double> first_release{}, last_release{};  ///< s, when the pins of the ends let go
  std::optional<BendingSpec> bending{};

  bool straight() const { return points.empty() && !wound; }
};

/// One more family of links in a sheet, with properties of its own.
using ExtraLinks = std::optional<LinkProperties>;

/// Pins at every n-th mass of a sheet's top edge, as the hooks of a curtain on its rail.
struct HookSpec {
  int every = 0;  ///< columns between hooks; 0: no hooks. Divides columns − 1
  std::vector<std::array<double, 2>>
      draw;  ///< (s, share of the rail's length the hooks span), from the rail's start; empty: at rest
};

/// How a sheet's faces touch, beside its masses.
struct FacesSpec {
  double thickness = 0.0;     ///< m: faces keep this far from one another, half of it from solids
  double friction = 0.5;      ///< Coulomb's coefficient, on other faces
  bool self_collides = true;  ///< whether they touch one another
};

/// A rectangular net of rows × columns equal masses, named <name>.<row>.<column>, row 0 on top.
struct SheetSpec {
  std::string name;
  int rows = 2, columns = 2;
  Vec3 from = Vec3::Zero();  ///< m, top edge's start: mass 0.0
  Vec3 to = Vec3::Zero();    ///< m, top edge's end
  Vec3 down = Vec3::Zero();  ///< m, from the top edge to the bottom one
  double mass = 1.0;         ///< kg, of the whole, shared equally
  double fullness =
      1.0;  ///< ≥ 1, cloth width ÷ rail width (|to − from|); the surplus lies in pleats between the hooks
  HookSpec hooks;
  std::vector<std::string>
      pinned;  ///< "top", "bottom", "left", "right", "top-left", "top-right", "bottom-left", "bottom-right"
  /// Of all masses of an edge that is pinned, alike; a path says where its first mass is, which is that of
  /// the lowest row and column.
  MotionSpec top_motion, bottom_motion, left_motion, right_motion;
  LinkProperties properties;        ///< of the links along rows and columns
  ExtraLinks diagonals;             ///< both diagonals of every cell
  ExtraLinks skip_one;              ///< from every mass to the next but one along rows and columns
  double radius = 0.0;              ///< m, of every mass, for contact
  bool collides = false;            ///< whether it touches other bodies that do so
  ExtraLinks weft{};                ///< of the links along rows, in place of `properties`
  std::optional<double> release{};  ///< s, when all of its pins let go
  std::optional<SheetBendingSpec> bending{};
  std::optional<FacesSpec> faces{};  ///< absent: only its masses touch, as balls
};

/// How a mesh's mass is shared: a third of each face's to each of its corners, faces weighing as they are
/// large, or the same for all.
enum class MassShares : std::uint8_t { area, equal };

/// A surface of triangles, quads and polygons out of a file as cloth: corners are masses, named <name>.0 …,
/// edges are links.
struct MeshSpec {
  std::string name;
  std::string file;                      ///< relative to the folder of the scene
  std::string content{};                 ///< the hash that the file must have; empty: any
  double mass = 1.0;                     ///< kg, of the whole
  MassShares shares = MassShares::area;  ///< of its masses in that
  double scale = 1.0;                    ///< m for 1 in the file
  UpAxis up = UpAxis::y;
  Vec3 position = Vec3::Zero();       ///< m, where the file's origin goes
  Vec3 turn = Vec3::Zero();           ///< degrees about x, then y, then z, through it
  std::optional<double> weld{};       ///< m, corners as near as that are one; absent: a millionth of its size
  std::vector<std::string> pinned{};  ///< names of groups or materials
  std::optional<std::array<Vec3, 2>> pinned_box{};  ///< m, corners of a box, and what starts in it is pinned
  std::vector<int> pinned_masses{};                 ///< by their numbers
  MotionSpec motion{};              ///< of all pins alike; a path is that of the one of the lowest number
  std::optional<double> release{};  ///< s, when all of its pins let go
  LinkProperties properties{};      ///< of the links along edges
  ExtraLinks diagonals{};           ///< both diagonals of every face with four corners
  ExtraLinks skip_one{};            ///< across every edge between two triangles, and over a mass among quads
  double radius = 0.0;              ///< m, of every mass, for contact
  bool collides = false;            ///< whether it touches other bodies that do so
  std::optional<BendingSpec> bending{};
  std::optional<FacesSpec> faces{};        ///< absent: only its masses touch, as balls
  std::shared_ptr<const MeshData> data{};  ///< what is in the file, placed; set by whoever reads files
};

/// Masses and links out of tables, named <name>.<row>, from 0, or <name>.<name in the table>.
struct PointsSpec {
  std::string name;
  std::string masses, links;                 ///< files, relative to the folder of the scene; no links: empty
  std::string content{};                     ///< the hash that they must have together; empty: any
  Vec3 position = Vec3::Zero();              ///< m, where the tables' origin goes
  Vec3 turn = Vec3::Zero();                  ///< degrees about x, then y, then z, through it
  double mass = 1.0;                         ///< kg, of each mass that has none of its own
  std::vector<std::string> pinned{};         ///< names of the table, or numbers of rows
  LinkProperties properties{};               ///< of links, where the table has none
  double radius = 0.0;                       ///< m, of each mass that has none of its own, for contact
  bool collides = false;                     ///< whether they touch other bodies that do so
  std::shared_ptr<const PointsData> data{};  ///< what is in the tables, placed; set by whoever reads files
};

/// Links from each of some masses to the nearest one of others, each as long as they are apart at the start.
struct TieSpec {
  std::string a, b;  ///< names; a part between dots may be *
  int every = 1;     ///< of those that a names only every n-th; divides their number − 1
  LinkProperties properties;
};

}  // namespace taut
