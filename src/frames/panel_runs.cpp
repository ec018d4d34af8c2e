#include "panel_runs.h"

#include <fmt/format.h>

#include <cmath>
#include <exception>
#include <new>
#include <utility>

#include "base/bytes.h"
#include "base/digits.h"
#include "base/failure.h"
#include "base/hash.h"
#include "frames/colouring.h"
#include "frames/film_time.h"
#include "methods/registry.h"

namespace taut {
namespace {

// A state that is kept elsewhere, at least as long.
std::shared_ptr<const State> lent(const State& state) {
  return {std::shared_ptr<const State>(), &state};
}

}  // namespace

bool move_on(PanelState& panel, const std::function<std::optional<State>()>& next) {
  try {
    std::optional<State> state = next();
    if (!state) return false;
    panel.state = std::make_shared<const State>(*std::move(state));
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
    panels_.push_back({lent(scene.start), {}, {}});
  }
}

PanelRuns::PanelRuns(std::span<const Scene> scenes, std::string_view saved, const Execution& execution) {
  ByteReader reader(saved);
  simulations_.reserve(scenes.size());
  for (const Scene& scene : scenes) {
    const std::string_view run = reader.take_in_place(), failure = reader.take_in_place(),
                           shown = reader.take_in_place();
    simulations_.emplace_back(scene, run, execution);
    panels_.push_back({lent(scene.start), std::string(failure), {}});
    PanelState& panel = panels_.back();
    if (shown.empty()) continue;
    panel.state = std::make_shared<const State>(run_state_from(shown, scene.model).state);
    panel.trails = simulations_.back().trails(*panel.state);
  }
  if (!reader.at_end()) throw BadRequest("these are the saved runs of other panels");
}

PanelRuns::PanelRuns(const Scene& scene, const MotionReader& motion) : player_(std::in_place, scene, motion) {
  panels_.push_back({lent(scene.start), {}, {}});
}

std::optional<std::string> PanelRuns::save_before(double time, const StopTest& stop) {
  if (player_) return std::nullopt;
  const bool alone = simulations_.size() == 1;
  std::string bytes;
  for (std::size_t i = 0; i < simulations_.size(); ++i) {
    const bool failed = !panels_[i].failure.empty();
    const std::optional<SavedSimulation> saved =
        failed ? simulations_[i].save_end() : simulations_[i].save_before(time, stop);
    if (!saved) return std::nullopt;
    append_saved(*saved, bytes);
    append_bytes(panels_[i].failure, bytes);
    if (alone)
      append_bytes(std::string(), bytes);
    else
      append_run_state({*panels_[i].state, {}, {}}, bytes);
  }
  return bytes;
}

std::optional<std::vector<PanelState>> PanelRuns::at(double time, const StopTest& stop) {
  if (player_) {
    panels_.front().state = std::make_shared<const State>(player_->at(time));
    panels_.front().trails = player_->trails(*panels_.front().state);
    return panels_;
  }
  if (panels_.size() == 1) {
    std::optional<State> state = simulations_.front().at(time, stop);
    if (!state) return std::nullopt;
    panels_.front().state = std::make_shared<const State>(*std::move(state));
    panels_.front().trails = simulations_.front().trails(*panels_.front().state);
    return panels_;
  }
  for (std::size_t i = 0; i < panels_.size(); ++i) {
    if (!panels_[i].failure.empty()) continue;
    if (!move_on(panels_[i], [&] { return simulations_[i].at(time, stop); })) return std::nullopt;
    panels_[i].trails = simulations_[i].trails(*panels_[i].state);
  }
  return panels_;
}

RunMeasures PanelRuns::measures(std::size_t which) const {
  return player_ ? player_->measures() : simulations_[which].measures(*panels_[which].state);
}

std::string time_text(const Scene& scene, double time) {
  // As many digits as tell the moments of a film apart.
  return fmt::format("{:.{}f} s", time, scene.duration < 1.0 ? 3 : 2);
}

std::string film_time_text(const Scene& scene, double time) {
  const std::string text = time_text(scene, time);
  const double speed = film_speed(scene.look, time);
  if (speed == 1.0) return text;
  return speed < 1.0 ? fmt::format("{}, {:.3g} × slower", text, 1.0 / speed)
                     : fmt::format("{}, {:.3g} × faster", text, speed);
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

std::string figures_text(const Scene& scene, const RunMeasures& measures) {
  std::string text = fmt::format("strain {}", percent(measures.strain.largest));
  if (scene.look.colour_by == ColourBy::tension && !colour_problem(scene).empty())
    text += ", tension unknown";
  if (scene.model.drag != 0.0) return text;
  // A sign before "below" would say nothing.
  const double error = measures.energy_error;
  const std::string size = percent(std::abs(error));
  const bool has_digits = size.front() >= '0' && size.front() <= '9';
  return text + fmt::format(", energy {}{}", !has_digits ? "error " : error < 0.0 ? "−" : "+", size);
}

Caption panel_caption(const Scene& scene, const RunMeasures& measures, const std::string& time,
                      const std::string& failure, bool alone) {
  Caption caption{alone ? scene.title : panel_title(scene), time, {}, !failure.empty()};
  caption.line = caption.failed ? fmt::format("went no further than {:.3g} s", measures.time)
                                : figures_text(scene, measures);
  if (alone) caption.line = fmt::format("{} · {}", panel_title(scene), caption.line);
  return caption;
}

std::string panels_hash(const std::vector<PanelState>& panels) {
  if (panels.size() == 1) return fmt::format("{:016x}", state_hash(*panels.front().state));
  Hash hash;
  for (const PanelState& panel : panels) hash.add(fmt::format("{:016x}", state_hash(*panel.state)));
  return hash.hex();
}

}  // namespace taut
