#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "frames/simulation.h"
#include "host/machine.h"
#include "host/progress.h"
#include "host/shard.h"
#include "measure/work_precision.h"
#include "scene/scene.h"
#include "study/timed_runs.h"

namespace taut {

/// What is to be charted of a scene.
struct ChartRequest {
  std::vector<std::string> methods;  ///< empty: all
  std::vector<ErrorKind> errors;  ///< empty: trajectory, strain and energy, where no motion can be certified
                                  ///< sag, too, and no trajectory where no two methods agree on it
  std::optional<double> horizon;  ///< s
  double budget = 60.0;  ///< s; no single run takes more than about one in two hundred parts of it, or, where
                         ///< that is more, 512 times what 60 steps per second take
  bool overwrite = false;
  Shard shard;  ///< which part of the curves
};

/// A point of the grid, run, judged and timed.
struct ChartCase {
  GridPoint point;
  Settings settings;
  JudgedRun run;
  RunTimes times;  ///< empty when the run diverged

  /// The least processor time of its runs (s): what a chart shows.
  double seconds() const;
};

/// A chart's data.
struct Chart {
  std::string scene, title;
  std::size_t masses = 0, links = 0;
  double size = 0.0;          ///< m, scene_size()
  double energy_scale = 0.0;  ///< J
  Truth truth;
  std::vector<ErrorKind> errors;
  std::vector<MethodVariant> curves;
  std::vector<std::string> omissions;
  std::vector<ChartCase> cases;  ///< in the order in which they were run
  GridWalk::Counts counts;
  double budget = 0.0;  ///< s
  Machine machine;
  bool stopped = false;  ///< told to stop; running again goes on

  bool complete() const { return counts.open == 0; }
};

/// Measures a scene's chart, saving every case in `store` as it comes; what is there from the same inputs is
/// not run again. Stops when told to, or when the budget is spent (what is missing is then `counts.open`).
/// Throws BadRequest for methods that do not exist or errors that can't be judged, OutputConflict,
/// RunFailure, and Interrupted when told to stop before the truth is known.
Chart measure_chart(const Scene& scene, const ChartRequest& request, const std::filesystem::path& store,
                    Progress& progress, const StopTest& stop = {});

}  // namespace taut
