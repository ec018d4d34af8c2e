#include "frames/certifier.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>
#include <vector>

#include "base/digits.h"
#include "bounded_queue.h"
#include "frames/simulation.h"
#include "measure/cost.h"
#include "measure/pace.h"
#include "measure/plan.h"
#include "methods/registry.h"
#include "model/measures.h"
#include "motion/run.h"

namespace taut {
namespace {

constexpr double disturbance = 1e-8, chaotic_growth = 1e5, agreement = 0.01;
constexpr double integration_tolerance = 1e-8;         // of the scene's size
constexpr double finer = 4.0, finer_of_order_2 = 2.0;  // steps, than those of the first run
constexpr double patience = 10.0,
                 least_patience = 3.0;  // how much dearer than the first run, and s, at least

// A run, and a coarser one to know what it is off itself.
class SecondRun {
 public:
  // `error_share`: what the finer one is off, of the distance between the two.
  SecondRun(const Model& model, const State& start, const Settings& fine, const Settings& coarse,
            double error_share)
      : fine_(model, start, fine), coarse_(model, start, coarse), error_share_(error_share) {}

  // Its state at a time, which may not fall; nothing where it has ended.
  std::optional<State> at(double time, const StopTest& stop) {
    const StopTest thrown = throwing(stop);
    std::optional<State> state = fine_.at(time, thrown);
    if (const std::optional<State> coarse = coarse_.at(time, thrown); coarse && state)
      own_error_ = std::max(own_error_, error_share_ * position_error(*coarse, *state));
    return state;
  }
  // m, as far as it has come.
  double own_error() const { return own_error_; }
  std::string problem() const { return fine_.failure(); }
  // Predicted, of both (s).
  double spent(const Model& model) const {
    return predicted_seconds(model, fine_) + predicted_seconds(model, coarse_);
  }

 private:
  Run fine_, coarse_;
  double error_share_;
  double own_error_ = 0.0;
};

// A second run, and what it is.
struct Chosen {
  std::unique_ptr<SecondRun> second;
  std::string how;
};

// Nothing where the first run is of that kind, where it can't do the scene, or where a tenth of a second
// tells that all of it would take too long.
std::optional<Chosen> by_integration(const Scene& scene, double most_seconds, const StopTest& stop) {
  constexpr double trial = 0.1;
  const Model& model = scene.model;
  const double tolerance = integration_tolerance * scene_size(model, scene.start);
  const Settings fine = complete_settings({"dop853", {{"tolerance", tolerance}}}),
                 coarse = complete_settings({"dop853", {{"tolerance", 10.0 * tolerance}}});
  if (fine.method == scene.settings.method || !refusals(model, scene.start, fine).empty())
    return std::nullopt;
  const auto integration = [&] { return std::make_unique<SecondRun>(model, scene.start, fine, coarse, 1.0); };
  const auto tried = integration();
  const double until = std::min(trial, scene.duration);
  if (predicted_seconds(model, fine, until) > most_seconds || !tried->at(scene.start.time + until, stop) ||
      tried->spent(model) * scene.duration / until > most_seconds)
    return std::nullopt;
  return Chosen{integration(),
                "an integration of order 8 at acceleration level (" + settings_text(fine) + ")"};
}

// The finest steps of a method that are worth it: so much finer than the first run's, and more where the
// method asks for it.
std::optional<Chosen> by_method(const Scene& scene, std::string_view method, double factor,
                                double error_share, double most_seconds, const std::string& remark) {
  if (!capability_problems(scene.model, *find_method(method)).empty()) return std::nullopt;
  Settings settings =
      method == scene.settings.method ? scene.settings : complete_settings({std::string(method), {}});
  const auto at_pace = [&](double pace) {
    Settings paced = settings;
    set_pace(scene.model, paced, pace);
    return paced;
  };
  double rate = factor * pace_of(scene.model, scene.settings);
  const auto refused = [&](double tried) {
    return !refusals(scene.model, scene.start, at_pace(0.5 * tried)).empty();
  };
  constexpr double most = 1e6;
  while (rate < most && refused(rate)) rate *= 2.0;
  // What takes few long steps is judged by as many short ones as there is time for.
  constexpr double enough = 1e5;  // steps per second
  if (scene.settings.chooses_steps())
    while (rate < enough &&
           predicted_seconds(scene.model, at_pace(rate), scene.duration) < 0.25 * most_seconds)
      rate *= 2.0;
  if (rate > most) return std::nullopt;
  settings = at_pace(rate);
  if (predicted_seconds(scene.model, settings, scene.duration) > most_seconds) return std::nullopt;
  return Chosen{
      std::make_unique<SecondRun>(scene.model, scene.start, settings, at_pace(0.5 * rate), error_share),
      settings_text(settings) + remark};
}

Chosen choose_second(const Scene& scene, const StopTest& stop) {
  const double most_seconds =
      std::max(least_patience, patience * predicted_seconds(scene.model, scene.settings, scene.duration));
  if (std::optional<Chosen> chosen = by_integration(scene, most_seconds, stop)) return *std::move(chosen);
  const std::string& first = scene.settings.method;
  const Capabilities& can = find_method(first)->can;
  // Of order 2 the finer run is off by a third of what the two differ by, of order 1 by all of it.
  constexpr double order_1 = 1.0, order_2 = 1.0 / 3.0;
  // Where links are springs alone the two make nothing else of them, but nothing else comes as near.
  if (can.family != Family::stormer_verlet || !can.rigid) {
    for (const std::string_view method : {"rattle", "shake"})
      if (auto chosen = by_method(scene, method, finer_of_order_2, order_2, most_seconds, ""))
        return *std::move(chosen);
  }
  for (const std::string_view method : {"verlet", "xpbd"})
    if (method != first)
      if (auto chosen =
              by_method(scene, method, finer, order_1, most_seconds,
                        can.family == Family::relaxation ? ", which also visits links one by one" : ""))
        return *std::move(chosen);
  if (auto chosen =
          by_method(scene, first, finer, order_1, infinity, ", of the same kind: no other can do this scene"))
    return *std::move(chosen);
  return {nullptr, "no second run"};
}

std::string length_text(double metres) {
  return metres < 1.0 ? fmt::format("{:.2g} mm", 1e3 * metres) : fmt::format("{:.2g} m", metres);
}

State disturbed(const Model& model, State state) {
  std::mt19937 engine(1);
  const auto share = [&] { return static_cast<double>(engine()) / 2147483648.0 - 1.0; };
  const double size = scene_size(model, state), gravity = model.gravity.norm();
  const double speed = disturbance * std::sqrt(size * (gravity > 0.0 ? gravity : size));
  for (std::size_t i = 0; i < state.velocity.size(); ++i) {
    const Vec3 change(share(), share(), share());
    if (!model.masses.pinned(i)) state.velocity.add(i, speed * change);
  }
  return state;
}

}  // namespace

struct Certifier::Work {
  Work(const Scene& its_scene, const StopTest& stop)
      : scene(its_scene), told_to_stop([this, stop] { return abandoned || (stop && stop()); }) {}

