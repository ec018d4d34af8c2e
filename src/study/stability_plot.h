#pragma once

#include <string>

#include "output/gnuplot.h"
#include "study/stability_map.h"

namespace taut {

/// One method's map: colour for the error, hatched where the run diverged, the measured edge as circles and
/// the predicted one as a line over it.
PlotScript map_plot(const StabilityMaps& maps, const MethodMap& map, const std::string& title);

/// All methods' maps side by side on one page.
PlotScript overview_plot(const StabilityMaps& maps, const std::string& title);

}  // namespace taut
