#include "look_ahead.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/failure.h"
#include "methods/registry.h"
#include "motion/run.h"

namespace taut {
namespace {

// To be shown a moment costs a scene of a million masses a tenth of a second.
constexpr double most_moments = 300.0, fewest_moments = 30.0, most_places = 1.5e7;
// Links and limits looked at, all steps together: about a fourth of a second.
constexpr double most_work = 5e7;
constexpr double fewest_coarse_steps = 120.0, most_coarse_steps = 1200.0;  // per second
// What a point that touches takes, in links; a few of them take no time that anybody notices. A crowd may be
// seen more coarsely: what falls into a heap goes there at any step.
constexpr double work_of_contact = 100.0, few_contacts = 3000.0, fewest_steps_of_crowd = 30.0;

// The method that knows all that a scene can say, with as many steps as the work allows.
Settings coarse_settings(const Scene& scene) {
  const double crowd = std::max(0.0, static_cast<double>(scene.model.contacts.size()) - few_contacts);
  const double a_step = static_cast<double>(scene.model.links.size() + scene.model.limits.size() * 4 +
                                            scene.model.masses.size()) +
                        work_of_contact * crowd;
  const double steps =
      std::clamp(most_work / (scene.duration * std::max(a_step, 1.0)),
                 crowd > 0.0 ? fewest_steps_of_crowd : fewest_coarse_steps, most_coarse_steps);
  return complete_settings({"xpbd", {{"steps_per_second", std::round(steps)}}});
}

int moments_of(const Scene& scene) {
  const double masses = std::max(static_cast<double>(scene.model.masses.size()), 1.0);
  return static_cast<int>(std::clamp(most_places / masses, fewest_moments, most_moments));
}

}  // namespace

void look_ahead(const Scene& scene, const StopTest& stop, const std::function<void(const State&)>& see) {
  see(scene.start);
  const int moments = moments_of(scene);
  try {
    Run run(scene.model, scene.start, coarse_settings(scene));
    for (int moment = 1; moment <= moments; ++moment) {
      const std::optional<State> state = run.at(scene.duration * moment / moments, stop);
      if (run.ended()) return;
      if (!state) throw Interrupted();
      see(*state);
    }
  } catch (const BadRequest&) {
    // What the method can't do leaves the start.
  }
}

}  // namespace taut
