#include "probe_ladder.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/failure.h"
#include "measure/cost.h"
#include "measure/pace.h"
#include "measure/plan.h"
#include "methods/registry.h"
#include "model/measures.h"
#include "model/parts.h"
#include "motion/run.h"

namespace taut {
namespace {

constexpr std::size_t most_links_of_net = 2000;           // that links are solved together of
constexpr double lowest_rate = 60.0, highest_rate = 1e6;  // steps per second

bool knows_springs_as_forces(const Method& method) {
  return method.can.limit == StepLimit::sideways_vibration || method.can.limit == StepLimit::spring_frequency;
}

// The chart's grid: 60 · 2^n steps a second, at least so many.
double on_grid(double rate) {
  return std::clamp(lowest_rate * std::exp2(std::ceil(std::log2(rate / lowest_rate) - 1e-9)), lowest_rate,
                    highest_rate);
}

// The step that a target of `wanted` asks for: a share of what the fastest of the scene's motions takes, the
// larger the higher the order. The shares are fitted to charts (chain-20 and curtain).
double accurate_step(const TimeScales& scales, double wanted, int order) {
  const double share = 0.4 * std::pow(std::min(wanted, 0.5), 1.0 / order);
  return std::min(
      {share * scales.fall, 5.0 * share * scales.motion, 0.5 * scales.motion, 0.5 * scales.impact});
}

ProbeCandidate candidate(const Model& model, const Method& method, double passes, const TimeScales& scales,
                         double wanted, double size) {
  constexpr double grown = 10.0, finest_share = 1e-12;
  constexpr double below_rule = 8.0;  // where to begin: rules err to both sides, and coarse runs cost little
  ProbeCandidate result;
  result.settings = complete_settings({std::string(method.name), {}});
  if (find_param(method, "passes") != nullptr) result.settings.values["passes"] = passes;
  result.order = order_in_step(result.settings);
  if (method.can.chooses_steps) {
    // A tolerance is a wanted error as it stands, but for what a motion makes of it on its way.
    const Param& tolerance = *find_param(method, "tolerance");
    result.settings.values["tolerance"] =
        std::clamp(wanted * size / grown, std::max(tolerance.min, finest_share * size), tolerance.max);
    result.rule_rate = pace_of(model, result.settings);
    result.first_rate = 0.5 * result.rule_rate;
    return result;
  }
  result.rule_rate = on_grid(1.0 / accurate_step(scales, wanted, result.order));
  result.first_rate = on_grid(result.rule_rate / below_rule);
  if (knows_springs_as_forces(method)) {
    // Beyond the springs' limit the method refuses; beyond that of rigid links it only fails, and the limit
    // is an estimate.
    const double springs = on_grid(1.05 / scales.spring);
    // One that visits links one by one never gets to the tension that swings them; it is only wrong.
    if (has_rigid_links(model) && find_param(method, "passes") == nullptr)
      result.rule_rate = std::max(result.rule_rate, on_grid(1.1 / scales.sideways));
    result.rule_rate = std::max(result.rule_rate, springs);
    result.first_rate = std::max(result.first_rate, springs);
  }
  return result;
}

double mean_rigid_strain(const Model& model, const State& state) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (!model.links.rigid(i) || state.broken(i)) continue;
    sum += std::abs(model.links.strain(i, link_distance(model, state.position, i)));
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

ProbeSample sample_of(const ProbeScene& scene, const Run& run, State state) {
  // Of speeds only energy knows, and what makes them those of a report can take longer than the run.
  if (scene.kind == ErrorKind::energy) state = run.reported(state);
  ProbeSample sample;
  const bool place = scene.kind == ErrorKind::trajectory || scene.kind == ErrorKind::sag;
  if (scene.kind != ErrorKind::trajectory) sample.summary = summary_of(scene.model, state);
  if (place)
    sample.length_error =
        mean_rigid_strain(scene.model, state) * scene.reach / scene_size(scene.model, scene.start);
  sample.position = std::move(state.position);
  return sample;
}

// A run's error from its distance d to the one with half the step. The distances to ever finer runs form a
// geometric series, d (1 + q + q² + …) = d/(1 − q), with q = 2^−p for a method of order p in steps that are
// short enough. In longer ones q is what the distance before this one says; where there is none yet, more
// than the order promises.
double whole_error(double difference, std::optional<double> before, int order) {
  constexpr double slowest = 0.9, cautious = 1.5;
  const double promised = std::exp2(-order);
  if (!before) return cautious * difference / (1.0 - promised);
  const double seen = *before > 0.0 ? difference / *before : promised;
  return difference / (1.0 - std::clamp(seen, promised, slowest));
}

}  // namespace

double distance(const ProbeScene& scene, const ProbeSample& a, const ProbeSample& b) {
  if (scene.kind == ErrorKind::trajectory) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.position.size(); ++i)
      largest = std::max(largest, (a.position.at(i) - b.position.at(i)).squaredNorm());
    return std::sqrt(largest) / scene_size(scene.model, scene.start);
  }
  if (scene.kind == ErrorKind::strain && has_rigid_links(scene.model))
    return std::max(a.summary.strain, b.summary.strain);
  return *difference(scene.model, scene.start, a.summary, b.summary)[scene.kind];
}

