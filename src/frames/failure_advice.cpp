#include "frames/failure_advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/digits.h"
#include "measure/pace.h"
#include "measure/stability_edge.h"
#include "methods/registry.h"
#include "model/measures.h"
#include "model/ways_from_pins.h"
#include "motion/run.h"

namespace taut {
namespace {

constexpr std::int64_t most_search_solves = 10'000'000, most_trial_solves = 50'000'000;
constexpr std::int64_t fewest_steps = 100;
constexpr double most_steps_per_second = 1e7;  // that the methods take
constexpr double edge_ratio = 1.1, more_after_failure = 1.25;

struct Trial {
  bool held = false;
  double reached = 0.0;  // s
};

// Trial runs, as the scene would be run, that know what they have cost so far.
class Trials {
 public:
  Trials(const Scene& scene, const StopTest& stop) : scene_(scene), stop_(stop) {}

  // Held, where it has not failed before the time or before the solves are spent.
  Trial run(double rate, double until, std::int64_t most_solves) {
    Settings settings = scene_.settings;
    settings.values["steps_per_second"] = rate;
    if (!refusals(scene_.model, scene_.start, settings).empty()) return {};
    Run run(scene_.model, scene_.start, settings);
    const auto spent = [&] { return run.report().counts.link_solves + run.steps(); };
    while (run.state().time < until && spent() < most_solves && run.step()) stop_if_told(stop_);
    run.holds_together();
    spent_ += spent();
    return {!run.ended(), run.state().time};
  }
  std::int64_t spent() const { return spent_; }

 private:
  const Scene& scene_;
  const StopTest& stop_;
  std::int64_t spent_ = 0;
};

struct BadLength {
  std::size_t link = 0;
  double strain = 0.0;  // with its sign
};

BadLength worst_length(const Model& model, const State& state) {
  BadLength worst;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (!model.links.rigid(i)) continue;
    const double strain = model.links.strain(i, link_distance(model, state.position, i));
    if (std::abs(strain) > std::abs(worst.strain)) worst = {i, strain};
  }
  return worst;
}

std::string wrong_at_start(const Scene& scene, const State& failed) {
  constexpr double noticeable = 0.01, soon = 0.5;
  const BadLength worst = worst_length(scene.model, scene.start);
  if (std::abs(worst.strain) < noticeable || failed.time > soon) return {};
  return fmt::format(
      "at the start the link {} is {} too {}, and is brought to its length within the first steps",
      link_name(scene.model, worst.link), percent(std::abs(worst.strain)),
      worst.strain > 0.0 ? "long" : "short");
}

// Pins as far from each other as rigid links between them reach, or further.
std::string taut_between_pins(const Scene& scene, const State& failed) {
  constexpr double slack = 1e-3;
  const Model& model = scene.model;
  std::string cause;
  const WaysFromPins ways(model, [&](Index link) { return model.links.rigid(link) && !failed.broken(link); });
  ways.visit_closed([&](const WaysFromPins::Way& way) {
    const double gap = (failed.position.at(way.from) - failed.position.at(way.to)).norm();
    if (!cause.empty() || gap < (1.0 - slack) * way.length) return;
    cause =
        fmt::format("the links between the pins {} and {} are {:.6g} m long, and the pins are {:.6g} m apart",
                    model.masses.name[way.from], model.masses.name[way.to], way.length, gap);
  });
  return cause;
}

std::string pins_too_fast(const Scene& scene, const State& failed) {
  constexpr double share_of_link = 0.5;
  const Model& model = scene.model;
  if (model.driven_pins.empty() || model.links.size() == 0) return {};
  const double link = total_link_length(model) / static_cast<double>(model.links.size()),
               h = 1.0 / pace_of(model, scene.settings);
  const DrivenPin* fastest = nullptr;
  double speed = 0.0;
  for (const DrivenPin& pin : model.driven_pins)
    if (const double now = velocity_at(pin.motion, failed.time).norm(); now > speed) {
      speed = now;
      fastest = &pin;
    }
  if (speed * h < share_of_link * link) return {};
  return fmt::format("the pin {} moves at {:.3g} m/s then, {:.2g} of a link's length within a step",
                     model.masses.name[fastest->mass], speed, speed * h / link);
}

}  // namespace

std::optional<HoldingRate> holding_rate(const Scene& scene, double failed_at, const StopTest& stop) {
  Trials trials(scene, stop);
  const double own = scene.settings.steps_per_second();
  // Through the moment of failure, and as long again.
  const auto near = [&](double rate) {
    return std::max(2.0 * failed_at, failed_at + static_cast<double>(fewest_steps) / rate);
  };
  const auto left = [&] { return most_search_solves - trials.spent(); };
  const auto gets_past = [&](double rate) {
    const Trial trial = trials.run(rate, near(rate), left());
    return trial.held && trial.reached >= std::min(near(rate), scene.duration);
  };
  double rate = 2.0 * own;
  for (; rate <= most_steps_per_second && !gets_past(rate); rate *= 2.0)
    if (left() <= 0) return std::nullopt;
  if (rate > most_steps_per_second) return std::nullopt;
  // Steps are what an edge is about: the longer one fails.
  const Edge edge = narrow_edge([&](double step) { return left() > 0 && gets_past(1.0 / step); },
                                {1.0 / rate, 2.0 / rate}, edge_ratio);
  for (rate = std::ceil(1.0 / edge.holds); rate <= most_steps_per_second;
       rate = std::ceil(rate * more_after_failure)) {
    const std::int64_t solves = most_trial_solves - trials.spent();
    if (solves <= 0) break;
    const Trial trial = trials.run(rate, scene.duration, solves);
    if (trial.held && trial.reached >= std::min(near(rate), scene.duration))
      return HoldingRate{rate, trial.reached};
  }
  return std::nullopt;
}

std::string cause_of_failure(const Scene& scene, const State& failed) {
  if (std::string cause = taut_between_pins(scene, failed); !cause.empty()) return cause;
  if (std::string cause = wrong_at_start(scene, failed); !cause.empty()) return cause;
  return pins_too_fast(scene, failed);
}

std::string failure_advice(const Scene& scene, const State& failed, const StopTest& stop) {
  const std::string cause = cause_of_failure(scene, failed);
  std::string advice;
  if (scene.settings.chooses_steps())
    return cause.empty() ? "; shorter steps were tried" : "; what seems to be the cause: " + cause;
  if (const auto found = holding_rate(scene, failed.time, stop)) {
    const std::string tried = found->tried_until >= scene.duration
                                  ? "to the scene's end"
                                  : fmt::format("until t = {:.3g} s", found->tried_until);
    advice =
        fmt::format("; it would hold at {:.0f} steps_per_second, tried {}", found->steps_per_second, tried);
  }
  if (!cause.empty()) advice += "; what seems to be the cause: " + cause;
  return advice.empty() ? "; no number of steps_per_second was found with which it holds" : advice;
}

}  // namespace taut
