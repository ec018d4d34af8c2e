#include "output/export.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/failure.h"
#include "base/json_text.h"
#include "choices.h"
#include "command_line.h"
#include "exit_status.h"
#include "export_choice.h"
#include "flags.h"
#include "frames/colouring.h"
#include "frames/hidden_folder.h"
#include "frames/simulate.h"
#include "host/patience.h"
#include "host/progress.h"
#include "host/standard_streams.h"
#include "interrupted.h"
#include "measures_json.h"
#include "model/measures.h"
#include "moments.h"
#include "output/atomic_file.h"
#include "planning.h"
#include "render/appearance.h"
#include "values.h"
#include "verbs.h"

namespace taut {
namespace {

using Json = nlohmann::ordered_json;

struct ExportFlags {
  SceneFlags scene;
  PlanFlags plan;
  ExportChoice choice;
  InstantFlags instants;
  std::string motion;
  bool json = false, quiet = false, certify = false;
};

// A motion that is to be exported, and how.
struct ExportJob {
  Scene scene;
  std::shared_ptr<const MotionReader> motion;  // null: the scene is simulated
  const ExportFormat& format;
  FrameRate rate;
  std::vector<Instant> instants;
};

// One file that is only there when it is whole, or stdout; or a folder of files.
class ExportPlace {
 public:
  ExportPlace(const ExportChoice& choice, const ExportFormat& format) {
    if (format.layout != ExportLayout::one_file) {
      lock_ = make_export_folder(format, choice.output);
      target_.folder = choice.output;
    } else if (goes_to_stdout(choice)) {
      target_.folder = std::filesystem::temp_directory_path();
      target_.write = [](std::string_view bytes) { write_result(bytes); };
    } else {
      target_.folder = std::filesystem::path(choice.output).parent_path();
      sweep_leftovers(target_.folder);
      pending_.emplace(choice.output);
      target_.write = [this](std::string_view bytes) { pending_->write(std::as_bytes(std::span(bytes))); };
    }
  }
  ExportPlace(const ExportPlace&) = delete;
  ExportPlace& operator=(const ExportPlace&) = delete;

  const ExportTarget& target() const { return target_; }
  void finish() {
    if (pending_) pending_->commit();
    if (!pending_) finish_results();
  }