std::vector<ProbeCandidate> probe_candidates(const Model& model, const State& start, const TimeScales& scales,
                                             double wanted, std::string_view only) {
  // `verlet` is xpbd without stiffness: worth a run as its second opinion where no method solves links
  // directly.
  constexpr std::array<std::string_view, 7> worth_trying{"xpbd",   "shake",  "rattle",         "dop853",
                                                         "newton", "verlet", "spring-explicit"};
  const double size = scene_size(model, start);
  const bool impacts = !model.contacts.empty() || !model.limits.empty();
  // To bring a large net's system into order alone takes longer than all runs may.
  const bool large_net = model.links.size() > most_links_of_net && model.links.size() > model.masses.size();
  std::vector<ProbeCandidate> candidates;
  const auto add = [&](std::string_view name) {
    const Method& method = *find_method(name);
    if (!capability_problems(model, method).empty()) return;
    if (large_net && only.empty() && method.prices.factor > 0.0) return;
    if (method.can.chooses_steps && only.empty() &&
        !refusals(model, start, complete_settings({std::string(name), {}})).empty())
      return;
    candidates.push_back(candidate(model, method, 1.0, scales, wanted, size));
    if (find_param(method, "passes") != nullptr && impacts)
      candidates.push_back(candidate(model, method, 4.0, scales, wanted, size));
  };
  if (!only.empty()) {
    complete_settings({std::string(only), {}});  // complains of a name that is none
    if (const auto problems = capability_problems(model, *find_method(only)); !problems.empty())
      throw BadRequest(fmt::format("{}", fmt::join(problems, "\n")));
    add(only);
  } else {
    for (const std::string_view name : worth_trying)
      if (name != "verlet" || !model.contacts.empty()) add(name);
  }
  if (candidates.empty())
    throw BadRequest("no method can do all that this scene needs; see `taut list methods`");
  return candidates;
}

Settings ProbeLadder::settings_at(const Model& model, double rate) const {
  Settings settings = candidate_.settings;
  set_pace(model, settings, rate);
  return settings;
}

bool ProbeLadder::plans(const Model& model, const Settings& settings) const {
  if (settings.method != candidate_.settings.method) return false;
  return settings.chooses_steps() ||
         settings_at(model, settings.steps_per_second()).values == settings.values;
}

double ProbeLadder::work_of(const Model& model, double rate, double seconds) const {
  return predicted_seconds(model, settings_at(model, rate), seconds);
}

