#include "frames/holding_rate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "measure/stability.h"
#include "measure/stability_edge.h"
#include "methods/registry.h"

namespace taut {
namespace {

constexpr double most_link_solves = 1e7;
constexpr std::int64_t fewest_steps = 100;
constexpr double most_steps_per_second = 1e7;  // that the methods take

// Trial runs that know what they have cost so far.
class Trials {
 public:
  Trials(const Scene& scene, double until) : scene_(scene), until_(until) {
    const Method& method = *find_method(scene.settings.method);
    const double passes = find_param(method, "passes") ? scene.settings.number("passes") : 1.0;
    solves_per_step_ = passes * std::max(1.0, static_cast<double>(scene.model.links.size()));
  }

  bool affordable(double rate) const { return spent_ + cost(rate) <= most_link_solves; }
  bool holds(double rate) {
    spent_ += cost(rate);
    Settings settings = scene_.settings;
    settings.values["steps_per_second"] = rate;
    return !run_unguarded(scene_.model, scene_.start, settings, steps(rate)).failed();
  }

 private:
  std::int64_t steps(double rate) const {
    return std::max(static_cast<std::int64_t>(std::ceil(until_ * rate)), fewest_steps);
  }
  double cost(double rate) const { return solves_per_step_ * static_cast<double>(steps(rate)); }

  const Scene& scene_;
  double until_;
  double solves_per_step_, spent_ = 0.0;
};

}  // namespace

std::optional<double> holding_rate(const Scene& scene, double until) {
  Trials trials(scene, until);
  double rate = 2.0 * scene.settings.steps_per_second();
  if (rate > most_steps_per_second || !trials.affordable(rate)) return std::nullopt;
  for (; !trials.holds(rate); rate *= 2.0)
    if (2.0 * rate > most_steps_per_second || !trials.affordable(2.0 * rate)) return std::nullopt;
  // Steps are what an edge is about: the longer one fails.
  const Edge edge =
      narrow_edge([&](double step) { return trials.affordable(1.0 / step) && trials.holds(1.0 / step); },
                  {1.0 / rate, 2.0 / rate}, 1.1);
  return std::ceil(1.0 / edge.holds);
}

std::string holding_rate_hint(const Scene& scene, double until) {
  const auto rate = holding_rate(scene, until);
  return rate ? fmt::format("; it would hold at {:.0f} steps_per_second", *rate) : std::string();
}

}  // namespace taut
