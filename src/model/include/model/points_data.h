#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/vectors.h"

namespace taut {

/// Masses and links as they are read from tables and placed in a scene. What a row leaves open is absent.
struct PointsData {
  struct Mass {
    std::string name;                ///< in the table; else its number, from 0
    Vec3 position = Vec3::Zero();    ///< m
    Vec3 velocity = Vec3::Zero();    ///< m/s
    std::optional<double> mass{};    ///< kg
    std::optional<double> radius{};  ///< m
    bool pinned = false;
  };
  struct Link {
    Index a = 0, b = 0;              ///< numbers of masses
    std::optional<double> length{};  ///< m; absent: the distance at the start
    std::optional<double> stiffness{}, damping{}, break_stretch{}, break_tension{};
  };
  std::vector<Mass> masses;
  std::vector<Link> links;
};

}  // namespace taut