double ProbeLadder::next_work(const ProbeScene& scene) const {
  return last_ ? 2.0 * last_work_ : work_of(scene.model, rate_, scene.times.back());
}

// The run at the present step; nothing where it fails.
std::optional<Probe> ProbeLadder::made(const ProbeScene& scene, double most_seconds, const StopTest& stop) {
  Probe probe;
  probe.rate = rate_;
  last_work_ = 0.0;
  try {
    Run run(scene.model, scene.start, settings_at(scene.model, rate_), chart_policy);
    const auto work = [&] { return predicted_seconds(scene.model, run); };
    std::int64_t looked_at = 0;
    const auto enough = [&] {
      stop_if_told(stop);
      // Passes that impacts ask for can't be foreseen.
      return run.steps() >= looked_at + 8 && (looked_at = run.steps(), work() > 1.5 * most_seconds);
    };
    for (const double time : scene.times) {
      std::optional<State> state = run.at(scene.start.time + time, enough);
      if (!state) break;
      probe.samples.push_back(sample_of(scene, run, *std::move(state)));
    }
    probe.work = last_work_ = work();
    if (run.ended()) return std::nullopt;
  } catch (const BadRequest&) {
    return std::nullopt;  // springs too stiff for this step
  }
  return probe;
}

// Estimates the last run's errors from a finer one, and keeps it.
void ProbeLadder::judge_last(const ProbeScene& scene, const Probe& finer) {
  const Probe* before = finest_judged();
  if (before != nullptr && before->rate * 2.0 != last_->rate) before = nullptr;
  double largest = 0.0, apart = 0.0;
  for (std::size_t i = 0; i < std::min(last_->samples.size(), finer.samples.size()); ++i) {
    apart = std::max(apart, distance(scene, last_->samples[i], finer.samples[i]));
    const bool comparable = before != nullptr && i < before->distances.size();
    const auto earlier = comparable ? std::optional(before->distances[i]) : std::nullopt;
    largest =
        std::max({largest, whole_error(apart, earlier, candidate_.order), last_->samples[i].length_error});
    last_->distances.push_back(apart);
    last_->errors.push_back(largest);
  }
  probes_.push_back(*std::move(last_));
}

void ProbeLadder::climb(const ProbeScene& scene, double most_seconds, const StopTest& stop) {
  constexpr double patience = 4.0;  // with a method whose steps can't be foreseen
  if (candidate_.settings.chooses_steps())
    most_seconds = std::min(most_seconds, patience * work_of(scene.model, rate_, scene.times.back()));
  std::optional<Probe> probe = made(scene, most_seconds, stop);
  ++runs_;
  failed_ += probe ? 0 : 1;
  if (last_ && probe) judge_last(scene, *probe);
  rate_ *= 2.0;
  ended_ = rate_ > highest_rate || (probe && probe->samples.size() < scene.times.size());
  last_ = std::move(probe);
}

void ProbeLadder::begin_again() {
  rate_ = candidate_.first_rate;
  ended_ = false;
  last_work_ = 0.0;
  last_.reset();
  probes_.clear();
}

std::string ProbeLadder::account(const Model& model) const {
  const auto pace = [&](double rate) { return pace_text(settings_at(model, rate)); };
  std::string text = fmt::format("{}: by rule {}", candidate_.settings.method, pace(candidate_.rule_rate));
  if (candidate_.settings.values.contains("passes"))
    text += fmt::format(" with passes = {}", candidate_.settings.number("passes"));
  if (runs_ == 0) return text + "; not run, it would cost more than the others";
  text += fmt::format("; {} short {}", runs_, runs_ == 1 ? "run" : "runs");
  if (failed_ > 0) text += fmt::format(", {} of them failed", failed_);
  if (const Probe* last = finest_judged(); last != nullptr && !last->errors.empty())
    text += fmt::format("; {} estimated {:.2g} off", pace(last->rate), last->errors.back());
  return text;
}

}  // namespace taut
