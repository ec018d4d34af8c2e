#include "measure/work_precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/failure.h"
#include "measure/cost.h"
#include "motion/simulate.h"

namespace taut {
namespace {

constexpr int patience = 2;  // points of a row that a cheaper one of its curve beats
constexpr int hope = 3;      // points of a row that are no better than those before

}  // namespace

JudgedRun judge_run(const Model& model, const State& start, const Truth& truth, const Settings& settings,
                    const StopTest& stop) {
  JudgedRun judged;
  try {
    const SampledRun run = sampled_run(model, start, settings, truth.times, chart_policy, stop);
    judged.counts = run.report.counts;
    judged.steps = run.report.steps;
    judged.diverged = run.failed();
    if (judged.diverged)
      judged.trouble = fmt::format("diverged at {:.3g} s", run.reached);
    else
      judged.errors = judge(model, start, truth, run.states);
  } catch (const BadRequest& refusal) {
    judged.diverged = true;
    judged.trouble = refusal.what();
  }
  return judged;
}

GridWalk::GridWalk(const Model& model, std::vector<MethodVariant> curves, Truth truth, double most_seconds)
    : model_(model), curves_(std::move(curves)), truth_(std::move(truth)), most_seconds_(most_seconds) {
  for (const MethodVariant& curve : curves_) {
    const int rows = curve.passes ? curve.passes->count : 1;
    walks_.push_back({std::vector<Row>(static_cast<std::size_t>(rows)), {}});
  }
}

std::optional<GridPoint> GridWalk::next() {
  std::optional<GridPoint> cheapest;
  double least = infinity;
  for (std::size_t curve = 0; curve < walks_.size(); ++curve)
    for (std::size_t place = 0; place < walks_[curve].rows.size(); ++place) {
      Row& row = walks_[curve].rows[place];
      if (row.end != RowEnd::open || row.next >= curves_[curve].finer.count) continue;
      const GridPoint point{curve, row.next, static_cast<int>(place)};
      const double work = predicted_work(point);
      if (work > most_seconds_) {
        row.end = RowEnd::too_dear;
      } else if (work < least) {
        least = work;
        cheapest = point;
      }
    }
  if (cheapest) current_ = *cheapest;
  return cheapest;
}

void GridWalk::record(const JudgedRun& run) {
  CurveWalk& walk = walks_[current_.curve];
  const auto place = static_cast<std::size_t>(current_.row);
  Row& row = walk.rows[place];
  row.next = current_.fineness + 1;
  if (run.diverged) return;
  const Judged judged{run.errors, predicted_seconds(model_, curves_[current_.curve].settings.method,
                                                    run.counts, static_cast<double>(run.steps))};
  row.last_work = judged.work;
  row.dominated = is_dominated(walk, judged) ? row.dominated + 1 : 0;
  row.stale = improve(row.best, run.errors) ? 0 : row.stale + 1;
  walk.judged.push_back(judged);
  if (cannot_be_told_from_truth(run.errors) || row.stale >= hope) row.end = RowEnd::no_gain;
  if (row.dominated >= patience) end_rows(walk, place);
}

// More passes a step only lead further away from the front.
void GridWalk::end_rows(CurveWalk& walk, std::size_t row) const {
  walk.rows[row].end = RowEnd::off_front;
  for (std::size_t later = row + 1; later < walk.rows.size(); ++later)
    if (walk.rows[later].next == 0) walk.rows[later].end = RowEnd::off_front;
}

// Twice the row's last point, or counted from nothing where there is none: direct solves take about three
// rounds.
double GridWalk::predicted_work(const GridPoint& point) const {
  const Row& row = walks_[point.curve].rows[static_cast<std::size_t>(point.row)];
  if (row.last_work < infinity) return 2.0 * row.last_work;
  constexpr std::int64_t rounds_of_direct_solves = 3;
  const MethodVariant& curve = curves_[point.curve];
  const Settings settings = settings_at_place(curve, point.fineness, point.row);
  if (settings.chooses_steps()) return predicted_seconds(model_, settings, truth_.horizon());
  return predicted_seconds(
      model_, settings.method, truth_.horizon() * settings.steps_per_second(),
      curve.passes ? static_cast<std::int64_t>(curve.passes->value(point.row)) : rounds_of_direct_solves);
}

// Whether a point of the curve that costs no more has at most half of every error, as far as it can be told.
bool GridWalk::is_dominated(const CurveWalk& walk, const Judged& judged) const {
  return std::ranges::any_of(walk.judged, [&](const Judged& other) {
    if (other.work > judged.work) return false;
    return std::ranges::all_of(all_error_kinds, [&](ErrorKind kind) {
      if (!judged.errors[kind]) return true;
      return *other.errors[kind] <= std::max(0.5 * *judged.errors[kind], *truth_.smallest[kind]);
    });
  });
}

// Takes over what is smaller. True when some error fell by a tenth, from a size that can be judged.
bool GridWalk::improve(Errors& best, const Errors& errors) const {
  bool improved = false;
  for (const ErrorKind kind : all_error_kinds) {
    if (!errors[kind]) continue;
    const double before = best[kind].value_or(infinity);
    improved = improved || (*errors[kind] < 0.9 * before && before > *truth_.smallest[kind]);
    best[kind] = std::min(before, *errors[kind]);
  }
  return improved;
}

bool GridWalk::cannot_be_told_from_truth(const Errors& errors) const {
  return std::ranges::all_of(all_error_kinds, [&](ErrorKind kind) {
    return !errors[kind] || *errors[kind] <= *truth_.smallest[kind];
  });
}

GridWalk::Counts GridWalk::counts() const {
  Counts counts;
  for (std::size_t curve = 0; curve < walks_.size(); ++curve)
    for (const Row& row : walks_[curve].rows) {
      counts.run += static_cast<std::size_t>(row.next);
      const auto left = static_cast<std::size_t>(curves_[curve].finer.count - row.next);
      switch (row.end) {
        case RowEnd::open:
          counts.open += left;
          break;
        case RowEnd::off_front:
          counts.off_front += left;
          break;
        case RowEnd::no_gain:
          counts.no_gain += left;
          break;
        case RowEnd::too_dear:
          counts.too_dear += left;
          break;
      }
    }
  return counts;
}

std::vector<std::size_t> pareto_front(const std::vector<double>& costs, const std::vector<double>& errors) {
  std::vector<std::size_t> places(costs.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::ranges::sort(places, [&](std::size_t a, std::size_t b) {
    return std::pair(costs[a], errors[a]) < std::pair(costs[b], errors[b]);
  });
  std::vector<std::size_t> front;
  for (const std::size_t place : places)
    if (front.empty() || errors[place] < errors[front.back()]) front.push_back(place);
  return front;
}

}  // namespace taut
