#include "study/speed.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "methods/registry.h"
#include "motion/run.h"

namespace taut {
namespace {

constexpr double rate = 2400.0;  // steps/s: short enough for every method here

// What is timed: a model and the ways to run it.
struct Subject {
  std::string name;
  Description description;
  std::vector<Settings> ways;
};

Settings way(const char* method, const char* precision = "") {
  Settings settings{method, {{"steps_per_second", rate}}};
  if (*precision != '\0') settings.values["precision"] = std::string(precision);
  return complete_settings(settings);
}

Subject chain(int links) {
  ChainSpec spec;
  spec.name = "chain";
  spec.to = {0.02 * links, 0.0, 0.0};
  spec.links = links;
  spec.pinned = {"first"};
  Subject subject{
      fmt::format("chain of {} links", links), {}, {way("xpbd"), way("shake"), way("rattle"), way("newton")}};
  subject.description.chains = {spec};
  return subject;
}

Subject sheet(int size, std::vector<Settings> ways) {
  return {fmt::format("sheet of {0} × {0}", size), square_sheet(size), std::move(ways)};
}

std::vector<Subject> subjects() {
  std::vector<Settings> relaxations{way("xpbd"), way("xpbd", "single"), way("verlet"), way("shake")};
  return {chain(100), sheet(64, relaxations), sheet(256, relaxations)};
}

// The median of as many steps as there is time for.
double median_step(Run& run, double seconds, const StopTest& stop) {
  using Clock = std::chrono::steady_clock;
  constexpr int steps_at_once = 16;
  for (int step = 0; step < steps_at_once; ++step) run.step();  // so that nothing is cold
  std::vector<double> times;
  const Clock::time_point begin = Clock::now();
  for (Clock::time_point last = begin; std::chrono::duration<double>(last - begin).count() < seconds;) {
    stop_if_told(stop);
    for (int step = 0; step < steps_at_once; ++step)
      if (!run.step()) throw std::logic_error(run.failure());
    const Clock::time_point now = Clock::now();
    times.push_back(std::chrono::duration<double>(now - last).count() / steps_at_once);
    last = now;
  }
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

std::string title(const Settings& settings) {
  const bool single = settings.values.contains("precision") && settings.choice("precision") == "single";
  return settings.method + (single ? " single" : "");
}

}  // namespace

Description square_sheet(int size) {
  SheetSpec spec;
  spec.name = "sheet";
  spec.rows = spec.columns = size;
  spec.to = {1.0, 0.0, 0.0};
  spec.down = {0.0, 0.0, 1.0};
  spec.pinned = {"top-left", "top-right"};
  spec.diagonals = LinkProperties{};
  Description description;
  description.sheets = {spec};
  return description;
}

std::vector<Speed> measure_speed(double seconds_each, int threads,
                                 const std::function<void(std::size_t done, std::size_t of)>& done,
                                 const StopTest& stop) {
  const std::vector<Subject> all = subjects();
  std::vector<int> counts{1};
  if (threads > 1) counts.push_back(threads);
  std::size_t of = 0;
  for (const Subject& subject : all)
    of += subject.ways.size() * (subject.description.sheets.empty() ? 1 : counts.size());
  std::vector<Speed> speeds;
  for (const Subject& subject : all) {
    const Built built = build(subject.description);
    for (const Settings& settings : subject.ways)
      for (const int count : counts) {
        if (count > 1 && subject.description.sheets.empty()) continue;  // too small to be shared
        Execution execution;
        if (count > 1) execution.workers = std::make_shared<Workers>(count);
        Run run(built.model, built.start, settings, {}, execution);
        const double step = median_step(run, seconds_each, stop);
        const std::size_t links = built.model.links.size();
        speeds.push_back({subject.name, title(settings), count, built.model.masses.size(), links, step,
                          step / static_cast<double>(links)});
        done(speeds.size(), of);
      }
  }
  return speeds;
}

}  // namespace taut
