#pragma once

#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "base/stop.h"
#include "frames/simulation.h"
#include "model/state.h"
#include "scene/scene.h"

namespace taut {

/// What a second run says of a first.
struct Certificate {
  double size = 0.0;                   ///< m, scene_size()
  double until = 0.0;                  ///< s, how far both went
  double duration = 0.0;               ///< s, of the scene
  double largest = 0.0;                ///< m, between the places of one mass in both, of all times looked at
  double at = 0.0;                     ///< s, when that was
  double agreed_until = 0.0;           ///< s, up to which it stays within 1 % of the size
  double own_error = 0.0;              ///< m, what the second run itself is estimated to be off
  std::optional<double> chaotic_from;  ///< s, from which on a disturbance at the start has grown 100,000-fold
  std::string how;                     ///< the second run, in words
  std::string problem;                 ///< why the second run ended early; empty when it didn't
};

/// A certificate as a sentence.
std::string certificate_text(const Certificate& certificate);

/// Runs a scene a second time, by another kind of method and finer, in a thread of its own, beside a first
/// run whose states it is shown, and measures how far the two are apart. Where it can do the scene, and the
/// first run is of another kind, the second is dop853's. A third run, the first one's twin, starts with
/// velocities that are off by 10⁻⁸ of √(g · size): where that has grown 100,000-fold, the motion is chaotic,
/// and no two runs agree for long.
class Certifier {
 public:
  /// Refers to the scene from then on.
  explicit Certifier(const Scene& scene, const StopTest& stop = {});
  ~Certifier();
  Certifier(const Certifier&) = delete;
  Certifier& operator=(const Certifier&) = delete;

  /// The next state of the first run, in the order of time.
  void see(const State& state);
  /// Moves the first run on to a time (s), and shows its states at every sixtieth of a second that comes
  /// before it, or at it. Throws Interrupted.
  void see_until(Simulation& first, double time);
  /// Waits for the second run. Throws Interrupted.
  Certificate finish();

 private:
  struct Work;
  std::unique_ptr<Work> work_;
  std::thread thread_;
  std::exception_ptr failure_;
  int next_sixtieth_ = 0;
};

/// Runs a scene to its end and certifies it at every sixtieth of a second.
Certificate certify(const Scene& scene, const StopTest& stop = {});

}  // namespace taut
