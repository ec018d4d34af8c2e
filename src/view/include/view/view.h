#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/vectors.h"

namespace taut {

/// Red, green, blue, each 0 to 1 as on a display (sRGB).
using Colour = std::array<double, 3>;

/// What links (masses for speed, joints for limit) are coloured by. limit: how near a joint is to a stop, 1
/// at it.
enum class ColourBy { plain, strain, tension, speed, limit };

/// How values are spread over the colours: evenly, or by their logarithm over three decades.
enum class ColourSteps { linear, log };

/// How masses are drawn; boxes show how each has turned.
enum class MassShape { sphere, box };

/// How links are drawn: as rods from mass to mass, as the rope or as the chain that they are a model of.
enum class LinkShape { rod, rope, chain };

enum class Theme { light, dark };

/// How the cloth surface is painted.
enum class Pattern { plain, checker, woven };

/// The families of links that a look may name; a sheet has all three.
inline constexpr std::array<std::string_view, 3> link_families{"structural", "diagonals", "skip_one"};

/// How many points a trail has of each second of a scene.
inline constexpr double trail_points_a_second = 300.0;

/// What an object may be drawn as; links and masses alone for chains, with `bones` for ragdolls and `surface`
/// for sheets.
inline constexpr std::array<std::string_view, 4> drawn_parts{"links", "masses", "surface", "bones"};

/// How one object is drawn, where that is not as the rest. It changes nothing but pictures.
struct ObjectLook {
  bool visible = true;
  std::optional<Colour> colour = std::nullopt;  ///< left out: the Look's for what it is
  std::optional<Colour> back_colour =
      std::nullopt;  ///< of a sheet; left out: darker than its own, or the Look's
  std::optional<std::vector<std::string>> draw =
      std::nullopt;  ///< out of drawn_parts; left out: as the Look says

  /// Whether anything of it is to be seen.
  bool shown() const { return visible && !(draw && draw->empty()); }
};

/// Those of a scene's objects, kind by kind in the order of the scene; what is beyond the end of a list is
/// drawn as the rest.
struct ObjectLooks {
  std::vector<ObjectLook> chains, sheets, meshes, points, ragdolls, masses, links, planes, spheres, capsules,
      boxes, mesh_solids;
};

/// What is drawn and how.
struct Look {
  bool masses = true;
  bool links = true;
  bool surface = false;  ///< the triangles of sheets
  bool ground = true;    ///< the scene's planes, or without any a level place with grid lines
  bool shadows = true;
  bool bones = true;      ///< ragdolls as bodies, in place of their masses and links
  bool colliders = true;  ///< solids, but for planes
  bool supports = true;   ///< what might hold the pins
  Theme theme = Theme::light;
  ColourBy colour_by = ColourBy::plain;
  ColourSteps colour_steps = ColourSteps::linear;
  double colour_range = 0.0;  ///< value at the top of the colour scale (strain: 1, tension: N, speed: m/s);
                              ///< 0: settled before anything is drawn (frames/settled_colours.h)
  std::optional<double> ground_height;  ///< m, upwards; left out: the plane's own, or 0 without any
  double mass_radius = 0.0;             ///< m; 0: 0.21 of the median link length
  double link_radius = 0.0;             ///< m; 0: 0.42 of the mass radius
  bool weights = true;  ///< masses without a radius of contact are larger and darker the heavier they are
                        ///< next to the median one
  LinkShape link_shape = LinkShape::rod;
  double chain_pitch = 0.0;                         ///< m from a chain's ring to the next; 0: a ring a link
  std::vector<std::string> families{"structural"};  ///< of links that are drawn, out of link_families
  bool loads = true;                                ///< loads as arrows
  bool exact = false;                               ///< the exact shape at rest, as a ghost
  std::vector<std::string> trails{};                ///< names of masses whose way so far is drawn
  double trail_time = 0.0;                          ///< s that a trail goes back; 0: to the start
  Colour mass_colour{0.80, 0.55, 0.20};
  Colour pin_colour{0.75, 0.15, 0.15};
  Colour link_colour{0.32, 0.36, 0.42};
  Colour surface_colour{0.55, 0.12, 0.16};
  Colour surface_back_colour{0.42, 0.10, 0.13};
  Pattern pattern = Pattern::plain;
  double thread_pitch = 0.0;        ///< m, between threads of the weave; 0: an eightieth of the shorter side
  std::optional<double> hem_width;  ///< m; 0: none; left out: 0.018 of the cloth's shorter side
  MassShape mass_shape = MassShape::sphere;
  /// From a time of the scene (s) on, how many of its seconds pass in one of the film; rising times. Before
  /// the first it is 1.
  std::vector<std::array<double, 2>> speed;
  Colour bone_colour{0.86, 0.74, 0.60};  ///< of one body; several have hues around it
  Colour collider_colour{0.62, 0.64, 0.67};
  ObjectLooks objects{};  ///< written with the objects themselves
};

/// Where the picture is taken from. What is left out is settled before anything is drawn, so that all of the
/// motion is in view (frames/settled_view.h).
struct Camera {
  std::optional<Vec3> eye = std::nullopt;     ///< m
  std::optional<Vec3> target = std::nullopt;  ///< m
  Vec3 direction{0.3, 0.12, 1.0};             ///< from what is shown towards an eye that is left out
  std::optional<std::array<Vec3, 2>> show =
      std::nullopt;             ///< m, corners of a box to keep in view; left out: where the masses will be
  double field_of_view = 38.0;  ///< degrees, vertical, in pictures as wide as 16:9 or wider
  std::optional<Vec3> up =
      std::nullopt;    ///< any length but 0; left out: against gravity, or y where there is none
  double orbit = 0.0;  ///< degrees per second about the vertical through the target
  std::string follow;  ///< name of a mass: eye and target move along with it, as far as it has moved since
                       ///< the start; empty: stay
};

}  // namespace taut
