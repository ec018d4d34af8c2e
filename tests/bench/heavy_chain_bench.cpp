// Hard chains with newton, released level, 5 s: 1000 masses over 1 m with the last one 100 times heavier, and
// 1000 links of 10 mm of equal masses. Beside what five_seconds() shows, the counters have halvings and
// rounds.
#include "frames.h"

namespace {

using namespace taut;

void chain(benchmark::State& run, const Description& description) {
  const Built built = bench::build_valid(description);
  const StepReport total =
      bench::five_seconds(run, built, bench::settings("newton", static_cast<double>(run.range(0))));
  run.counters["halvings"] = static_cast<double>(total.halvings) / static_cast<double>(run.iterations());
  run.counters["rounds"] = static_cast<double>(total.rounds) / static_cast<double>(run.iterations());
}

void heavy_tip(benchmark::State& run) {
  chain(run, bench::level_chain(999, 1.0 / 999.0, 100.0));
}
BENCHMARK(heavy_tip)->Arg(60)->Arg(240)->Arg(960)->Unit(benchmark::kMillisecond)->Iterations(1);

void thousand_links(benchmark::State& run) {
  chain(run, bench::level_chain(1000, 0.01));
}
BENCHMARK(thousand_links)->Arg(60)->Arg(240)->Arg(960)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
