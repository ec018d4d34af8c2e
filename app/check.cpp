#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/failure.h"
#include "base/json_text.h"
#include "command_line.h"
#include "errors_json.h"
#include "exit_status.h"
#include "explain.h"
#include "flags.h"
#include "frames/colouring.h"
#include "frames/exact_shape.h"
#include "frames/simulation.h"
#include "host/patience.h"
#include "host/standard_streams.h"
#include "interrupted.h"
#include "measure/expectation.h"
#include "measures_json.h"
#include "model/measures.h"
#include "planning.h"
#include "study/reference_cache.h"
#include "verbs.h"

namespace taut {
namespace {

using Json = nlohmann::ordered_json;

struct CheckFlags {
  std::vector<std::string> scenes;
  SceneFlags changes;
  bool explain = false, run = false, reference = false, certify = false, json = false, resolved = false,
       quiet = false;
};

// What came of checking one scene.
struct Verdict {
  int status = exit_done;
  std::string message;  ///< for people, about what is wrong; empty when nothing is
  Json json;
  std::string explanation;  ///< for people
  std::optional<Certificate> certificate;
};

Json finding_to_json(const Finding& finding) {
  return {{"key", finding.key}, {"holds", finding.holds}, {"text", finding.text}};
}

// How far the run is from what is certified to be true, at the latest time where anything is.
Json error_against_reference(const Scene& scene, const StopTest& stop) {
  constexpr int instants = 8;
  const double length = total_link_length(scene.model);
  const double accuracy = 1e-6 * (length > 0.0 ? length : scene_size(scene.model, scene.start));
  std::vector<double> times;
  for (int i = 1; i <= instants; ++i) times.push_back(scene.duration * i / instants);
  const Reference reference = cached_reference(scene, times, accuracy, reference_folder(), 10.0, stop);
  if (!reference.certified()) return {{"refused", reference.refusal}};
  Simulation simulation(scene);
  const std::optional<State> state = simulation.at(reference.certified_until, stop);
  if (!state) throw Interrupted();
  return {{"time", reference.certified_until},
          {"position_error", position_error(*state, reference.states.back())},
          {"uncertainty", reference.uncertainty},
          {"how", reference.how}};
}

// What free flight keeps: the angular momentum about the centre.
Json spin_to_json(const Scene& scene, const State& end) {
  const double at_start = spin(scene.model, scene.start).norm(), at_end = spin(scene.model, end).norm();
  return {{"at_start", at_start}, {"at_end", at_end}};
}

// Simulates the scene to its end and tests what it expects there.
void check_run(const Scene& scene, const Execution& execution, bool certify, const StopTest& stop,
               Verdict& verdict) {
  Simulation simulation(scene, execution);
  std::optional<Certifier> certifier;
  if (certify) {
    certifier.emplace(scene, stop);
    certifier->see_until(simulation, scene.duration);
    verdict.certificate = certifier->finish();
    verdict.json["certificate"] = certificate_to_json(*verdict.certificate);
  }
  const std::optional<State> end = simulation.at(scene.duration, stop);
  if (!end) throw Interrupted();
  verdict.json["steps"] = simulation.steps();
  verdict.json["state_hash"] = fmt::format("{:016x}", state_hash(*end));
  const RunMeasures measures = simulation.measures(*end);
  verdict.json["measures"] = measures_to_json(measures, scene);
  if (const std::string ruin = ruin_sentence(scene.model, measures); !ruin.empty()) {
    verdict.status = exit_failed;
    verdict.message = fmt::format("{}: {}", scene.name, ruin);
  }
  verdict.json["halvings"] = halving_sentence(scene.model, measures.report);
  if (flies_freely(scene.model)) verdict.json["spin"] = spin_to_json(scene, *end);
  verdict.json["findings"] = Json::array();
  for (const Finding& finding : check_expectation(scene.expectation, scene.model, *end, measures)) {
    verdict.json["findings"].push_back(finding_to_json(finding));
    if (finding.holds) continue;
    verdict.status = exit_failed;
    verdict.message += fmt::format("{}{}: {}: {}", verdict.message.empty() ? "" : "\n", scene.name,
                                   finding.key, finding.text);
  }
}

void describe(const Scene& scene, Json& json) {
  json["scene"] = scene.name;
  json["title"] = scene.title;
  json["masses"] = scene.model.masses.size();
  json["links"] = scene.model.links.size();
  json["duration"] = scene.duration;
  json["notes"] = scene.notes;
  json["method"] = scene.settings.method;
  if (scene.settings.chooses_steps())
    json["tolerance"] = scene.settings.number("tolerance");
  else
    json["steps_per_second"] = scene.settings.steps_per_second();
  json["pace"] = pace_text(scene.settings);
}

// Why the method can't do what the scene needs; empty where it can.
std::string refusal(const Scene& scene) {
  try {
    Simulation{scene};
    return {};
  } catch (const BadRequest& problem) {
    return problem.what();
  }
}

// All at once: what stands in the way of pictures of the scene, and of its run.
void require_all(const Scene& scene) {
  std::vector<std::string> problems{colour_problem(scene), exact_problem(scene), refusal(scene)};
  std::erase(problems, std::string());
  if (!problems.empty()) throw BadRequest(fmt::format("{}", fmt::join(problems, "\n")));
}

Verdict check_scene(const std::string& argument, const CheckFlags& flags, int threads, const StopTest& stop) {
  Verdict verdict;
  verdict.json = {{"scene", argument}, {"ok", true}};
  try {
    Scene scene = load(argument, flags.changes.overrides(), flags.quiet);
    const std::optional<Plan> plan = settle_method(scene, {}, flags.changes.method, flags.quiet, stop);
    require_all(scene);
    print_notes(scene, flags.quiet);
    describe(scene, verdict.json);
    if (plan) verdict.json["plan"] = plan_to_json(*plan);
    if (flags.resolved) verdict.json["resolved"] = resolved_toml(scene);
    if (flags.explain) {
      const Explanation explanation = explain(scene, stop);
      verdict.json["explanation"] = explanation_to_json(explanation);
      verdict.explanation = explanation_text(scene, explanation);
      if (plan) {
        verdict.json["plan"]["reasons"] = plan->reasons;
        verdict.explanation += reasons_text(*plan);
      }
    }
    if (flags.reference) verdict.json["reference"] = error_against_reference(scene, stop);
    const Patience patience(stderr, flags.quiet, fmt::format("at {}", scene.name));
    if (flags.run) check_run(scene, on_threads(threads), flags.certify, stop, verdict);
  } catch (const BadRequest& problem) {
    verdict.status = exit_bad_request;
    verdict.message = problem.what();
    verdict.json["errors"] = bad_request_to_json(problem);
  } catch (const RunFailure& problem) {
    verdict.status = exit_failed;
    verdict.message = problem.what();
  }
  verdict.json["ok"] = verdict.status == exit_done;
  if (!verdict.message.empty()) verdict.json["problem"] = verdict.message;
  return verdict;
}

void print_reference(const Json& reference) {
  if (reference.contains("refused"))
    print_result("  no certified reference: {}\n", reference["refused"].get<std::string>());
  else
    print_result("  position error {:.3g} m at {:.4g} s, against {}\n",
                 reference["position_error"].get<double>(), reference["time"].get<double>(),
                 reference["how"].get<std::string>());
}

void print_measures(const Json& measures) {
  const auto number = [&](const char* key) { return measures[key].get<double>(); };
  const std::string tension =
      measures["largest_tension"].is_null() ? "unknown" : fmt::format("{:.4g} N", number("largest_tension"));
  print_result(
      "  at {:.4g} s: strain {:.3g}, tension {}, energy error {:.3g} of the scale, sag {:.4g} m, {} "
      "broken\n",
      number("time"), measures["strain"]["largest"].get<double>(), tension, number("energy_error"),
      number("sag"), measures["broken_links"].get<std::int64_t>());
  print_result("  cost: {} link solves in {} rounds, {} factorisations, {} halvings\n",
               measures["link_solves"].get<std::int64_t>(), measures["rounds"].get<std::int64_t>(),
               measures["factorisations"].get<std::int64_t>(), measures["halvings"].get<std::int64_t>());
}

void print_spin(const Json& spin) {
  const double at_start = spin["at_start"].get<double>(), at_end = spin["at_end"].get<double>();
  const std::string share = at_start > 0.0 ? fmt::format(", {:.4g} %", 100.0 * at_end / at_start) : "";
  print_result(
      "  free flight: angular momentum about the centre {:.6g} kg m²/s at the start, {:.6g} at the end{}\n",
      at_start, at_end, share);
}

void print_verdict(const Verdict& verdict, const CheckFlags& flags) {
  if (!verdict.message.empty()) tell("taut: {}\n", verdict.message);
  if (flags.json || flags.quiet || verdict.status == exit_bad_request) return;
  const Json& json = verdict.json;
  if (flags.resolved) {
    print_result("{}", json["resolved"].get<std::string>());
    return;
  }
  print_result("{}: {} masses, {} links, {} s with {} {}{}\n", json["scene"].get<std::string>(),
               json["masses"].get<std::size_t>(), json["links"].get<std::size_t>(),
               json["duration"].get<double>(), json["method"].get<std::string>(),
               json["pace"].get<std::string>(), verdict.status == exit_done ? ", fine" : "");
  print_result("{}", verdict.explanation);
  if (json.contains("reference")) print_reference(json["reference"]);
  if (!json.contains("findings")) return;
  print_measures(json["measures"]);
  if (verdict.certificate) print_result("  certificate: {}\n", certificate_text(*verdict.certificate));
  if (const auto halvings = json["halvings"].get<std::string>(); !halvings.empty())
    print_result("  {}\n", halvings);
  if (json.contains("spin")) print_spin(json["spin"]);
  for (const Json& finding : json["findings"])
    print_result("  {} {}: {}\n", finding["holds"].get<bool>() ? "holds" : "FAILS",
                 finding["key"].get<std::string>(), finding["text"].get<std::string>());
}

int check(const CheckFlags& flags) {
  if (flags.certify && !flags.run) throw BadRequest("--certify needs a run to certify: --run");
  const int threads = flags.changes.thread_count(flags.certify ? 1 : 0);
  const InterruptWatch interrupts(end_at_once);
  int status = exit_done;
  Json verdicts = Json::array();
  for (const std::string& scene : flags.scenes) {
    Verdict verdict;
    const int ended =
        unless_interrupted(interrupts, fmt::format("{} was not checked to its end", scene), [&] {
          verdict = check_scene(scene, flags, threads, stop_test(interrupts));
          return exit_done;
        });
    if (ended != exit_done) return ended;
    print_verdict(verdict, flags);
    status = std::max(status, verdict.status);
    verdicts.push_back(verdict.json);
  }
  if (flags.json) print_result("{}\n", json_text(verdicts, 2));
  return status;
}

}  // namespace

void add_check(CommandLine& program) {
  Verb* verb = program.add_subcommand("check", "Find errors in scenes, and test what they expect");
  const auto flags = std::make_shared<CheckFlags>();
  verb->add_option("SCENE", flags->scenes, "Scene files, or bare names of `taut list scenes`")
      ->names_a(ValueKind::scene)
      ->required();
  flags->changes.add_changes_to(*verb);
  flags->changes.add_threads_to(*verb);
  verb->add_flag("--explain", flags->explain,
                 "Say what each scene models, what it leaves out, and what each part costs per step");
  verb->add_flag("--run", flags->run,
                 "Simulate each scene and test its [expect]; status 1 where it does not hold");
  add_certify(*verb, flags->certify);
  verb->add_flag("--reference", flags->reference,
                 "Also measure the position error against a certified reference (kept in a cache)");
  verb->add_flag("--resolved", flags->resolved, "Print each scene as TOML with every default filled in");
  verb->add_flag("--json", flags->json, "Print an array of objects as JSON on stdout");
  verb->add_flag("--quiet", flags->quiet, "Only errors");
  verb->footer("Example:\n  taut check hanging-chain curtain --run");
  verb->action([flags] { return check(*flags); });
}

}  // namespace taut
