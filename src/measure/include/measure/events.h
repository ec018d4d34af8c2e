#pragma once

#include <optional>
#include <string_view>

#include "base/stop.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// Whether there is anything to touch, to reach or to break.
bool has_events(const Model& model);

/// The scene without what no reference resolves: without ground, solids and touching bodies; and, where its
/// breaks and limits on angles can't be located either (by dop853), with links that never break and without
/// limits. The same until one of these has an effect, and within reach of more methods and of references.
Model without_unlocated_events(const Model& model, const State& start);

/// The first event that no reference resolves.
struct Event {
  double time = 0.0;      ///< s, to a few milliseconds
  std::string_view what;  ///< "the first link breaks", "an angle reaches its limit" or "something is touched"
};

/// The first such event up to a horizon (s): the scene runs beside itself without them until the two differ.
/// Nothing where they never do. Throws Interrupted.
std::optional<Event> first_event(const Model& model, const State& start, double horizon,
                                 const StopTest& stop = {});
/// The same where without_unlocated_events() is at hand.
std::optional<Event> first_event(const Model& model, const Model& calm, const State& start, double horizon,
                                 const StopTest& stop);

/// How long a motion is looked at that such an event ends (s): a little less, because the time at which
/// something breaks or is touched depends on method and step.
double time_before(const Event& event);

}  // namespace taut
