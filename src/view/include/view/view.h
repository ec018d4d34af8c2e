#pragma once

#include <array>
#include <optional>
#include <string>

#include "base/vectors.h"

namespace taut {

/// Red, green, blue, each 0 to 1 as on a display (sRGB).
using Colour = std::array<double, 3>;

/// What links (masses for speed, joints for limit) are coloured by. limit: how near a joint is to a stop, 1
/// at it.
enum class ColourBy { plain, strain, tension, speed, limit };

/// How masses are drawn; boxes show how each has turned.
enum class MassShape { sphere, box };

enum class Theme { light, dark };

/// How the cloth surface is painted.
enum class Pattern { plain, checker, woven };

/// What is drawn and how.
struct Look {
  bool masses = true;
  bool links = true;
  bool surface = false;  ///< the triangles of sheets
  bool ground = true;    ///< the scene's planes, or without any a level place with grid lines
  bool shadows = true;
  bool bones = true;      ///< bodies as capsules, in place of their masses and links
  bool colliders = true;  ///< solids, but for planes
  Theme theme = Theme::light;
  ColourBy colour_by = ColourBy::plain;
  double colour_range =
      0.0;  ///< value at the top of the colour scale (strain: 1, tension: N, speed: m/s); 0: from the frame
  std::optional<double> ground_height;  ///< m, upwards; left out: the plane's own, or 0 without any
  double mass_radius = 0.0;             ///< m; 0: 0.29 of the median link length
  double link_radius = 0.0;             ///< m; 0: 0.42 of the mass radius
  Colour mass_colour{0.80, 0.55, 0.20};
  Colour pin_colour{0.75, 0.15, 0.15};
  Colour link_colour{0.32, 0.36, 0.42};
  Colour surface_colour{0.55, 0.12, 0.16};
  Colour surface_back_colour{0.42, 0.10, 0.13};
  Pattern pattern = Pattern::plain;
  MassShape mass_shape = MassShape::sphere;
  Colour bone_colour{0.86, 0.74, 0.60};
  Colour collider_colour{0.62, 0.64, 0.67};
};

/// Where the picture is taken from.
struct Camera {
  Vec3 eye{0.0, 1.0, 5.0};      ///< m
  Vec3 target{0.0, 1.0, 0.0};   ///< m
  double field_of_view = 38.0;  ///< degrees, vertical
  std::optional<Vec3> up =
      std::nullopt;    ///< any length but 0; left out: against gravity, or y where there is none
  double orbit = 0.0;  ///< degrees per second about the vertical through the target
  std::string follow;  ///< name of a mass: eye and target move along with it, as far as it has moved since
                       ///< the start; empty: stay
};

}  // namespace taut
