#include "study/chart_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "chart_page.h"
#include "output/atomic_file.h"
#include "output/chart_figure.h"

namespace taut {
namespace {

constexpr double largest_drawn = 3.0;  // error; what is further off than the scene is large tells nothing

// What the y axis of a chart counts.
enum class Cost { seconds, link_solves };

double cost_of(const ChartCase& done, Cost cost) {
  return cost == Cost::seconds ? done.seconds() : static_cast<double>(done.run.counts.link_solves);
}

// What costs nothing (a free flight makes no link solves) has no place on a logarithmic axis.
bool is_drawn(const Chart& chart, const ChartCase& done, ErrorKind kind, Cost cost) {
  const std::optional<double>& error = done.run.errors[kind];
  return !done.run.diverged && error && *error <= largest_drawn && *error > *chart.truth.smallest[kind] &&
         cost_of(done, cost) > 0.0;
}

std::vector<std::size_t> front_of(const std::vector<const ChartCase*>& cases, ErrorKind kind, Cost cost) {
  std::vector<double> costs, errors;
  for (const ChartCase* done : cases) {
    costs.push_back(cost_of(*done, cost));
    errors.push_back(*done->run.errors[kind]);
  }
  return pareto_front(costs, errors);
}

// A method whose finer steps never pay has no front to speak of: its line is that of one pass.
std::vector<std::size_t> line_of(const std::vector<const ChartCase*>& cases, ErrorKind kind, Cost cost) {
  constexpr std::size_t enough = 3;
  std::vector<std::size_t> front = front_of(cases, kind, cost);
  if (front.size() >= enough) return front;
  std::vector<std::size_t> one_pass;
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (cases[i]->point.row == 0) one_pass.push_back(i);
  return one_pass.size() > front.size() ? one_pass : front;
}

FigureCurve curve_of(const Chart& chart, std::size_t place, ErrorKind kind, Cost cost) {
  const MethodVariant& curve = chart.curves[place];
  FigureCurve drawn;
  drawn.name = curve.name;
  drawn.colour = curve.method;
  drawn.dashed = place > 0 && chart.curves[place - 1].method == curve.method;
  std::vector<const ChartCase*> cases;
  for (const ChartCase& done : chart.cases)
    if (done.point.curve == place && is_drawn(chart, done, kind, cost)) cases.push_back(&done);
  const std::vector<std::size_t> line = line_of(cases, kind, cost);
  for (const std::size_t i : line)
    drawn.points.push_back({*cases[i]->run.errors[kind], cost_of(*cases[i], cost), true});
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (std::ranges::find(line, i) == line.end())
      drawn.points.push_back({*cases[i]->run.errors[kind], cost_of(*cases[i], cost), false});
  return drawn;
}

// Steps per second, or a tolerance (m).
double fineness_of(const ChartCase& done) {
  return done.settings.number(done.settings.chooses_steps() ? "tolerance" : "steps_per_second");
}

std::string settings_label(const Chart& chart, const ChartCase& done) {
  const MethodVariant& curve = chart.curves[done.point.curve];
  std::string label = done.settings.chooses_steps() ? fmt::format("{} {:g} m", curve.name, fineness_of(done))
                                                    : fmt::format("{} {}/s", curve.name, fineness_of(done));
  if (done.point.row > 0) label += fmt::format(" × {}", curve.passes->value(done.point.row));
  return label;
}

std::vector<FigureLabel> front_labels(const Chart& chart, ErrorKind kind, Cost cost) {
  std::vector<const ChartCase*> cases;
  for (const ChartCase& done : chart.cases)
    if (is_drawn(chart, done, kind, cost)) cases.push_back(&done);
  std::vector<FigureLabel> labels;
  for (const std::size_t i : front_of(cases, kind, cost))
    labels.push_back(
        {*cases[i]->run.errors[kind], cost_of(*cases[i], cost), settings_label(chart, *cases[i])});
  return labels;
}

std::string error_label(const Chart& chart, ErrorKind kind) {
  switch (kind) {
    case ErrorKind::trajectory:
      return fmt::format("largest distance from the true motion, of {:.3g} m", chart.size);
    case ErrorKind::strain:
      return "largest strain error of a link";
    case ErrorKind::energy:
      return fmt::format("energy error, of {:.3g} J", chart.energy_scale);
    case ErrorKind::sag:
      return fmt::format("error of the sag, of {:.3g} m", chart.size);
  }
  return "";
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
  std::map<std::pair<std::size_t, int>, std::vector<double>> by_row;  // of curve and row of passes
  for (const ChartCase& done : chart.cases)
    if (done.run.diverged) by_row[{done.point.curve, done.point.row}].push_back(fineness_of(done));
  if (by_row.empty()) return "No run diverged.";
  std::vector<std::string> parts;
  parts.reserve(by_row.size());
  for (const auto& [row, rates] : by_row) {
    const MethodVariant& curve = chart.curves[row.first];
    parts.push_back(fmt::format("{} {}{}", curve.name, ranges_of(rates),
                                row.second > 0 ? fmt::format(" × {}", curve.passes->value(row.second)) : ""));
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

std::vector<std::string> notes_of(const Chart& chart, ErrorKind kind) {
  std::vector<std::string> notes;
  notes.push_back(fmt::format("Reference: {}.", chart.truth.how));
  if (!chart.truth.remark.empty()) notes.push_back(fmt::format("Note: {}.", chart.truth.remark));
  if (const std::string flat = flat_note(chart, kind); !flat.empty()) notes.push_back(flat);
  notes.push_back(diverged_note(chart));
  if (!chart.omissions.empty())
    notes.push_back(fmt::format("Left out: {}.", fmt::join(chart.omissions, "; ")));
  const auto& counts = chart.counts;
  notes.push_back(
      fmt::format("{} of {} cases; pruned: {} off their method's front, {} without gain, {} too slow.",
                  counts.run, counts.run + counts.open, counts.off_front, counts.no_gain, counts.too_dear));
  notes.push_back(fmt::format("{}, one thread, {}; {}; {}; commit {}.", chart.machine.processor,
                              runs_note(chart), chart.machine.build.substr(0, chart.machine.build.rfind(',')),
                              chart.machine.flags, chart.machine.commit));
  return notes;
}

ChartFigure figure_of(const Chart& chart, ErrorKind kind, Cost cost) {
  ChartFigure figure;
  figure.title = chart.title;
  figure.subtitle =
      fmt::format("{} link{}, {:.4g} s: {}", chart.links, chart.links == 1 ? "" : "s", chart.truth.horizon(),
                  cost == Cost::seconds ? "time against accuracy" : "work against accuracy");
  figure.x_label = error_label(chart, kind);
  figure.y_label = cost == Cost::seconds ? "processor time (s)" : "link solves";
  for (std::size_t curve = 0; curve < chart.curves.size(); ++curve)
    figure.curves.push_back(curve_of(chart, curve, kind, cost));
  figure.front = front_labels(chart, kind, cost);
  figure.notes = notes_of(chart, kind);
  return figure;
}

}  // namespace

void write_chart(const Chart& chart, const std::filesystem::path& folder) {
  make_folder(folder);
  write_file(folder / (chart.scene + ".json"), chart_json(chart));
  write_file(folder / (chart.scene + ".csv"), chart_csv(chart));
  for (const ErrorKind kind : chart.errors) {
    const std::string stem = fmt::format("{}-{}", chart.scene, name_of(kind));
    write_plot(figure_script(figure_of(chart, kind, Cost::seconds)), folder / stem);
    write_plot(figure_script(figure_of(chart, kind, Cost::link_solves)), folder / (stem + "-solves"));
  }
}

void write_chart_page(const std::vector<Chart>& charts, const std::filesystem::path& folder) {
  std::vector<std::string> data(charts.size());
  std::ranges::transform(charts, data.begin(), chart_json);
  write_file(folder / "chart.html", chart_page(data));
}

}  // namespace taut
