#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "frames/simulation.h"
#include "scene/scene.h"

namespace taut {

/// What one way of running a scene has come to at a moment.
struct Take {
  State state;
  std::string failure;  ///< why it went no further; the state is then that of the moment before; empty else
};

/// A scene run in one way or several, in step.
class Takes {
 public:
  /// Refers to the scenes, which differ in method and settings alone, from then on. Throws as Simulation
  /// does.
  explicit Takes(std::span<const Scene> scenes);

  /// All of them at a time (s) that is not before the one asked for last; nothing when told to stop. One way
  /// alone throws RunFailure where a step fails; of several, those that fail stay where they were.
  std::optional<std::vector<Take>> at(double time, const StopTest& stop);

  /// What was measured of one of them up to the time asked for last.
  RunMeasures measures(std::size_t which) const;

 private:
  std::vector<Simulation> simulations_;
  std::vector<Take> takes_;
};

/// A way of running a scene in a few words, such as "xpbd × 4, 600 steps/s".
std::string take_title(const Scene& scene);

/// How a way of running a scene does, in short lines: the largest strain of a link, and the energy error
/// where no drag takes any; or how far it went.
std::vector<std::string> take_lines(const Scene& scene, const RunMeasures& measures,
                                    const std::string& failure);

/// A hash of all states: of one alone, its own.
std::string takes_hash(const std::vector<Take>& takes);

}  // namespace taut
