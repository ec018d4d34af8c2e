#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/mesh_data.h"
#include "model/model.h"
#include "model/points_data.h"
#include "model/solid_data.h"
#include "model/state.h"

namespace taut {

/// What is nearer to 0 can't be divided by: squares of it are lost, and one over it may be infinite. In any
/// unit.
inline constexpr double smallest_divisor = 1e-100;

// A scene's physics as a person writes it: names instead of indices, whole chains and sheets instead of
// masses. Every number is SI, but angles are in degrees. build() turns it into a Model and the State at the
// start.

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

struct SinusoidSpec {
  Vec3 amplitude = Vec3::Zero();   ///< m
  double angular_frequency = 0.0;  ///< rad/s
  double phase = 0.0;              ///< rad

  bool operator==(const SinusoidSpec&) const = default;
};

/// How a solid is moved: one of the two, or neither.
struct WaySpec {
  std::optional<SinusoidSpec> sinusoid;
  std::vector<Knot> path;

  bool empty() const { return !sinusoid && path.empty(); }
};

/// How a pin is driven: one of them, or none.
struct MotionSpec {
  std::optional<SinusoidSpec> sinusoid{};
  std::vector<Knot> path{};
  std::string with{};  ///< the name of a solid that carries it

  bool given() const { return sinusoid || !path.empty() || !with.empty(); }
};

/// How a solid turns about an axis: through angles at times, or at a rate.
struct RotationSpec {
  Vec3 axis = Vec3::Zero();                  ///< of any length but 0
  std::optional<Vec3> through;               ///< m, a point of the axis; absent: the solid's centre
  std::vector<std::array<double, 2>> angle;  ///< (s, degrees)
  std::optional<double> rate;                ///< degrees/s
  double rise = 0.0;                         ///< s, in which the rate is reached
};

/// How a solid moves, where it does.
struct SolidMotionSpec {
  std::string name;  ///< for pins that it carries; may be empty
  WaySpec motion;
  std::optional<RotationSpec> rotation;
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

/// Which axis of a mesh file points upwards.
enum class UpAxis : std::uint8_t { y, z };

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

struct LoadSpec {
  std::vector<std::string> masses;        ///< names; a part between dots may be *
  Vec3 force = Vec3::Zero();              ///< N on each
  double from = 0.0, to = 0.0;            ///< s
  std::optional<double> until{}, gone{};  ///< s; stays where there is no until
};

/// Where a chain or a sheet is to give way: links between two sets of masses, or across a line of a sheet.
struct SeamSpec {
  std::vector<std::string> a, b;   ///< names; a part between dots may be *
  std::string sheet;               ///< in place of them: its name, and
  std::optional<int> row, column;  ///< the row or column beyond which the seam lies
  std::optional<double> strength;  ///< share of the thresholds that the links have otherwise
  std::optional<double> break_stretch, break_tension, break_at;  ///< in place of those: × length, N, s
};

struct PlaneSpec {
  Vec3 point = Vec3::Zero();    ///< m
  Vec3 normal = Vec3::UnitY();  ///< any length but 0
  double friction = 0.5;
  double restitution = 0.0;  ///< 0 to 1
  SolidMotionSpec moves{};
};

struct SphereSpec {
  Vec3 centre = Vec3::Zero();  ///< m
  double radius = 1.0;         ///< m
  double friction = 0.5;
  double restitution = 0.0;  ///< 0 to 1
  SolidMotionSpec moves{};
};

/// Everything within a radius of the line from `from` to `to`.
struct CapsuleSpec {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  ///< m
  double radius = 1.0;                          ///< m
  double friction = 0.5;
  double restitution = 0.0;  ///< 0 to 1
  SolidMotionSpec moves{};
};

struct BoxSpec {
  Vec3 centre = Vec3::Zero();  ///< m
  Vec3 size = Vec3::Ones();    ///< m, whole edges
  Vec3 turn = Vec3::Zero();    ///< degrees about x, then y, then z
  double friction = 0.5;
  double restitution = 0.0;  ///< 0 to 1
  SolidMotionSpec moves{};
};

/// What a closed surface of triangles, quads and polygons out of a file holds.
struct MeshSolidSpec {
  std::string file;       ///< relative to the folder of the scene
  std::string content{};  ///< the hash that the file must have; empty: any
  double scale = 1.0;     ///< m for 1 in the file
  UpAxis up = UpAxis::y;
  Vec3 position = Vec3::Zero();  ///< m, where the file's origin goes
  Vec3 turn = Vec3::Zero();      ///< degrees about x, then y, then z, through it
  std::optional<double> weld{};  ///< m, corners as near as that are one; absent: a millionth of its size
  double friction = 0.5;
  double restitution = 0.0;  ///< 0 to 1
  SolidMotionSpec moves{};
  std::shared_ptr<const SolidData> data{};  ///< what is in the file, placed; set by whoever reads files
};

/// A range for the angle at the second of three masses.
struct AngleSpec {
  std::vector<std::string> masses;  ///< three names
  double min = 0.0, max = 180.0;    ///< degrees
  double compliance = 0.0;          ///< rad/(N m)
};

/// A range for how far the third mass is turned on from straight, about an axis from one mass to another.
struct HingeSpec {
  std::vector<std::string> masses;   ///< three names
  std::vector<std::string> axis;     ///< two names
  double min = -180.0, max = 180.0;  ///< degrees, right-handed about the axis, 0: straight
  double compliance = 0.0;           ///< rad/(N m)
};

/// A half-angle for a limb about an axis that is fixed in the frame of three masses.
struct ConeSpec {
  std::vector<std::string> frame;  ///< three names
  std::vector<std::string> limb;   ///< from the first to the second, or to the middle of the second and third
  Vec3 axis = Vec3::UnitY();       ///< as it points at the start
  double half_angle = 90.0;        ///< degrees
  double compliance = 0.0;         ///< rad/(N m)
};

/// The angles of a ragdoll's joints at the start, in degrees. Bends are about the body's right-hand axis: a
/// limb that hangs swings forward by a positive one. "out" is sideways, away from the body.
struct PoseSpec {
  double neck = 0.0;
  double left_shoulder = 0.0, right_shoulder = 0.0;
  double left_shoulder_out = 10.0, right_shoulder_out = 10.0;
  double left_elbow = 10.0, right_elbow = 10.0;
  double left_hip = 5.0, right_hip = 5.0;
  double left_hip_out = 4.0, right_hip_out = 4.0;
  double left_knee = -8.0, right_knee = -8.0;
};

/// Ranges of a ragdoll's joints in degrees: [least, most] of hinges, half-angles of cones.
struct RangeSpec {
  std::array<double, 2> neck{-54.0, 18.0};
  std::array<double, 2> elbow{1.8, 90.0};
  std::array<double, 2> knee{-90.0, -3.6};
  double shoulder = 76.5;
  double hip = 40.5;
  double hip_twist = 50.0;
  double wrist = 60.0;
  double ankle = 35.0;
};

/// The parts a ragdoll can be held by.
inline constexpr std::array<std::string_view, 5> ragdoll_handles{"left_hand", "right_hand", "left_foot",
                                                                 "right_foot", "head"};

/// A body of a given height and mass, its segments by Winter's table.
struct RagdollSpec {
  std::string name;
  double height = 1.75;          ///< m
  double mass = 75.0;            ///< kg
  Vec3 position = Vec3::Zero();  ///< m, of the middle of the hips at the start
  Vec3 turn = Vec3::Zero();      ///< degrees about x, then y, then z; unturned it stands and looks along +z
  Vec3 velocity = Vec3::Zero();  ///< m/s
  Vec3 spin = Vec3::Zero();      ///< rad/s, about its centre of mass
  PoseSpec pose;
  RangeSpec ranges;
  double joint_damping = 0.0;   ///< 1/s: each joint's damping over the moment of inertia, about the joint, of
                                ///< all that is beyond it, stretched out
  double joint_friction = 0.0;  ///< share of the torque that holds all that is beyond a joint out level
                                ///< against 9.81 m/s²
  std::vector<std::string> pinned;  ///< out of ragdoll_handles
  bool collides = false;            ///< whether it touches other bodies that do so
};

/// Air that blows on sheets and meshes; see Wind. None where the velocity is zero.
struct WindSpec {
  Vec3 velocity = Vec3::Zero();  ///< m/s
  double gust = 0.0;             ///< share of the velocity
  double gust_time = 1.0;        ///< s
  int seed = 1;
  double density = 1.2;  ///< kg/m³
  double drag_coefficient = 1.2;
};

struct Description {
  Vec3 gravity{0.0, -9.81, 0.0};  ///< m/s²
  double drag = 0.0;              ///< 1/s
  std::vector<MassSpec> masses;
  std::vector<LinkSpec> links;
  std::vector<TieSpec> ties;
  std::vector<ChainSpec> chains;
  std::vector<SheetSpec> sheets;
  std::vector<MeshSpec> meshes;
  std::vector<PointsSpec> points;
  std::vector<LoadSpec> loads;
  std::vector<SeamSpec> seams;
  std::vector<PlaneSpec> planes;
  std::vector<SphereSpec> spheres;
  std::vector<CapsuleSpec> capsules;
  std::vector<BoxSpec> boxes;
  std::vector<MeshSolidSpec> mesh_solids;
  std::vector<AngleSpec> angles;
  std::vector<HingeSpec> hinges;
  std::vector<ConeSpec> cones;
  std::vector<RagdollSpec> ragdolls;
  std::optional<WindSpec> wind;  ///< air, which may be still; absent: a vacuum
};

/// Something wrong with one entry of a Description, in the words of the scene format.
struct Problem {
  std::string section;    ///< that of the entry, such as "mass" or "world"
  std::size_t index = 0;  ///< which of that section's entries
  std::string key;        ///< which key of it; empty: the entry as a whole
  std::string message;
  std::string suggestion;  ///< nearest right name; may be empty
};

struct Built {
  Model model;
  State start;
  std::vector<Problem> problems;  ///< when not empty, model and start are not to be used
  std::vector<Problem> notes{};   ///< what is allowed but seldom meant; none where there are problems
  bool names_known = false;       ///< the names of the model's masses are right, whatever the problems
};

/// Validates a description and builds its model and the state at t = 0. Masses come in the order chains,
/// sheets, meshes, points, ragdolls, masses; links in the order chains, sheets, meshes, points, ragdolls,
/// links, ties. All problems are reported at once.
Built build(const Description& description);

/// What can be said of a description whose masses are not those that were meant, but for their names:
/// problems within entries, and names that no mass has.
Built build_names(const Description& description);

}  // namespace taut
