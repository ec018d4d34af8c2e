// What a strain costs: a sheet of 64 × 64 masses and rigid links along its rows and columns, 1 m wide, no
// damping, let go level, 5 s, by methods and steps per second, on one thread: hung by its top row, or by two
// corners. five_seconds() has the counters.
#include <string>
#include <utility>
#include <vector>

#include "frames.h"

namespace {

using namespace taut;

Description hung_sheet(const std::vector<std::string>& pins) {
  SheetSpec cloth;
  cloth.name = "cloth";
  cloth.rows = cloth.columns = 64;
  cloth.from = {0.0, 2.0, 0.0};
  cloth.to = {1.0, 2.0, 0.0};
  cloth.down = {0.0, 0.0, 1.0};
  cloth.mass = 0.3;
  cloth.pinned = pins;
  Description description;
  description.sheets = {cloth};
  return description;
}

// `choice`: of a parameter, where there is one, as name and word.
void hung(benchmark::State& run, const char* method, const std::pair<const char*, const char*>& choice,
          const std::vector<std::string>& pins) {
  const Built built = bench::build_valid(hung_sheet(pins));
  Settings how = bench::settings(method, static_cast<double>(run.range(0)));
  if (*choice.first != '\0') how.values[choice.first] = std::string(choice.second);
  bench::five_seconds(run, built, complete_settings(how));
}

#define HUNG_SHEET(label, ...)                \
  BENCHMARK_CAPTURE(hung, label, __VA_ARGS__) \
      ->ArgName("steps/s")                    \
      ->Unit(benchmark::kMillisecond)         \
      ->Iterations(1)
const std::pair<const char*, const char*> as_usual{"", ""}, single{"precision", "single"},
    lines{"relax", "lines"};

// In single precision still shorter steps lose what gravity adds in one of them.
HUNG_SHEET(by_the_top_row_xpbd, "xpbd", as_usual, {"top"})->Arg(960)->Arg(3840)->Arg(7680)->Arg(15360);
HUNG_SHEET(by_the_top_row_xpbd_single, "xpbd", single, {"top"})->Arg(960)->Arg(3840)->Arg(7680);
HUNG_SHEET(by_the_top_row_xpbd_lines, "xpbd", lines, {"top"})->Arg(240)->Arg(480)->Arg(960);
HUNG_SHEET(by_the_top_row_newton, "newton", as_usual, {"top"})->Arg(60);
HUNG_SHEET(by_two_corners_xpbd, "xpbd", as_usual, {"top-left", "top-right"})
    ->Arg(960)
    ->Arg(3840)
    ->Arg(15360)
    ->Arg(30720);
HUNG_SHEET(by_two_corners_xpbd_lines, "xpbd", lines, {"top-left", "top-right"})
    ->Arg(960)
    ->Arg(3840)
    ->Arg(15360);

}  // namespace
