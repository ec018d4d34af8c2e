// How far the prices that times are foretold by are from what steps cost: foretold over measured, processor
// time, on chains and on nets hung by a corner, of rigid links and of springs. Prices are of an ordinary
// machine, so what counts is that rows agree with each other.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "base/processor_time.h"
#include "bench_scenes.h"
#include "measure/cost.h"

namespace {

using namespace taut;

constexpr double spring = 2e4;  // N/m

void foretold(benchmark::State& run, Description description, const Settings& settings, bool springs) {
  if (springs) {
    for (ChainSpec& chain : description.chains) chain.properties.stiffness = spring;
    for (SheetSpec& sheet : description.sheets) sheet.properties.stiffness = spring;
  }
  const Built built = bench::build_valid(description);
  Run motion(built.model, built.start, complete_settings(settings));
  const std::int64_t at_once = std::max<std::int64_t>(1, 3200 / std::ssize(built.model.links.stiffness));
  const auto step = [&] {
    for (std::int64_t i = 0; i < at_once; ++i)
      if (!motion.step()) throw std::runtime_error(motion.failure());
  };
  step();
  const double work = predicted_seconds(built.model, motion), begin = processor_seconds();
  for (auto round : run) step();
  run.counters["foretold/measured"] =
      (predicted_seconds(built.model, motion) - work) / (processor_seconds() - begin);
}

void on_chain(benchmark::State& run, const Settings& settings, bool springs) {
  foretold(run, bench::swinging_chain(static_cast<int>(run.range(0))), settings, springs);
}

void on_net(benchmark::State& run, const Settings& settings, bool springs) {
  foretold(run, bench::hung_net(static_cast<int>(run.range(0))), settings, springs);
}

Settings at_pace(std::string method) {
  return method == "dop853" ? Settings{method, {{"tolerance", 1e-6}}} : bench::settings(method, 1920);
}

[[maybe_unused]] const bool registered = [] {
  for (const char* name : {"xpbd", "shake", "verlet", "newton", "rattle", "dop853", "spring-implicit"}) {
    const std::string method = name;
    // The one method that has no rigid links.
    const bool springs = method == "spring-implicit";
    benchmark::RegisterBenchmark((method + "/chain").c_str(), on_chain, at_pace(method), springs)
        ->RangeMultiplier(10)
        ->Range(100, 10000)
        ->Arg(20);
    benchmark::RegisterBenchmark((method + "/net").c_str(), on_net, at_pace(method), springs)
        ->Arg(10)
        ->Arg(32)
        ->Arg(64);
  }
  benchmark::RegisterBenchmark("dop853/chain of springs", on_chain, at_pace("dop853"), true)
      ->Arg(100)
      ->Arg(1000);
  benchmark::RegisterBenchmark("newton/chain of springs", on_chain, at_pace("newton"), true)
      ->Arg(100)
      ->Arg(1000);
  return true;
}();

}  // namespace
