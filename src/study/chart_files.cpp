#include "study/chart_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>

#include "base/digits.h"
#include "chart_caption.h"
#include "chart_page.h"
#include "output/chart_figure.h"
#include "study/study_folder.h"

namespace taut {
namespace {

constexpr double largest_drawn = 3.0;  // error; what is further off than the scene is large tells nothing

double cost_of(const ChartCase& done, ChartCost cost) {
  return cost == ChartCost::seconds ? done.seconds() : static_cast<double>(done.run.counts.link_solves);
}

// What costs nothing (a free flight makes no link solves) has no place on a logarithmic axis.
bool is_drawn(const Chart& chart, const ChartCase& done, ErrorKind kind, ChartCost cost) {
  const std::optional<double>& error = done.run.errors[kind];
  return !done.run.diverged && error && *error <= largest_drawn && *error > *chart.truth.smallest[kind] &&
         cost_of(done, cost) > 0.0;
}

std::vector<std::size_t> front_of(const std::vector<const ChartCase*>& cases, ErrorKind kind,
                                  ChartCost cost) {
  std::vector<double> costs, errors;
  for (const ChartCase* done : cases) {
    costs.push_back(cost_of(*done, cost));
    errors.push_back(*done->run.errors[kind]);
  }
  return pareto_front(costs, errors);
}

// A method whose finer steps never pay has no front to speak of: its line is that of one pass.
std::vector<std::size_t> line_of(const std::vector<const ChartCase*>& cases, ErrorKind kind, ChartCost cost) {
  constexpr std::size_t enough = 3;
  std::vector<std::size_t> front = front_of(cases, kind, cost);
  if (front.size() >= enough) return front;
  std::vector<std::size_t> one_pass;
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (cases[i]->point.row == 0) one_pass.push_back(i);
  return one_pass.size() > front.size() ? one_pass : front;
}

FigureCurve curve_of(const Chart& chart, std::size_t place, ErrorKind kind, ChartCost cost) {
  const MethodVariant& curve = chart.curves[place];
  FigureCurve drawn;
  drawn.name = curve.name;
  drawn.style = curve.method;
  drawn.variant = static_cast<int>(
      std::ranges::count(std::span(chart.curves).first(place), curve.method, &MethodVariant::method));
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

// What a case was run with, its method left out: "960/s", "240/s × 4" with passes, or a tolerance.
std::string settings_label(const ChartCase& done) {
  if (done.settings.chooses_steps())
    return fmt::format("{} m", with_power_of_ten(done.settings.number("tolerance")));
  const double rate = done.settings.number("steps_per_second");
  return done.point.row > 0 ? fmt::format("{}/s × {}", rate, done.settings.number("passes"))
                            : fmt::format("{}/s", rate);
}

std::vector<FigureLabel> front_labels(const Chart& chart, ErrorKind kind, ChartCost cost) {
  std::vector<const ChartCase*> cases;
  for (const ChartCase& done : chart.cases)
    if (is_drawn(chart, done, kind, cost)) cases.push_back(&done);
  std::vector<FigureLabel> labels;
  for (const std::size_t i : front_of(cases, kind, cost))
    labels.push_back({*cases[i]->run.errors[kind], cost_of(*cases[i], cost), settings_label(*cases[i])});
  return labels;
}

std::string error_label(const Chart& chart, ErrorKind kind) {
  switch (kind) {
    case ErrorKind::trajectory:
      return fmt::format("position error / size (size = {:.3g} m)", chart.size);
    case ErrorKind::strain:
      return "strain error of a link";
    case ErrorKind::energy:
      return fmt::format("energy error / scale (scale = {:.3g} J)", chart.energy_scale);
    case ErrorKind::sag:
      return fmt::format("sag error / size (size = {:.3g} m)", chart.size);
  }
  return "";
}

ChartFigure figure_of(const Chart& chart, ErrorKind kind, ChartCost cost) {
  const double horizon = chart.truth.horizon();
  ChartFigure figure;
  figure.title = chart.title;
  figure.subtitle =
      fmt::format("{} link{}, {:.4g} s of motion: {} against accuracy", chart.links,
                  chart.links == 1 ? "" : "s", horizon, cost == ChartCost::seconds ? "time" : "work");
  figure.x_label = error_label(chart, kind);
  figure.y_label = cost == ChartCost::seconds ? "processor time (s)" : "link solves";
  for (std::size_t curve = 0; curve < chart.curves.size(); ++curve)
    figure.curves.push_back(curve_of(chart, curve, kind, cost));
  figure.front = front_labels(chart, kind, cost);
  if (cost == ChartCost::seconds)
    figure.level = FigureLevel{horizon, fmt::format("real time: {0:.4g} s of motion in {0:.4g} s", horizon)};
  figure.note = short_note(chart);
  return figure;
}

constexpr std::string_view kind_of_chart = "chart";

void draw(const Chart& chart, StudyFolder& files, const StopTest& stop) {
  for (const ErrorKind kind : chart.errors)
    for (const ChartCost cost : {ChartCost::seconds, ChartCost::link_solves}) {
      const std::string stem =
          fmt::format("{}-{}{}", chart.scene, name_of(kind), cost == ChartCost::seconds ? "" : "-solves");
      files.draw(stem, figure_script(figure_of(chart, kind, cost)), stop);
      files.write(stem + ".txt", chart_caption(chart, kind, cost, stem));
    }
  files.finish(chart.scene,
               chart.complete() ? "" : fmt::format("{} cases are still to be run", chart.counts.open));
}

}  // namespace

void write_chart(const Chart& chart, const std::filesystem::path& folder, const StopTest& stop) {
  StudyFolder files(folder, kind_of_chart);
  files.write(chart.scene + ".json", chart_json(chart));
  files.write(chart.scene + ".csv", chart_csv(chart));
  files.know(chart.scene + ".cases.jsonl");
  draw(chart, files, stop);
}

void draw_chart(const Chart& chart, const std::filesystem::path& folder, const StopTest& stop) {
  StudyFolder files(folder, kind_of_chart);
  draw(chart, files, stop);
}

void write_chart_text(const std::string& name, const std::string& text, const std::filesystem::path& folder) {
  StudyFolder files(folder, kind_of_chart);
  files.write(name, text);
  files.finish({}, {});
}
void write_chart_page(const std::vector<Chart>& charts, const std::filesystem::path& folder) {
  std::vector<std::string> data(charts.size());
  std::ranges::transform(charts, data.begin(), chart_json);
  write_chart_text("chart.html", chart_page(data), folder);
}

}  // namespace taut
