#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "measure/stability.h"
#include "measure/stability_edge.h"
#include "measure/stability_limit.h"
#include "measure/stability_variant.h"

namespace taut {

/// What a map is made of, the same for all methods.
struct MapGrid {
  const MapAxes* axes = nullptr;
  std::vector<double> columns;  ///< values of what the columns stand for
  std::vector<double> rows;     ///< steps (s) or passes, rising
  double duration = 0.5;        ///< s, of every run; never fewer than 100 steps
};

/// What a column of a map needs to know of its scene beforehand: where the masses ought to be at the end, and
/// what its links bear.
struct ColumnTruth {
  std::optional<State> reference;
  std::string no_reference;  ///< why there is none
  std::optional<std::vector<double>> tensions;
};

/// One column of one method's map.
struct MapColumn {
  double value = 0.0;
  std::vector<RunOutcome> cells;  ///< one a row; empty where the method can't do the scene
  std::string refusal;            ///< why not
  /// The longest step that holds like all shorter ones, to 2 %; or the fewest passes that shrink a stretch
  /// 1000 times. Nothing where the whole column holds or none of it.
  std::optional<Edge> edge;
  std::optional<Prediction> predicted;
};

/// A certified reference (to 10⁻⁵ of the total link length, else to 10⁻³) and the largest tensions.
ColumnTruth column_truth(const Built& variant, double duration);

/// Runs one column: every row, then the edge between them. `given` are the method's parameters beside step or
/// passes. Errors are over the total link length. Nothing when told to stop on the way.
std::optional<MapColumn> map_column(const MapGrid& grid, double value, const Built& variant,
                                    const ColumnTruth& truth, const Settings& given,
                                    const std::function<bool()>& stop = {});

}  // namespace taut
