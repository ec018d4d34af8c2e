#include "chart_caption.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace taut {
namespace {

// Steps per second, or a tolerance (m).
double fineness_of(const ChartCase& done) {
  return done.settings.number(done.settings.chooses_steps() ? "tolerance" : "steps_per_second");
}

int passes_of(const ChartCase& done) {
  return done.settings.values.contains("passes") ? static_cast<int>(done.settings.number("passes")) : 1;
}

// Rates that follow one another by doubling, as "60–480", and others, as a list.
std::string ranges_of(std::vector<double> rates) {
  std::ranges::sort(rates);
  std::vector<std::string> ranges;
  for (std::size_t first = 0; first < rates.size();) {
    std::size_t last = first;
    while (last + 1 < rates.size() && rates[last + 1] == 2.0 * rates[last]) ++last;
    ranges.push_back(last == first ? fmt::format("{}", rates[first])
                                   : fmt::format("{}–{}", rates[first], rates[last]));
    first = last + 1;
  }
  return fmt::format("{}", fmt::join(ranges, ", "));
}

std::string diverged_note(const Chart& chart) {
  std::map<std::pair<std::size_t, int>, std::vector<double>> by_row;  // of curve and passes
  for (const ChartCase& done : chart.cases)
    if (done.run.diverged) by_row[{done.point.curve, passes_of(done)}].push_back(fineness_of(done));
  if (by_row.empty()) return "No run diverged.";
  std::vector<std::string> parts;
  parts.reserve(by_row.size());
  for (const auto& [row, rates] : by_row) {
    const MethodVariant& curve = chart.curves[row.first];
    parts.push_back(fmt::format("{} {}{}", curve.name, ranges_of(rates),
                                row.second > 1 ? fmt::format(" × {}", row.second) : ""));
  }
  return fmt::format("Diverged or refused (steps/s × passes, or tolerance): {}.", fmt::join(parts, "; "));
}

// The curves whose finer half of steps brings them hardly nearer to the truth: they do not converge, or not
// yet.
std::string flat_note(const Chart& chart, ErrorKind kind) {
  constexpr std::size_t enough = 6;
  constexpr double falls_at_least = 0.2;
  std::vector<std::string> flat;
  for (std::size_t curve = 0; curve < chart.curves.size(); ++curve) {
    std::vector<double> errors;  // of one pass a step, from coarse to fine
    for (const ChartCase& done : chart.cases)
      if (done.point.curve == curve && done.point.row == 0 && done.run.errors[kind])
        errors.push_back(*done.run.errors[kind]);
    if (errors.size() >= enough && errors.back() > falls_at_least * errors[errors.size() / 2] &&
        errors.back() > *chart.truth.smallest[kind] && errors.back() > 1e-9)
      flat.push_back(fmt::format("{} (error {:.2g})", chart.curves[curve].name, errors.back()));
  }
  return flat.empty() ? ""
                      : fmt::format("Less than 5 times nearer over the finer half of their steps: {}.",
                                    fmt::join(flat, ", "));
}

std::string runs_note(const Chart& chart) {
  const auto fewer = std::ranges::count_if(chart.cases, [](const ChartCase& done) {
    return !done.run.diverged && done.times.processor.size() < 5;
  });
  return fewer == 0 ? "least of 5 runs after a warm-up"
                    : fmt::format("least of 5 runs after a warm-up (fewer in {} slow cases)", fewer);
}

std::string counts_note(const Chart& chart) {
  return fmt::format("{} of {} cases", chart.counts.done(), chart.counts.all());
}

// What stands across the picture, in words.
std::string error_in_words(const Chart& chart, ErrorKind kind) {
  switch (kind) {
    case ErrorKind::trajectory:
      return fmt::format(
          "the largest distance of any mass from the true motion, over the scene's size of {:.3g} m",
          chart.size);
    case ErrorKind::strain:
      return "the largest error of any link's strain";
    case ErrorKind::energy:
      return fmt::format("the largest error of the energy, over {:.3g} J", chart.energy_scale);
    case ErrorKind::sag:
      return fmt::format("the largest error of the sag, over the scene's size of {:.3g} m", chart.size);
  }
  return "";
}

// What tells the curves of one method from each other.
std::string_view variants_in_words(const Chart& chart) {
  std::ptrdiff_t most = 0;
  for (const MethodVariant& curve : chart.curves)
    most = std::max(most, std::ranges::count(chart.curves, curve.method, &MethodVariant::method));
  if (most < 2) return "";
  return most == 2 ? " Dashes and hollow markers: a second variant of the same method."
                   : " Dashes and hollow markers: a second variant of the same method; dots: a third.";
}

std::vector<std::string> reading_notes(const Chart& chart, ErrorKind kind, ChartCost cost) {
  const bool seconds = cost == ChartCost::seconds;
  std::vector<std::string> notes;
  notes.push_back(
      fmt::format("Each point is one run of {:.4g} s of motion of {} masses and {} links. Across: {}, "
                  "smaller to the right. "
                  "Up: {}. Both axes are logarithmic; what is good lies at the right and low.",
                  chart.truth.horizon(), chart.masses, chart.links, error_in_words(chart, kind),
                  seconds ? "the processor time that it took, on one thread"
                          : "how many links it solved, passes and rounds counted"));
  notes.push_back(fmt::format(
      "A line joins the best runs of a method; small dots are its others.{} The grey band joins the best of "
      "all, and "
      "the numbers along it say what they were run with: steps per second, × passes over the links in each "
      "step, or "
      "the tolerance of a method that chooses its steps.",
      variants_in_words(chart)));
  notes.push_back(fmt::format(
      "The guides show how steep curves of order 1, 2 and 4 are, whose errors fall as that power of the "
      "step.{}",
      seconds ? fmt::format(" The dotted line is real time: there a run takes the {:.4g} s that it shows.",
                            chart.truth.horizon())
              : ""));
  return notes;
}

}  // namespace

