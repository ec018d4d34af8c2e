#include "study/timed_runs.h"

#include <chrono>

#include "base/processor_time.h"
#include "host/pinned_thread.h"
#include "measure/work_precision.h"
#include "motion/simulate.h"

namespace taut {
RunTimes time_runs(const Model& model, const State& start, const Settings& settings, std::int64_t steps,
                   double enough) {
  using Clock = std::chrono::steady_clock;
  constexpr std::size_t wanted = 5, least = 2;
  const PinnedThread pinned;
  RunTimes times;
  double spent = 0.0;
  while (times.wall.size() < wanted && (times.wall.size() < least || spent < enough)) {
    State state = start;
    const auto begin = Clock::now();
    const double processor_begin = processor_seconds();
    simulate(model, state, settings, steps, chart_policy);
    times.processor.push_back(processor_seconds() - processor_begin);
    times.wall.push_back(std::chrono::duration<double>(Clock::now() - begin).count());
    spent += times.wall.back();
  }
  return times;
}

}  // namespace taut