 private:
  std::unique_ptr<FolderLock> lock_;
  std::optional<PendingFile> pending_;
  ExportTarget target_;
};

ExportJob job_of_motion(const ExportFlags& flags, const ExportFormat& format) {
  if (!flags.scene.scene.empty()) throw BadRequest("a SCENE and --motion are two things to export: name one");
  if (!flags.plan.accuracy.empty() || flags.certify || !flags.scene.method.empty())
    throw BadRequest(
        "with --motion nothing is simulated: neither --method nor --accuracy nor --certify goes with it");
  const StoredMotion motion = open_motion(flags.motion);
  Scene scene = scene_of_motion(motion, flags.motion, flags.scene.overrides());
  require_same_motion(scene, motion);
  const FrameRate rate = parse_frame_rate(
      "--fps", flags.instants.rate.empty() ? motion.manifest.frame_rate : flags.instants.rate);
  std::vector<Instant> instants = chosen_instants(flags.instants, scene, rate);
  for (const Instant& instant : instants)
    if (motion.reader->find(instant.time) == nullptr)
      throw BadRequest(fmt::format("{} has no moment at {} s; it has those of {} frames a second",
                                   flags.motion, instant.time, motion.manifest.frame_rate));
  return {std::move(scene), motion.reader, format, rate, std::move(instants)};
}

ExportJob job_of_scene(const ExportFlags& flags, const ExportFormat& format) {
  if (flags.scene.scene.empty())
    throw BadRequest("there is nothing to export: name a SCENE, or --motion FOLDER");
  Scene scene = load(flags.scene.scene, flags.scene.overrides(), flags.quiet);
  const FrameRate rate = parse_frame_rate("--fps", flags.instants.rate.empty() ? "30" : flags.instants.rate);
  std::vector<Instant> instants = chosen_instants(flags.instants, scene, rate);
  return {std::move(scene), nullptr, format, rate, std::move(instants)};
}

ExportJob job_of(const ExportFlags& flags) {
  const ExportFormat& format = chosen_format(flags.choice);
  ExportJob job = flags.motion.empty() ? job_of_scene(flags, format) : job_of_motion(flags, format);
  if (format.evenly && !flags.instants.times.empty() && !are_even(job.instants))
    throw BadRequest(fmt::format("{} takes instants that are an equal time apart, which --times {} are not",
                                 format.name, flags.instants.times));
  return job;
}

// Cloth and net, and all colours, as the scene's look has them.
ExportSubject subject_of(const ExportJob& job, ExportTable table) {
  const Look& look = job.scene.look;
  ExportSubject subject{job.scene.model, job.scene.start, job.scene.title, {}, job.rate};
  subject.table = table;
  subject.times.reserve(job.instants.size());
  for (const Instant& instant : job.instants) subject.times.push_back(instant.time);
  for (std::size_t i = 0; i < job.scene.model.sheets.size(); ++i) {
    const ObjectLook& own = look_of(look.objects.sheets, i);
    subject.faces.push_back(own.draw ? std::ranges::count(*own.draw, "surface") > 0 : look.surface);
    subject.colours.sheets.push_back(own.colour.value_or(look.surface_colour));
  }
  subject.colours.links = look.link_colour;
  subject.colours.masses = look.mass_colour;
  return subject;
}

// What is there of an export that was interrupted before an instant.
std::string what_is_there(const ExportFlags& flags, const ExportJob& job, std::size_t done) {
  if (job.format.layout == ExportLayout::file_a_frame)
    return fmt::format("{} of {} frames are there", done, job.instants.size());
  if (goes_to_stdout(flags.choice) && job.format.streams)
    return fmt::format("the table ends before {} s", job.instants[done].time);
  return "no file was written";
}

// Where the states come from. A run that fills a file or a folder is kept until that is there; one that is
// watched for a certificate has to be seen from its start on.
MomentSource source_of(const ExportFlags& flags, const ExportJob& job, const Execution& execution) {
  if (job.motion || flags.certify || goes_to_stdout(flags.choice)) return {job.scene, job.motion, execution};
  std::vector<double> times;
  times.reserve(job.instants.size());
  for (const Instant& instant : job.instants) times.push_back(instant.time);
  return {job.scene, std::move(times), hidden_folder(flags.choice.output, "motion"), execution};
}

void tell_what_was_kept(const ExportFlags& flags, MomentSource& source) {
  const KeptRun* kept = source.kept();
  if (kept == nullptr || flags.quiet || !kept->resumed_at()) return;
  tell("taut: note: the run goes on at {:.6g} s, where one before was stopped\n", *kept->resumed_at());
}

// What became of an export that was interrupted before an instant.
std::string what_became(const ExportFlags& flags, const ExportJob& job, MomentSource& source,
                        std::size_t done) {
  const bool goes_on = source.kept() != nullptr && source.kept()->keeps();
  return (goes_on ? "running the same again goes on; " : "") + what_is_there(flags, job, done);
}

// What the format can't show of what happened.
void tell_of_breaks(const ExportFormat& format, const State& last) {
  const std::size_t broken = broken_links(last);
  if (broken == 0 || format.shows_breaks) return;
  tell("taut: note: {} {} broken at {} s, and {} shows none of it: what it holds stays whole\n", broken,
       broken == 1 ? "link is" : "links are", last.time, format.name);
}

// Writes every instant, and leaves the state at the last. Returns how many; fewer than asked for when told to
// stop.
std::size_t write_instants(const ExportJob& job, ExportTable table, MomentSource& source,
                           std::optional<Certifier>& certifier, MotionExport& writer, Progress& progress,
                           const StopTest& stop, std::optional<State>& last) {
  progress.start(static_cast<int>(job.instants.size()));
  for (std::size_t i = 0; i < job.instants.size(); ++i) {
    const auto [frame, time] = job.instants[i];
    if (certifier) certifier->see_until(*source.simulation(), time);
    std::optional<State> state = source.at(time, stop);
    if (!state) return i;
    ExportMoment moment{frame, *state, tension_known(job.scene, time)};
    if (table == ExportTable::energy) moment.measures = source.measures();
    writer.add(moment);
    last = std::move(state);
    progress.update(static_cast<int>(i) + 1);
  }
  writer.finish();
  progress.finish();
  return job.instants.size();
}

void print_export(const ExportFlags& flags, const ExportJob& job, const State& last,
                  const std::optional<Plan>& plan, const std::optional<Certificate>& certificate) {
  Json json{{"scene", job.scene.name},
            {"method", job.scene.settings.method},
            {"format", job.format.name},
            {"output", flags.choice.output},
            {"frames", job.instants.size()},
            {"frames_per_second", job.rate.value()},
            {"broken_links", broken_links(last)},
            {"last_state_hash", fmt::format("{:016x}", state_hash(last))}};
  if (plan) json["plan"] = plan_to_json(*plan);
  if (certificate) json["certificate"] = certificate_to_json(*certificate);
  print_result("{}\n", json_text(json, 2));
}

int export_motion(const ExportFlags& flags) {
  const ExportTable table = parse_export_table(flags.choice.table);
  if (flags.json && goes_to_stdout(flags.choice))
    throw BadRequest("--json needs -o FILE: the export and it can't both go to standard output");
  const Execution execution = on_threads(flags.scene.thread_count(flags.certify ? 1 : 0));
  ExportJob job = job_of(flags);
  print_notes(job.scene, flags.quiet);
  const InterruptWatch interrupts(end_at_once);
  return unless_interrupted(interrupts, "nothing was written", [&]() -> int {
    const StopTest stop = stop_test(interrupts);
    std::optional<Plan> plan;
    if (!job.motion) plan = settle_method(job.scene, flags.plan, flags.scene.method, flags.quiet, stop);
    const bool to_stdout = goes_to_stdout(flags.choice);
    const Patience patience(stderr, flags.quiet || !to_stdout, "at the export");
    Progress progress(stderr, to_stdout ? ProgressStyle::none : progress_style(stderr, flags.quiet),
                      "frames");
    MomentSource source = source_of(flags, job, execution);
    tell_what_was_kept(flags, source);
    std::optional<Certifier> certifier;
    if (flags.certify) certifier.emplace(job.scene, stop);
    ExportPlace place(flags.choice, job.format);
    const std::unique_ptr<MotionExport> writer = job.format.make(subject_of(job, table), place.target());
    std::size_t done = 0;
    std::optional<State> last;
    try {
      done = write_instants(job, table, source, certifier, *writer, progress, stop, last);
    } catch (...) {
      writer->end_early();
      throw;
    }
    if (done < job.instants.size()) {
      writer->end_early();
      progress.finish();
      return report_interrupted(interrupts, what_became(flags, job, source, done));
    }
    place.finish();
    if (source.kept() != nullptr) source.kept()->remove();
    if (!flags.quiet) tell_of_breaks(job.format, *last);
    if (plan && !flags.quiet) print_accuracy(*plan);
    std::optional<Certificate> certificate;
    const int certified = unless_interrupted(interrupts, "all is whole, but there is no certificate", [&] {
      if (!certifier) return exit_done;
      certifier->see_until(*source.simulation(), job.scene.duration);
      certificate = certifier->finish();
      if (!flags.quiet) print_certificate(*certificate);
      return exit_done;
    });
    if (flags.json && certified == exit_done) print_export(flags, job, *last, plan, certificate);
    return certified;
  });
}

std::string format_help() {
  return fmt::format("One of {}; `taut list formats` says more [by the ending of -o, or csv]",
                     fmt::join(export_format_names(), ", "));
}

}  // namespace

void add_export(CommandLine& program) {
  Verb* verb =
      program.add_subcommand("export", "The motion of a scene for other tools: tables, meshes, animations");
  const auto flags = std::make_shared<ExportFlags>();
  flags->scene.add_to(*verb, "; not needed with --motion");
  flags->scene.add_threads_to(*verb);
  verb->add_option("--format", flags->choice.format, format_help())->one_of(as_words(export_format_names()));
  verb->add_option("--table", flags->choice.table,
                   "Of csv and npz: masses, links, orientations or energy [masses; npz: masses and links]")
      ->one_of(as_words(export_table_names));
  verb->add_option("--motion", flags->motion,
                   "Export what `taut simulate` left in this folder instead of simulating a SCENE")
      ->names_a(ValueKind::folder);
  verb->add_option("--times", flags->instants.times,
                   "These instants, exactly, such as 0.5,1.0; else those of all frames")
      ->with_commas();
  verb->add_option("--fps", flags->instants.rate,
                   "Frames per second, such as 30 or 24000/1001 [30, or those of the motion]");
  verb->add_option("--every", flags->instants.every, "Only every so many frames, such as 2");
  verb->add_option("-o,--output", flags->choice.output,
                   "The file, or the folder of files; replaced when it exists [stdout]")
      ->names_a(ValueKind::file);
  flags->plan.add_to(*verb);
  add_certify(*verb, flags->certify);
  verb->add_flag("--json", flags->json, "Print what was exported as JSON on stdout; needs -o");
  verb->add_flag("--quiet", flags->quiet, "No messages but errors");
  verb->footer(
      "Example:\n  taut export pendulum --times 0.5,1.0 --table links -o links.csv\n"
      "  taut export curtain -o curtain.npz\n"
      "  taut export curtain --format vtp -o out/curtain-vtp\n"
      "  taut export curtain --every 2 -o curtain.glb\n"
      "  taut export --motion motion --format pc2 -o out/curtain-pc2");
  verb->action([flags] { return export_motion(*flags); });
}

}  // namespace taut