std::string short_note(const Chart& chart) {
  std::string note = counts_note(chart);
  if (!chart.complete()) note += ", the others are still to be run";
  if (!chart.truth.remark.empty()) note += "; " + chart.truth.remark.substr(0, chart.truth.remark.find(':'));
  return note + "; how to read it: see the caption";
}

std::string chart_caption(const Chart& chart, ErrorKind kind, ChartCost cost, const std::string& stem) {
  std::vector<std::string> notes{fmt::format("{}: {} against accuracy ({}.png, {}.svg).", chart.title,
                                             cost == ChartCost::seconds ? "processor time" : "work", stem,
                                             stem)};
  std::ranges::move(reading_notes(chart, kind, cost), std::back_inserter(notes));
  notes.push_back(fmt::format("Reference: {}.", chart.truth.how));
  if (!chart.truth.remark.empty()) notes.push_back(fmt::format("Note: {}.", chart.truth.remark));
  if (const std::string flat = flat_note(chart, kind); !flat.empty()) notes.push_back(flat);
  notes.push_back(diverged_note(chart));
  if (!chart.omissions.empty())
    notes.push_back(fmt::format("Left out: {}.", fmt::join(chart.omissions, "; ")));
  const auto& counts = chart.counts;
  notes.push_back(fmt::format("{}; pruned: {} off their method's front, {} without gain, {} too slow.",
                              counts_note(chart), counts.off_front, counts.no_gain, counts.too_dear));
  notes.push_back(fmt::format("{}, one thread, {}; {}; {}; commit {}.", chart.machine.processor,
                              runs_note(chart), chart.machine.build.substr(0, chart.machine.build.rfind(',')),
                              chart.machine.flags, chart.machine.commit));
  return fmt::format("{}\n", fmt::join(notes, "\n\n"));
}

}  // namespace taut
