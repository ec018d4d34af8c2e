#include "panel_runs.h"

#include <fmt/format.h>

#include <cmath>

#include "base/digits.h"
#include "base/failure.h"
#include "base/hash.h"
#include "frames/colouring.h"
#include "methods/registry.h"

namespace taut {
Takes::Takes(std::span<const Scene> scenes) {
  simulations_.reserve(scenes.size());
  for (const Scene& scene : scenes) {
    simulations_.emplace_back(scene);
    takes_.push_back({scene.start, {}});
  }
}

std::optional<std::vector<Take>> Takes::at(double time, const StopTest& stop) {
  for (std::size_t i = 0; i < takes_.size(); ++i) {
    if (!takes_[i].failure.empty()) continue;
    try {
      std::optional<State> state = simulations_[i].at(time, stop);
      if (!state) return std::nullopt;
      takes_[i].state = *std::move(state);
    } catch (const RunFailure& failure) {
      if (takes_.size() == 1) throw;
      takes_[i].failure = failure.what();
    }
  }
  return takes_;
}

RunMeasures Takes::measures(std::size_t which) const {
  return simulations_[which].measures(takes_[which].state);
}

std::string take_title(const Scene& scene) {
  const Settings& settings = scene.settings;
  std::string title = settings.method;
  for (const auto& [name, value] : settings.values) {
    const Param& param = *find_param(*find_method(settings.method), name);
    if (name == "passes" && std::get<double>(value) != 1.0)
      title += fmt::format(" × {}", std::get<double>(value));
    if (!param.choices.empty() && std::get<std::string>(value) != param.choices.front())
      title += fmt::format(", {} {}", name, std::get<std::string>(value));
  }
  return title + fmt::format(", {} steps/s", settings.steps_per_second());
}

std::vector<std::string> take_lines(const Scene& scene, const RunMeasures& measures,
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

std::string takes_hash(const std::vector<Take>& takes) {
  if (takes.size() == 1) return fmt::format("{:016x}", state_hash(takes.front().state));
  Hash hash;
  for (const Take& take : takes) hash.add(fmt::format("{:016x}", state_hash(take.state)));
  return hash.hex();
}

}  // namespace taut
