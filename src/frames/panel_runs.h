#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "frames/captions.h"
#include "frames/motion_player.h"
#include "frames/simulation.h"
#include "scene/scene.h"

namespace taut {

/// What the run behind one panel has come to at a moment.
struct PanelState {
  std::shared_ptr<const State> state;  ///< never null; shared, for that of a large scene is large
  std::string failure;  ///< why it went no further; the state is then that of the moment before; empty else
  std::shared_ptr<const Trails> trails{};  ///< up to the state; null where the look shows none
};

/// Moves a panel that hasn't failed on to the state that `next` gives; where that throws, whatever it is, the
/// panel stays where it was and keeps the reason. False when `next` gives none: told to stop.
bool move_on(PanelState& panel, const std::function<std::optional<State>()>& next);

/// The runs behind the panels of a picture, in step: one scene run in one way or several.
class PanelRuns {
 public:
  /// Refers to the scenes, which differ in method and settings alone, from then on. Throws as Simulation
  /// does; of several, the message says whose panel's method it is.
  explicit PanelRuns(std::span<const Scene> scenes, const Execution& execution = {});
  /// Goes on from what save_before() gave for the same scenes. Throws BadRequest where it is of others.
  PanelRuns(std::span<const Scene> scenes, std::string_view saved, const Execution& execution = {});
  /// Plays a motion instead of running its one scene.
  PanelRuns(const Scene& scene, const MotionReader& motion);

  /// All of them at a time (s) that is not before the one asked for last; nothing when told to stop. A run
  /// that is alone throws what goes wrong in it; of several, those that fail stay where they were.
  std::optional<std::vector<PanelState>> at(double time, const StopTest& stop);

  /// All that it takes to go on at a time (s) later than the one asked for last, and after it, as bytes;
  /// nothing where that can't be had there, as within a step. Of several runs what each shows, too, for there
  /// it stays if it fails.
  std::optional<std::string> save_before(double time, const StopTest& stop);

  /// What was measured of one of them up to the time asked for last.
  RunMeasures measures(std::size_t which) const;

 private:
  std::vector<Simulation> simulations_;  // none where a motion is played
  std::optional<MotionPlayer> player_;
  std::vector<PanelState> panels_;
};

/// A way of running a scene in a few words, such as "xpbd × 4, 600 steps/s".
std::string panel_title(const Scene& scene);

/// A time of a scene's run in words; in a film with how much slower or faster than that it goes there.
std::string time_text(const Scene& scene, double time);
std::string film_time_text(const Scene& scene, double time);

/// What is said of a picture of a run at a time (in words), alone or among those of others: the scene's or
/// the method's name, the time, the largest strain of a link, and the energy error where no drag takes any;
/// or how far the run went.
Caption panel_caption(const Scene& scene, const RunMeasures& measures, const std::string& time,
                      const std::string& failure, bool alone);

/// A hash of the states of all panels: of one alone, its own.
std::string panels_hash(const std::vector<PanelState>& panels);

}  // namespace taut
