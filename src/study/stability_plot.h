#pragma once

#include <string>

#include "output/gnuplot.h"
#include "study/stability_map.h"

namespace taut {

/// What stands above maps: a title, and a line below it.
struct MapHeading {
  std::string title, subtitle;
};

/// One method's map: an image of the error, hatched where the run diverged or was refused, the measured edge
/// as circles and the predicted one as a line over it, with its formula.
PlotScript map_plot(const StabilityMaps& maps, const MethodMap& map, const MapHeading& heading);

/// All methods' maps side by side on one page.
PlotScript overview_plot(const StabilityMaps& maps, const MapHeading& heading);

}  // namespace taut
