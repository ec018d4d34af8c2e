#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.h"
#include "model/state.h"

namespace taut {

// A scene's physics as a person writes it: names instead of indices, whole chains and sheets instead of
// masses. Every number is SI. build() turns it into a Model and the State at the start.

/// What links made together share.
struct LinkProperties {
  std::optional<double> stiffness;      ///< N/m; rigid when absent
  double damping = 0.0;                 ///< N s/m
  std::optional<double> break_stretch;  ///< × length, > 1
  std::optional<double> break_tension;  ///< N
};

struct SinusoidSpec {
  Vec3 amplitude = Vec3::Zero();   ///< m
  double angular_frequency = 0.0;  ///< rad/s
  double phase = 0.0;              ///< rad
};

/// How a pin is driven: one of the two, or neither.
struct MotionSpec {
  std::optional<SinusoidSpec> sinusoid;
  std::vector<Knot> path;
};

struct MassSpec {
  std::string name;
  Vec3 position = Vec3::Zero();  ///< m
  Vec3 velocity = Vec3::Zero();  ///< m/s; ignored when pinned
  double mass = 1.0;             ///< kg; ignored when pinned
  bool pinned = false;
  MotionSpec motion;  ///< only for pinned masses
};

struct LinkSpec {
  std::string a, b;              ///< names of masses
  std::optional<double> length;  ///< m; the distance at the start when absent
  LinkProperties properties;
};

/// A straight row of links + 1 equal masses, named <name>.0 … <name>.<links>.
struct ChainSpec {
  std::string name;
  Vec3 from = Vec3::Zero();  ///< m
  Vec3 to = Vec3::Zero();    ///< m
  int links = 1;
  double length = 0.0;  ///< m, of the whole; 0: |to − from|. Longer: starts as a circular arc that sags along
                        ///< gravity; shorter: starts stretched
  double mass = 1.0;                     ///< kg, of the whole, shared equally
  double last_mass = 0.0;                ///< kg; 0: the same as the others
  std::vector<std::string> pinned;       ///< "first", "last"
  MotionSpec first_motion, last_motion;  ///< only for ends that are pinned
  LinkProperties properties;
};

/// One more family of links in a sheet, with properties of its own.
using ExtraLinks = std::optional<LinkProperties>;

/// Pins at every n-th mass of a sheet's top edge, as the hooks of a curtain on its rail.
struct HookSpec {
  int every = 0;  ///< columns between hooks; 0: no hooks. Divides columns − 1
  std::vector<std::array<double, 2>>
      draw;  ///< (s, share of the rail's length the hooks span), from the rail's start; empty: at rest
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
  LinkProperties properties;  ///< of the links along rows and columns
  ExtraLinks diagonals;       ///< both diagonals of every cell
  ExtraLinks skip_one;        ///< from every mass to the next but one along rows and columns
};

struct LoadSpec {
  std::vector<std::string> masses;  ///< names; a part between dots may be *
  Vec3 force = Vec3::Zero();        ///< N on each
  double from = 0.0, to = 0.0;      ///< s
};

struct PlaneSpec {
  Vec3 point = Vec3::Zero();    ///< m
  Vec3 normal = Vec3::UnitY();  ///< any length but 0
  double friction = 0.5;
};

struct Description {
  Vec3 gravity{0.0, -9.81, 0.0};  ///< m/s²
  double drag = 0.0;              ///< 1/s
  std::vector<MassSpec> masses;
  std::vector<LinkSpec> links;
  std::vector<ChainSpec> chains;
  std::vector<SheetSpec> sheets;
  std::vector<LoadSpec> loads;
  std::vector<PlaneSpec> planes;
};

/// Something wrong with one entry of a Description, in the words of the scene format.
struct Problem {
  std::string section;    ///< "mass", "link", "chain", "sheet", "load", "plane" or "world"
  std::size_t index = 0;  ///< which of that section's entries
  std::string key;        ///< which key of it; empty: the entry as a whole
  std::string message;
  std::string suggestion;  ///< nearest right name; may be empty
};

struct Built {
  Model model;
  State start;
  std::vector<Problem> problems;  ///< when not empty, model and start are not to be used
};

/// Validates a description and builds its model and the state at t = 0. Masses come in the order chains,
/// sheets, masses; links in the order chains, sheets, links. All problems are reported at once.
Built build(const Description& description);

}  // namespace taut