  const Scene& scene;
  std::atomic<bool> abandoned = false;  // nobody waits for the certificate any more
  StopTest told_to_stop;
  BoundedQueue<State> seen{16};
  Certificate certificate;

  void run();
};

void Certifier::Work::run() {
  const Model& model = scene.model;
  certificate.size = scene_size(model, scene.start);
  certificate.duration = scene.duration;
  Chosen chosen = choose_second(scene, told_to_stop);
  certificate.how = chosen.how;
  if (!chosen.second) certificate.problem = "none can be made beside " + settings_text(scene.settings);
  std::optional<Run> twin;
  twin.emplace(model, disturbed(model, scene.start), scene.settings);
  bool apart = false;
  const StopTest thrown = throwing(told_to_stop);
  while (const std::optional<State> first = seen.pop()) {
    stop_if_told(told_to_stop);
    if (!certificate.problem.empty()) continue;
    const std::optional<State> second = chosen.second->at(first->time, told_to_stop);
    if (!second) {
      certificate.problem = chosen.second->problem();
      continue;
    }
    const double distance = position_error(*first, *second);
    certificate.until = first->time;
    if (distance > certificate.largest) {
      certificate.largest = distance;
      certificate.at = first->time;
    }
    apart = apart || !(distance <= agreement * certificate.size);
    if (!apart) certificate.agreed_until = first->time;
    certificate.own_error = chosen.second->own_error();
    if (!twin || certificate.chaotic_from) continue;
    const std::optional<State> moved = twin->at(first->time, thrown);
    if (!moved) {
      twin.reset();
    } else if (position_error(*first, *moved) > chaotic_growth * disturbance * certificate.size) {
      certificate.chaotic_from = first->time;
    }
  }
}

Certifier::Certifier(const Scene& scene, const StopTest& stop) : work_(new Work{scene, stop}) {
  thread_ = std::thread([this] {
    try {
      work_->run();
    } catch (...) {
      failure_ = std::current_exception();
    }
    work_->seen.close();
  });
}

Certifier::~Certifier() {
  work_->abandoned = true;
  work_->seen.close();
  if (thread_.joinable()) thread_.join();
}

void Certifier::see(const State& state) {
  work_->seen.push(state);
}

void Certifier::see_until(Simulation& first, double time) {
  const auto show = [&](double instant) {
    const std::optional<State> state = first.at(instant, work_->told_to_stop);
    if (!state) throw Interrupted();
    see(*state);
  };
  for (; next_sixtieth_ / 60.0 < time; ++next_sixtieth_) show(next_sixtieth_ / 60.0);
  if (time >= work_->scene.duration) show(time);
}

Certificate Certifier::finish() {
  work_->seen.close();
  thread_.join();
  if (failure_) std::rethrow_exception(failure_);
  return work_->certificate;
}

Certificate certify(const Scene& scene, const StopTest& stop) {
  Certifier certifier(scene, stop);
  Simulation simulation(scene);
  certifier.see_until(simulation, scene.duration);
  return certifier.finish();
}

std::string certificate_text(const Certificate& c) {
  std::string text = fmt::format("against {}: ", c.how);
  if (c.until == 0.0 && !c.problem.empty()) return text + "no word, because " + c.problem;
  text += fmt::format("at most {} apart, {} of the size of {:.3g} m, at t = {:.3g} s", length_text(c.largest),
                      percent(c.largest / c.size), c.size, c.at);
  text += c.until >= c.duration * (1.0 - 1e-9) ? fmt::format(", over all of its {:.3g} s", c.duration)
                                               : fmt::format(", until t = {:.3g} s", c.until);
  if (!c.problem.empty()) text += ", where it ended: " + c.problem;
  if (2.0 * c.own_error > c.largest)
    text += fmt::format("; it is itself off by up to {}, so that the first run may be better than that",
                        length_text(c.own_error));
  if (c.chaotic_from)
    text += fmt::format(
        "; chaotic from t = {:.3g} s: by then a difference at the start has grown 100,000-fold, and what "
        "comes later is "
        "one of many possible motions; the two agree within 1 % until t = {:.3g} s",
        *c.chaotic_from, c.agreed_until);
  return text;
}

}  // namespace taut
