#include "study/chart_summary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/digits.h"
#include "measure/planner.h"

namespace taut {
namespace {

struct FrontPoint {
  double seconds, error;
};

// The curve's own front, from cheap to dear.
std::vector<FrontPoint> front_of(const Chart& chart, std::size_t curve, ErrorKind kind) {
  std::vector<double> costs, errors;
  for (const ChartCase& done : chart.cases) {
    if (done.point.curve != curve || done.run.diverged || !done.run.errors[kind]) continue;
    costs.push_back(done.seconds());
    // What is smaller can't be told from the truth.
    errors.push_back(std::max(*done.run.errors[kind], *chart.truth.smallest[kind]));
  }
  std::vector<FrontPoint> front;
  for (const std::size_t i : pareto_front(costs, errors)) front.push_back({costs[i], errors[i]});
  return front;
}

double along(const FrontPoint& a, const FrontPoint& b, double error) {
  const double share = std::log(error / a.error) / std::log(b.error / a.error);
  return a.seconds * std::pow(b.seconds / a.seconds, share);
}

std::string duration_of(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.2g} ms", 1e3 * seconds);
  return seconds < 1.0 ? fmt::format("{:.3g} ms", 1e3 * seconds) : fmt::format("{:.3g} s", seconds);
}

struct Entry {
  std::string name;
  CostAt cost;
};

// What methods need for an error, the cheapest first.
std::vector<Entry> ranked(const Chart& chart, ErrorKind kind, double error) {
  std::vector<Entry> entries;
  for (std::size_t curve = 0; curve < chart.curves.size(); ++curve)
    if (const auto cost = cost_at(chart, curve, kind, error))
      entries.push_back({chart.curves[curve].name, *cost});
  std::ranges::sort(entries, {}, [](const Entry& entry) { return entry.cost.seconds; });
  return entries;
}

std::string time_of(const Entry& entry) {
  return (entry.cost.extrapolated ? "~" : "") + duration_of(entry.cost.seconds);
}

std::string row(const Chart& chart, ErrorKind kind, double error) {
  const std::vector<Entry> entries = ranked(chart, kind, error);
  const std::string head = fmt::format("| {} | {}, {:g} % | ", chart.scene, name_of(kind), 100.0 * error);
  if (entries.empty()) return head + "none | | |\n";
  std::vector<std::string> others;
  for (std::size_t i = 1; i < entries.size(); ++i)
    others.push_back(fmt::format("`{}` {}{}", entries[i].name, entries[i].cost.extrapolated ? "~" : "",
                                 two_digits(entries[i].cost.seconds / entries.front().cost.seconds)));
  return head + fmt::format("`{}` | {} | {} |\n", entries.front().name, time_of(entries.front()),
                            fmt::join(others, ", "));
}

constexpr std::array table_errors{0.1, 0.01, 1e-3, 1e-4};

// By what an error can be judged; nothing where it can't be told from the truth.
std::optional<ErrorKind> kind_for(const Chart& chart, double error) {
  const ErrorKind kind = judging_kind(chart.truth, ErrorKind::trajectory, error);
  if (error <= chart.truth.smallest[kind].value_or(infinity)) return std::nullopt;
  return kind;
}

std::string cell(const Chart& chart, double error) {
  const std::optional<ErrorKind> kind = kind_for(chart, error);
  if (!kind) return "";
  const std::vector<Entry> entries = ranked(chart, *kind, error);
  if (entries.empty()) return "none";
  return fmt::format("`{}` {}{}", entries.front().name, time_of(entries.front()),
                     *kind == ErrorKind::trajectory ? "" : fmt::format(" ({})", name_of(*kind)));
}

}  // namespace

std::optional<CostAt> cost_at(const Chart& chart, std::size_t curve, ErrorKind kind, double error) {
  const std::vector<FrontPoint> front = front_of(chart, curve, kind);
  if (front.empty()) return std::nullopt;
  if (error >= front.front().error) return CostAt{front.front().seconds, false};
  for (std::size_t i = 1; i < front.size(); ++i)
    if (error >= front[i].error) return CostAt{along(front[i - 1], front[i], error), false};
  // A curve that falls as it should halves its error when it costs at most four times as much.
  if (front.size() < 3) return std::nullopt;
  const FrontPoint &a = front[front.size() - 2], &b = front.back();
  const double slope = std::log(b.seconds / a.seconds) / std::log(a.error / b.error);
  constexpr double steepest = 2.0, furthest = 100.0;
  if (slope > steepest || b.error > furthest * error) return std::nullopt;
  return CostAt{along(a, b, error), true};
}

std::string cheapest_method_table(const std::vector<Chart>& charts) {
  std::string table = "| scene | looked at until |";
  for (const double error : table_errors) table += fmt::format(" {:g} % |", 100.0 * error);
  table += "\n|---|---|---|---|---|---|\n";
  for (const Chart& chart : charts) {
    table += fmt::format("| {} | {:.3g} s |", chart.scene, chart.truth.horizon());
    for (const double error : table_errors) table += fmt::format(" {} |", cell(chart, error));
    table += "\n";
  }
  return table;
}

std::string which_method_table(const std::vector<Chart>& charts) {
  std::string table =
      "| scene | error | cheapest | time | the others, times as dear |\n|---|---|---|---|---|\n";
  for (const Chart& chart : charts)
    for (const double error : table_errors)
      if (const std::optional<ErrorKind> kind = kind_for(chart, error)) table += row(chart, *kind, error);
  return table;
}

}  // namespace taut
