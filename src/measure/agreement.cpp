#include "measure/agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/failure.h"
#include "measure/cost.h"
#include "measure/curves.h"
#include "measure/measures.h"
#include "measure/sampled_run.h"
#include "measure/work_precision.h"

namespace taut {
namespace {

// The end of a run in three numbers.
struct End {
  double sag = 0.0;     // m
  double energy = 0.0;  // J
  double strain = 0.0;  // the largest
};

// The ends of a method's two finest runs, the finer at `rate` steps per second.
struct Opinion {
  std::string name;
  std::size_t method = 0;
  double rate = 0.0;
  End coarse, fine;
  State end;  // of the finer run
};

struct Sizes {
  double place, energy;  // m, J
};

// How far two ends are apart, each number by its size.
Errors difference(const End& a, const End& b, const Sizes& sizes) {
  Errors errors;
  errors[ErrorKind::sag] = std::abs(a.sag - b.sag) / sizes.place;
  errors[ErrorKind::energy] = std::abs(a.energy - b.energy) / sizes.energy;
  errors[ErrorKind::strain] = std::abs(a.strain - b.strain);
  return errors;
}

constexpr std::array end_kinds{ErrorKind::sag, ErrorKind::energy, ErrorKind::strain};

// What one step costs at least (s), counted from nothing.
double least_work(const Model& model, const Curve& curve) {
  StepReport step;
  step.link_solves = static_cast<std::int64_t>(model.links.size());
  step.factorisations = curve.relaxes ? 0 : 1;
  return predicted_seconds(model, step, 1.0);
}

std::optional<Opinion> opinion_of(const Model& model, const State& start, const Curve& curve, double horizon,
                                  double most_seconds) {
  std::optional<Opinion> opinion;
  std::optional<End> coarse;
  double work = 0.0;
  for (double rate = 120.0; rate <= 1e6 && 2.0 * work <= most_seconds; rate *= 2.0) {
    if (rate * horizon * least_work(model, curve) > most_seconds) break;
    try {
      const SampledRun run = sampled_run(model, start, settings_at(curve, rate, 1), {horizon}, chart_guard);
      work = predicted_seconds(model, run.report, rate * horizon);
      if (run.diverged) continue;
      const State& state = run.states.back();
      const End fine{sag(model, state), energy(model, state).total(), link_strain(model, state).largest};
      if (coarse) opinion = Opinion{curve.name, curve.method, rate, *coarse, fine, state};
      coarse = fine;
    } catch (const BadRequest&) {
      continue;  // springs too stiff for this step
    }
  }
  return opinion;
}

// The largest of three differences, kind by kind.
Errors uncertainty_of(const Opinion& a, const Opinion& b, const Sizes& sizes) {
  Errors result;
  for (const ErrorKind kind : end_kinds)
    result[kind] =
        std::max({*difference(a.coarse, a.fine, sizes)[kind], *difference(b.coarse, b.fine, sizes)[kind],
                  *difference(a.fine, b.fine, sizes)[kind]});
  return result;
}

double sum_of(const Errors& errors) {
  return *errors[ErrorKind::sag] + *errors[ErrorKind::energy];
}

// The scene without its ground and with links that never break: the same until something breaks or lands, and
// within reach of more methods.
Model without_events(const Model& model) {
  Model calm = model;
  calm.plane.reset();
  calm.breakable_links.clear();
  std::ranges::fill(calm.links.break_stretch, infinity);
  std::ranges::fill(calm.links.break_tension, infinity);
  return calm;
}

// When the first link breaks (s), by the first method that can do the whole scene; infinity where none
// breaks.
double first_break(const Model& model, const State& start, double horizon, double most_seconds) {
  for (const Curve& curve : curves_for(model).curves) {
    double rate = 120.0;
    while (2.0 * rate * horizon * least_work(model, curve) <= most_seconds) rate *= 2.0;
    const SampledRun run = sampled_run(model, start, settings_at(curve, rate, 1), {horizon}, chart_guard);
    if (!run.diverged) return run.first_break;
  }
  return infinity;
}

bool below(const Plane& plane, const State& state) {
  for (std::size_t i = 0; i < state.position.size(); ++i)
    if (plane.normal.dot(state.position.at(i) - plane.point) < 0.0) return true;
  return false;
}

struct Pair {
  Opinion first, second;
};

// The two opinions of different methods that differ least, the surer one first.
std::optional<Pair> best_pair(const std::vector<Opinion>& opinions, const Sizes& sizes) {
  std::optional<Pair> best;
  for (const Opinion& a : opinions)
    for (const Opinion& b : opinions) {
      if (a.method >= b.method) continue;
      if (best &&
          sum_of(uncertainty_of(a, b, sizes)) >= sum_of(uncertainty_of(best->first, best->second, sizes)))
        continue;
      const bool a_first =
          sum_of(difference(a.coarse, a.fine, sizes)) <= sum_of(difference(b.coarse, b.fine, sizes));
      best = a_first ? Pair{a, b} : Pair{b, a};
    }
  return best;
}

}  // namespace

Truth truth_by_agreement(const Model& model, const State& start, double horizon, double most_seconds,
                         const std::string& why) {
  Truth truth;
  truth.times = {horizon};
  truth.remark = why;
  if (!model.breakable_links.empty()) {
    if (const double at = first_break(model, start, horizon, most_seconds); at < infinity) {
      truth.times = {std::max(1.0, std::floor(0.8 * at * 60.0)) / 60.0};
      truth.remark += fmt::format("; looked at at {:.3g} s, before the first link breaks", truth.horizon());
    }
  }
  const Model calm = without_events(model);
  const Sizes sizes{scene_size(model, start), energy_scale(model, start)};
  std::vector<Opinion> opinions;
  for (const Curve& curve : curves_for(calm).curves) {
    auto opinion = opinion_of(calm, start, curve, truth.horizon(), most_seconds);
    if (opinion && !(model.plane && below(*model.plane, opinion->end)))
      opinions.push_back(*std::move(opinion));
  }
  const std::optional<Pair> best = best_pair(opinions, sizes);
  if (!best) {
    truth.remark += "; no two methods can be run finely enough to agree";
    return truth;
  }
  const auto& [first, second] = *best;
  truth.sag = first.fine.sag;
  truth.energy = first.fine.energy;
  truth.strain = first.fine.strain;
  const Errors uncertainty = uncertainty_of(first, second, sizes);
  for (const ErrorKind kind : end_kinds)
    if (10.0 * *uncertainty[kind] < 0.1) truth.smallest[kind] = 10.0 * *uncertainty[kind];
  if (has_rigid_links(model)) truth.smallest[ErrorKind::strain] = exact_length_limit;
  truth.how = fmt::format(
      "{} at {} steps/s and {} at {} steps/s agree: sag within {:.1e} of the size, energy within {:.1e}",
      first.name, first.rate, second.name, second.rate, *uncertainty[ErrorKind::sag],
      *uncertainty[ErrorKind::energy]);
  return truth;
}

}  // namespace taut
