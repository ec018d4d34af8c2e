#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "methods/method.h"
#include "model/description.h"

namespace taut {

/// What changes along a stability map: what its columns stand for, and what its rows do.
enum class MapColumns { mass_ratio, stiffness, links, gravity };
enum class MapRows { step, passes };

struct MapAxes {
  std::string_view name;  ///< as on the command line: step,mass-ratio
  MapRows rows;
  MapColumns columns;
  std::string_view title;  ///< of the columns' axis, with its unit
  double least, most;      ///< of the columns
  bool whole;              ///< only whole numbers
};

/// Every pair of axes there is.
const std::array<MapAxes, 5>& all_map_axes();

/// The axes of that name. Throws BadRequest, naming the nearest ones.
const MapAxes& find_map_axes(std::string_view name);

/// `count` values from `least` to `most` at equal ratios; where they must be whole, each once.
std::vector<double> spread_values(double least, double most, int count, bool whole);

/// One column's scene: a description with the column's value put in, built.
///  mass ratio: the last free mass of the scene gets that many times the mean of the other free ones;
///  stiffness (N/m): every link gets it;
///  links: the scene's one chain gets so many of the same length each;
///  gravity (m/s²): its size, along the direction it had.
/// A method that knows no rigid links gets, in their place, springs that the whole weight stretches by 1 %.
/// Throws BadRequest where the scene has not what the columns stand for, or can't be built with it.
Built map_variant(const Description& description, MapColumns columns, double value, const Method& method);

}  // namespace taut
