#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "base/failure.h"
#include "base/split.h"
#include "choices.h"
#include "command_line.h"
#include "exit_status.h"
#include "flags.h"
#include "frames/film_frames.h"
#include "frames/frame_selection.h"
#include "frames/simulation.h"
#include "frames/still.h"
#include "host/patience.h"
#include "host/standard_streams.h"
#include "interrupted.h"
#include "methods/registry.h"
#include "output/atomic_file.h"
#include "output/csv.h"
#include "planning.h"
#include "values.h"
#include "verbs.h"

namespace taut {
namespace {

struct ExportFlags {
  SceneFlags scene;
  PlanFlags plan;
  std::string format = "csv", table = "masses", times, rate = "30", file;
  bool quiet = false, certify = false;
};

// An instant to be exported, and the number it goes by.
struct Instant {
  int frame;
  double time;  // s
};

// The times of --times in rising order, numbered from 1; or those of all frames.
std::vector<Instant> instants(const ExportFlags& flags, const Scene& scene) {
  std::vector<Instant> result;
  if (flags.times.empty()) {
    const FrameRate rate = parse_frame_rate("--fps", flags.rate);
    for (const int frame : all_frames(film_frame_count(scene, rate)))
      result.push_back({frame, shown_time(scene, frame, rate)});
    return result;
  }
  for (const std::string_view part : split(flags.times, ',')) {
    const double time = parse_seconds("--times", part);
    if (time < 0.0 || (!result.empty() && time <= result.back().time))
      throw BadRequest(fmt::format("--times must rise from 0 s on, and {} s does not", time));
    result.push_back({static_cast<int>(result.size()) + 1, time});
  }
  check_times(scene, {result.back().time});
  return result;
}

// Where the table goes: a file that is only there when it is whole, or stdout.
class Sink {
 public:
  explicit Sink(const std::string& file) {
    if (file.empty() || file == "-") return;
    sweep_leftovers(std::filesystem::path(file).parent_path());
    pending_.emplace(file);
  }
  void write(const std::string& text) {
    if (pending_)
      pending_->write(std::as_bytes(std::span(text)));
    else
      write_result(text);
  }
  void finish() {
    if (pending_) pending_->commit();
    if (!pending_) finish_results();
  }

 private:
  std::optional<PendingFile> pending_;
};

enum class Table { masses, links, orientations };
constexpr std::array<std::string_view, 3> table_names{"masses", "links", "orientations"};
constexpr std::array<std::string_view, 1> formats{"csv"};

Table parse_table(const std::string& text) {
  if (text == "masses") return Table::masses;
  if (text == "links") return Table::links;
  if (text == "orientations") return Table::orientations;
  not_one_of("--table", text, table_names);
}

std::string header(Table table) {
  switch (table) {
    case Table::masses:
      return mass_table_header();
    case Table::links:
      return link_table_header();
    case Table::orientations:
      return orientation_table_header();
  }
  return {};
}

// A method knows tensions once it has made a step, or never.
bool tension_known(const Scene& scene, const State& state) {
  return find_method(scene.settings.method)->can.tension_order > 0 && state.time > scene.start.time;
}

std::string rows(Table table, const Scene& scene, const State& state, int frame) {
  switch (table) {
    case Table::masses:
      return mass_table_rows(scene.model, state, frame);
    case Table::links:
      return link_table_rows(scene.model, state, frame, tension_known(scene, state));
    case Table::orientations:
      return orientation_table_rows(scene.model, scene.start, state, frame);
  }
  return {};
}

int export_motion(const ExportFlags& flags) {
  if (flags.format != formats.front()) not_one_of("--format", flags.format, formats);
  const Table table = parse_table(flags.table);
  const Execution execution = on_threads(flags.scene.thread_count(flags.certify ? 1 : 0));
  Scene scene = load(flags.scene.scene, flags.scene.overrides(), flags.quiet);
  print_notes(scene, flags.quiet);
  const std::vector<Instant> wanted = instants(flags, scene);
  const InterruptWatch interrupts(end_at_once);
  return unless_interrupted(interrupts, "nothing was written", [&]() -> int {
    const StopTest stop = stop_test(interrupts);
    const std::optional<Plan> plan = settle_method(scene, flags.plan, flags.scene.method, flags.quiet, stop);
    const Patience patience(stderr, flags.quiet, "at the table");
    Simulation simulation(scene, execution);
    std::optional<Certifier> certifier;
    if (flags.certify) certifier.emplace(scene, stop);
    Sink sink(flags.file);
    sink.write(header(table));
    for (const Instant& instant : wanted) {
      if (certifier) certifier->see_until(simulation, instant.time);
      const std::optional<State> state = simulation.at(instant.time, stop);
      if (!state)
        return report_interrupted(interrupts, flags.file.empty()
                                                  ? fmt::format("the table ends before {} s", instant.time)
                                                  : "no file was written");
      sink.write(rows(table, scene, simulation.reported(*state), instant.frame));
    }
    sink.finish();
    if (plan && !flags.quiet) print_accuracy(*plan);
    if (!certifier) return exit_done;
    return unless_interrupted(interrupts, "the table is whole, but there is no certificate", [&] {
      certifier->see_until(simulation, scene.duration);
      const Certificate certificate = certifier->finish();
      if (!flags.quiet) print_certificate(certificate);
      return exit_done;
    });
  });
}

}  // namespace

void add_export(CommandLine& program) {
  Verb* verb = program.add_subcommand("export", "The motion of a scene as a table, for other tools");
  const auto flags = std::make_shared<ExportFlags>();
  flags->scene.add_to(*verb);
  flags->scene.add_threads_to(*verb);
  verb->add_option("--format", flags->format, "csv")->one_of(as_words(formats))->capture_default_str();
  verb->add_option("--table", flags->table, "masses, links or orientations")
      ->one_of(as_words(table_names))
      ->capture_default_str();
  verb->add_option("--times", flags->times,
                   "These instants, exactly, such as 0.5,1.0; else those of all frames");
  verb->add_option("--fps", flags->rate, "Frames per second, such as 30 or 24000/1001")
      ->capture_default_str();
  verb->add_option("-o,--output", flags->file, "The file; replaced when it exists [stdout]")
      ->names_a(ValueKind::file);
  flags->plan.add_to(*verb);
  add_certify(*verb, flags->certify);
  verb->add_flag("--quiet", flags->quiet, "No messages but errors");
  verb->footer("Example:\n  taut export pendulum --format csv --times 0.5,1.0 --table links -o links.csv");
  verb->action([flags] { return export_motion(*flags); });
}

}  // namespace taut
