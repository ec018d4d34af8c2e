#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/failure.h"
#include "command_line.h"
#include "exit_status.h"
#include "host/machine.h"
#include "host/progress.h"
#include "interrupted.h"
#include "methods/simd.h"
#include "study/speed.h"
#include "values.h"
#include "verbs.h"

namespace taut {
namespace {

struct BenchFlags {
  std::string seconds = "0.3";
  bool json = false, quiet = false;
};

void print_table(const std::vector<Speed>& speeds) {
  const Machine machine = this_machine();
  fmt::print("{}, {} cores, {}; steps of one pass at 2400 steps/s\n", machine.processor, machine.threads,
             simd_targets().front());
  fmt::print("{:<20} {:<12} {:>7} {:>9} {:>12} {:>12}\n", "model", "method", "threads", "links", "µs a step",
             "ns a link");
  for (const Speed& speed : speeds)
    fmt::print("{:<20} {:<12} {:>7} {:>9} {:>12.1f} {:>12.2f}\n", speed.model, speed.method, speed.threads,
               speed.links, 1e6 * speed.step, 1e9 * speed.per_link);
}

void print_json(const std::vector<Speed>& speeds) {
  const Machine machine = this_machine();
  nlohmann::ordered_json json{{"processor", machine.processor},
                              {"cores", machine.threads},
                              {"simd", simd_targets().front()},
                              {"build", machine.build},
                              {"speeds", nlohmann::ordered_json::array()}};
  for (const Speed& speed : speeds)
    json["speeds"].push_back({{"model", speed.model},
                              {"method", speed.method},
                              {"threads", speed.threads},
                              {"masses", speed.masses},
                              {"links", speed.links},
                              {"seconds_per_step", speed.step},
                              {"seconds_per_link", speed.per_link}});
  fmt::print("{}\n", json.dump(2));
}

int bench(const BenchFlags& flags) {
  constexpr double longest = 60.0;
  const double seconds = parse_seconds("--seconds", flags.seconds);
  if (!(seconds > 0.0 && seconds <= longest))
    throw BadRequest(fmt::format("--seconds is above 0 and at most {}, not {}", longest, flags.seconds));
  const InterruptWatch interrupts(end_at_once);
  return unless_interrupted(interrupts, "nothing was measured", [&] {
    Progress progress(stderr, progress_style(stderr, flags.quiet), "ways of running a model");
    const auto done = [&](std::size_t count, std::size_t of) {
      if (count == 1) progress.start(static_cast<int>(of));
      progress.update(static_cast<int>(count));
    };
    const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const std::vector<Speed> speeds = measure_speed(seconds, threads, done, stop_test(interrupts));
    progress.finish();
    flags.json ? print_json(speeds) : print_table(speeds);
    return exit_done;
  });
}

}  // namespace

void add_bench(CommandLine& program) {
  const auto flags = std::make_shared<BenchFlags>();
  Verb* verb = program.add_subcommand("bench", "How fast the methods are on this machine");
  verb->add_option("--seconds", flags->seconds, "Time to spend on each, such as 0.3s")->capture_default_str();
  verb->add_flag("--json", flags->json, "Print JSON on stdout");
  verb->add_flag("--quiet", flags->quiet, "No progress");
  verb->footer("Numbers mean something only on a machine that does nothing else.\n\nExample:\n  taut bench");
  verb->action([flags] { return bench(*flags); });
}

}  // namespace taut
