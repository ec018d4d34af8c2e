#include "panel_runs.h"

#include <fmt/format.h>

#include <cmath>
#include <exception>
#include <new>
#include <utility>

#include "base/digits.h"
#include "base/failure.h"
#include "base/hash.h"
#include "frames/colouring.h"
#include "methods/registry.h"

namespace taut {

bool move_on(PanelState& panel, const std::function<std::optional<State>()>& next) {
  try {
    std::optional<State> state = next();
    if (!state) return false;
    panel.state = *std::move(state);
  } catch (const std::bad_alloc&) {
    panel.failure = "this machine has not enough memory for that";
  } catch (const std::exception& failure) {
    panel.failure = failure.what();
  } catch (...) {
    panel.failure = "the run ended for a reason that nothing is known of";
  }
  return true;
}

PanelRuns::PanelRuns(std::span<const Scene> scenes, const Execution& execution) {
  simulations_.reserve(scenes.size());
  for (const Scene& scene : scenes) {
    try {
      simulations_.emplace_back(scene, execution);
    } catch (const BadRequest& refusal) {
      if (scenes.size() == 1) throw;
      throw BadRequest(fmt::format("the panel of {}: {}", panel_title(scene), refusal.what()));
    }
    panels_.push_back({scene.start, {}});
  }
}

std::optional<std::vector<PanelState>> PanelRuns::at(double time, const StopTest& stop) {
  if (panels_.size() == 1) {
    std::optional<State> state = simulations_.front().at(time, stop);
    if (!state) return std::nullopt;
    panels_.front().state = *std::move(state);
    return panels_;
  }
  for (std::size_t i = 0; i < panels_.size(); ++i) {
    if (!panels_[i].failure.empty()) continue;
    if (!move_on(panels_[i], [&] { return simulations_[i].at(time, stop); })) return std::nullopt;
  }
  return panels_;
}

RunMeasures PanelRuns::measures(std::size_t which) const {
  return simulations_[which].measures(panels_[which].state);
}

std::string panel_title(const Scene& scene) {
  const Settings& settings = scene.settings;
  std::string title = settings.method;
  for (const auto& [name, value] : settings.values) {
    const Param& param = *find_param(*find_method(settings.method), name);
    if (name == "passes" && std::get<double>(value) != 1.0)
      title += fmt::format(" × {}", std::get<double>(value));
    if (!param.choices.empty() && std::get<std::string>(value) != param.choices.front())
      title += fmt::format(", {} {}", name, std::get<std::string>(value));
  }
  return title + (settings.chooses_steps() ? fmt::format(", {:g} m a step", settings.number("tolerance"))
                                           : fmt::format(", {} steps/s", settings.steps_per_second()));
}

std::vector<std::string> panel_lines(const Scene& scene, const RunMeasures& measures,
                                     const std::string& failure) {
  if (!failure.empty()) return {fmt::format("went no further than {:.3g} s", measures.time)};
  std::vector<std::string> lines{"strain " + percent(measures.strain.largest)};
  if (scene.look.colour_by == ColourBy::tension && !colour_problem(scene).empty())
    lines.push_back("tension unknown");
  if (scene.model.drag == 0.0)
    lines.push_back(fmt::format("energy {}{}", measures.energy_error < 0.0 ? "−" : "+",
                                percent(std::abs(measures.energy_error))));
  return lines;
}

std::string panels_hash(const std::vector<PanelState>& panels) {
  if (panels.size() == 1) return fmt::format("{:016x}", state_hash(panels.front().state));
  Hash hash;
  for (const PanelState& panel : panels) hash.add(fmt::format("{:016x}", state_hash(panel.state)));
  return hash.hex();
}

}  // namespace taut
