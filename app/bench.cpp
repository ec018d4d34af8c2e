#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/failure.h"
#include "base/json_text.h"
#include "command_line.h"
#include "exit_status.h"
#include "flags.h"
#include "host/machine.h"
#include "host/progress.h"
#include "host/standard_streams.h"
#include "interrupted.h"
#include "methods/simd.h"
#include "stages.h"
#include "study/frame_speed.h"
#include "study/speed.h"
#include "values.h"
#include "verbs.h"

namespace taut {
namespace {

// What `taut render` is shown off with.
constexpr std::array<const char*, 3> showcases{"hanging-chain", "curtain", "breaking-cloth"};

struct BenchFlags {
  std::string seconds = "0.3", frames = "60";
  bool json = false, quiet = false;
};

// What was measured.
struct Measured {
  std::vector<Speed> speeds;
  std::vector<FrameSpeed> frames;
};

void print_frames(const std::vector<FrameSpeed>& speeds) {
  for (const FrameSpeed& speed : speeds) {
    print_result("\n{}: {} frames and a film at {}x{}: {:.1f} frames/s, the first file after {:.2f} s\n",
                 speed.scene, speed.frames, speed.size.width, speed.size.height,
                 static_cast<double>(speed.frames) / speed.seconds, speed.first_file);
    print_result("  {}\n", stages_text(speed.stages, speed.frames));
  }
}

void print_table(const Measured& measured) {
  const Machine machine = this_machine();
  print_result("{}, {} cores, {}; steps of one pass at 2400 steps/s\n", machine.processor, machine.threads,
               simd_targets().front());
  print_result("{:<20} {:<12} {:>7} {:>9} {:>12} {:>12}\n", "model", "method", "threads", "links",
               "µs a step", "ns a link");
  for (const Speed& speed : measured.speeds)
    print_result("{:<20} {:<12} {:>7} {:>9} {:>12.1f} {:>12.2f}\n", speed.model, speed.method, speed.threads,
                 speed.links, 1e6 * speed.step, 1e9 * speed.per_link);
  print_frames(measured.frames);
}

void print_json(const Measured& measured) {
  using Json = nlohmann::ordered_json;
  const Machine machine = this_machine();
  Json json{{"processor", machine.processor}, {"cores", machine.threads}, {"simd", simd_targets().front()},
            {"build", machine.build},         {"speeds", Json::array()},  {"frames", Json::array()}};
  for (const Speed& speed : measured.speeds)
    json["speeds"].push_back({{"model", speed.model},
                              {"method", speed.method},
                              {"threads", speed.threads},
                              {"masses", speed.masses},
                              {"links", speed.links},
                              {"seconds_per_step", speed.step},
                              {"seconds_per_link", speed.per_link}});
  for (const FrameSpeed& speed : measured.frames) {
    json["frames"].push_back({{"scene", speed.scene},
                              {"width", speed.size.width},
                              {"height", speed.size.height},
                              {"frames", speed.frames},
                              {"seconds", speed.seconds},
                              {"seconds_to_first_file", speed.first_file},
                              {"stage_seconds", stages_to_json(speed.stages)}});
  }
  print_result("{}\n", json_text(json, 2));
}

std::vector<FrameSpeed> measure_showcases(int frames, bool quietly, const StopTest& stop) {
  if (frames == 0) return {};
  std::vector<Scene> scenes;
  scenes.reserve(showcases.size());
  for (const char* name : showcases) scenes.push_back(load(name, {}, quietly));
  Progress progress(stderr, progress_style(stderr, quietly), "showcases");
  progress.start(static_cast<int>(scenes.size()));
  int count = 0;
  std::vector<FrameSpeed> speeds = measure_frames(
      scenes, frames, static_cast<int>(this_machine().threads), [&] { progress.update(++count); }, stop);
  progress.finish();
  return speeds;
}

int bench(const BenchFlags& flags) {
  constexpr double longest = 60.0;
  const double seconds = parse_seconds("--seconds", flags.seconds);
  if (!(seconds > 0.0 && seconds <= longest))
    throw BadRequest(fmt::format("--seconds is above 0 and at most {}, not {}", longest, flags.seconds));
  constexpr double most = 1000.0;
  const double frames = parse_number("--frames", flags.frames);
  if (!(frames >= 0.0 && frames <= most) || frames != std::floor(frames))
    throw BadRequest(fmt::format("--frames is a whole number from 0 to {}, not {}", most, flags.frames));
  const InterruptWatch interrupts(end_at_once);
  return unless_interrupted(interrupts, "nothing was measured", [&] {
    Progress progress(stderr, progress_style(stderr, flags.quiet), "ways of running a model");
    const auto done = [&](std::size_t count, std::size_t of) {
      if (count == 1) progress.start(static_cast<int>(of));
      progress.update(static_cast<int>(count));
    };
    const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    Measured measured;
    measured.speeds = measure_speed(seconds, threads, done, stop_test(interrupts));
    progress.finish();
    measured.frames = measure_showcases(static_cast<int>(frames), flags.quiet, stop_test(interrupts));
    flags.json ? print_json(measured) : print_table(measured);
    return exit_done;
  });
}

}  // namespace

void add_bench(CommandLine& program) {
  const auto flags = std::make_shared<BenchFlags>();
  Verb* verb = program.add_subcommand("bench", "How fast methods, frames and films are on this machine");
  verb->add_option("--seconds", flags->seconds, "Time to spend on each method, such as 0.3s")
      ->capture_default_str();
  verb->add_option("--frames", flags->frames, "Frames to make of each showcase, with a film; 0: none")
      ->capture_default_str();
  verb->add_flag("--json", flags->json, "Print JSON on stdout");
  verb->add_flag("--quiet", flags->quiet, "No progress");
  verb->footer("Numbers mean something only on a machine that does nothing else.\n\nExample:\n  taut bench");
  verb->action([flags] { return bench(*flags); });
}

}  // namespace taut
