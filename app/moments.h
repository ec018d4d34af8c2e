#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/stop.h"
#include "frames/kept_run.h"
#include "frames/motion_player.h"
#include "frames/simulation.h"
#include "output/motion_file.h"
#include "scene/scene.h"

namespace taut {

/// An instant of a run, and the number it goes by.
struct Instant {
  int frame;
  double time;  // s
};

/// Which instants: --times, --fps and --every as they stand on the command line. Without times: those of the
/// film's frames, or of every so many of them.
struct InstantFlags {
  std::string times, rate, every;
};

/// The instants of --times in rising order, numbered from 1; or those of frames, by their numbers. Throws
/// BadRequest.
std::vector<Instant> chosen_instants(const InstantFlags& flags, const Scene& scene, const FrameRate& rate);

/// Whether they are an equal time apart.
bool are_even(const std::vector<Instant>& instants);

/// Where the states at instants come from: a scene that is simulated, or a motion that was.
class MomentSource {
 public:
  /// Refers to the scene, and the motion where there is one, from then on. Throws BadRequest when the scene's
  /// method refuses it.
  MomentSource(const Scene& scene, std::shared_ptr<const MotionReader> motion, const Execution& execution);
  /// The same for a scene's run at given times alone, which is kept in a hidden folder (KeptRun).
  MomentSource(const Scene& scene, std::vector<double> times, const std::filesystem::path& folder,
               const Execution& execution);

  /// The state at a time (s) that is not before the one asked for last, as reports show it. Nothing when told
  /// to stop on the way. Throws as Simulation and MotionPlayer do.
  std::optional<State> at(double time, const StopTest& stop);
  /// What was measured of the run up to the state that at() gave last.
  RunMeasures measures() const;
  /// Null where a motion is played, or the run is kept.
  Simulation* simulation() { return simulation_ ? &*simulation_ : nullptr; }
  /// Null where the run isn't kept.
  KeptRun* kept() { return kept_ ? &*kept_ : nullptr; }

 private:
  const Scene& scene_;
  std::shared_ptr<const MotionReader> motion_;
  std::optional<Simulation> simulation_;
  std::optional<MotionPlayer> player_;
  std::optional<KeptRun> kept_;
  std::optional<State> last_;
};

}  // namespace taut
