#pragma once

#include <array>
#include <optional>

#include "base/vectors.h"

namespace taut {

/// What must hold at the end of a scene's run; each part only where the scene states it.
struct Expectation {
  std::optional<double> max_strain;  ///< largest |strain| of any whole link at the end
  std::optional<double>
      energy_drift;  ///< |energy − work − energy at the start| at the end, share of the energy scale
  std::optional<std::array<double, 2>> broken_links;  ///< least and most links broken at the end
  std::optional<std::array<double, 2>>
      sag;                        ///< m, lowest mass below the lowest pin at the end: least and most
  std::optional<double> at_rest;  ///< m/s, fastest mass at the end
  std::optional<std::array<Vec3, 2>> inside;  ///< m, corners of a box that holds every mass at the end
  std::optional<double> limit_excess;         ///< degrees, farthest beyond a limit at the end
  std::optional<double> penetration;          ///< m, deepest inside a collider or the ground at the end
  std::optional<double> tangled;              ///< most places where faces go through faces at the end
};

}  // namespace taut
