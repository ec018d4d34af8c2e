#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "model/body_specs.h"
#include "model/joint_specs.h"
#include "model/model.h"
#include "model/solid_specs.h"
#include "model/state.h"

namespace taut {

/// What is nearer to 0 can't be divided by: squares of it are lost, and one over it may be infinite. In any
/// unit.
inline constexpr double smallest_divisor = 1e-100;

// A scene's physics as a person writes it: names instead of indices, whole chains and sheets instead of
// masses. Every number is SI, but angles are in degrees. build() turns it into a Model and the State at the
// start.

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
