#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "frames/simulation.h"
#include "host/progress.h"
#include "host/shard.h"
#include "measure/stability_column.h"
#include "scene/scene.h"
#include "study/case_store.h"

namespace taut {

/// A method with parameters that differ from the scene's or the defaults.
struct MapMethod {
  std::string label;  ///< as on the command line: xpbd, or xpbd:precision=single
  Settings settings;  ///< method, and the parameters that are given
};

/// What a text such as xpbd:precision=single:passes=4 means. Throws BadRequest for a name, parameter or value
/// that is none.
MapMethod parse_map_method(const std::string& text);

/// Which maps are to be made of a scene, and how.
struct StabilityRequest {
  std::vector<MapMethod> methods;
  MapGrid grid;
  Shard shard;
  bool overwrite = false;
  bool run = true;  ///< false: only what is there already, whatever build has made it; changes no file
};

/// The map of one method, as far as its columns are there.
struct MethodMap {
  std::string method;              ///< its label
  std::vector<MapColumn> columns;  ///< rising values
};

struct StabilityMaps {
  MapGrid grid;
  std::vector<MethodMap> maps;  ///< in the order of the request
  CaseCount count;              ///< of columns, over all methods (of this shard)
  bool stopped = false;
};

/// The grid of a map over these axes with at most so many columns and rows (fewer where whole
/// numbers repeat). The duration is the scene's, at most `longest` (s).
MapGrid make_map_grid(const Scene& scene, const MapAxes& axes, int columns, int rows, double longest);

/// Throws BadRequest where the scene can't be varied as the axes ask; writes nothing.
void check_map_request(const Scene& scene, const StabilityRequest& request);

/// Runs the columns that the folder does not hold yet, on every processor, and saves each as it is done. What
/// shards have left in the folder is taken over. Results do not depend on the number of processors, on shards
/// or on interruptions. Throws OutputConflict where the folder holds cases of other inputs, BadRequest where
/// the scene has not what the axes ask for.
StabilityMaps make_stability_maps(const Scene& scene, const StabilityRequest& request,
                                  const std::filesystem::path& folder, Progress& progress,
                                  const StopTest& stop = {});

}  // namespace taut
