#include "high_order/equations.h"

#include <algorithm>
#include <cmath>

#include "base/vector_operations.h"
#include "direct/link_matrices.h"
#include "direct/link_topology.h"
#include "direct/newton_rounds.h"
#include "forces/free_acceleration.h"
#include "model/limit_motion.h"

namespace taut {
namespace {

constexpr int most_rounds = 8;
// Velocities along links, and of angles, that count as none: as a share of the masses' speeds.
constexpr double still = 1e-14;
// How near a stop is touched (rad).
constexpr double touching = 1e-10;

double smallest_square(const Vectors& vectors) {
  double smallest = infinity;
  for (std::size_t i = 0; i < vectors.size(); ++i) smallest = std::min(smallest, vectors.at(i).squaredNorm());
  return smallest;
}

}  // namespace

Equations::Equations(const Model& model, const State& state, const std::shared_ptr<Workers>& workers)
    : model_(model),
      whole_(state),
      system_(make_link_system(model, whole_rigid_links(model, state))),
      springs_(gather_springs(model, state)),
      chains_(springs_.empty() ? make_chain_motion(model, system_, workers) : nullptr),
      border_(model),
      no_compliance_(system_.links.size(), 0.0) {}

void Equations::hold(const std::vector<HeldStop>& stops) {
  hard_.clear();
  soft_.clear();
  for (const HeldStop& stop : stops)
    (model_.limits[stop.limit].compliance > 0.0 ? soft_ : hard_).push_back(stop);
  pushes_.assign(hard_.size(), 0.0);
  soft_pushes_.assign(soft_.size(), 0.0);
}

std::vector<LimitRow> Equations::hard_rows(const std::vector<HeldStop>& stops,
                                           const Vectors& position) const {
  std::vector<LimitRow> rows;
  for (const HeldStop& stop : stops) {
    const LimitAngle along = border_.outward(stop.limit, stop.sign, position);
    rows.push_back({stop.limit, along, along, 0.0, 0.0});
  }
  return rows;
}

bool Equations::factor(const Vectors& position) {
  link_vectors(system_.links, position, direction_);
  return system_.matrix->factor(direction_, direction_, no_compliance_);
}

// Multipliers in place of the links' right sides; the stops' into strength_.
bool Equations::solve(const std::vector<LimitRow>& stops, std::vector<double>& multipliers) {
  const Eigen::VectorXd strength = border_.solve(system_, direction_, direction_, stops, multipliers);
  strength_.assign(strength.begin(), strength.end());
  return std::ranges::all_of(strength_, [](double s) { return std::isfinite(s); });
}

// from −= W (Jᵀ λ + Gᵀ μ)
void Equations::take(const std::vector<LimitRow>& stops, Vectors& from) {
  apply_impulses(system_.links, direction_, multipliers_, from, -1.0);
  for (std::size_t i = 0; i < stops.size(); ++i)
    border_.move(stops[i].limit, stops[i].column, -strength_[i], from);
}

// a_free
void Equations::free_motion(double time, const Vectors& position, const Vectors& velocity,
                            Vectors& acceleration) {
  free_accelerations(model_, whole_, springs_, time, position, velocity, acceleration, spring_tension_);
  for (std::size_t i = 0; i < soft_.size(); ++i) {
    const HeldStop& stop = soft_[i];
    const Limit& limit = model_.limits[stop.limit];
    soft_pushes_[i] = excess_at(limit, limit_angle(limit, position), stop.sign) / limit.compliance;
    border_.move(stop.limit, border_.outward(stop.limit, stop.sign, position), -soft_pushes_[i],
                 acceleration);
  }
}

bool Equations::evaluate(double time, const Vectors& position, const Vectors& velocity,
                         Vectors& acceleration) {
  const SystemLinks& links = system_.links;
  if (freely()) {
    PhaseSums here;
    here.start(position, velocity, 0.0);
    return chains_->evaluate(here, acceleration, multipliers_);
  }
  free_motion(time, position, velocity, acceleration);
  link_vectors(links, position, direction_);
  along_links_moving(links, direction_, acceleration, velocity, multipliers_);
  if (hard_.empty()) {
    if (!system_.matrix->factor_and_solve(direction_, direction_, no_compliance_, multipliers_)) return false;
    apply_impulses(links, direction_, multipliers_, acceleration, -1.0);
    return true;
  }
  rows_ = hard_rows(hard_, position);
  for (std::size_t i = 0; i < rows_.size(); ++i)
    rows_[i].wanted = border_.change(rows_[i], acceleration) +
                      hard_[i].sign * limit_motion(model_.limits[hard_[i].limit], position, velocity).change;
  if (!system_.matrix->factor(direction_, direction_, no_compliance_) || !solve(rows_, multipliers_))
    return false;
  take(rows_, acceleration);
  pushes_ = strength_;
  return true;
}

bool Equations::evaluate(double time, const PhaseSums& at, Vectors& acceleration) {
  if (freely()) return chains_->evaluate(at, acceleration, multipliers_);
  write_phase(at, phase_);
  place_pins(model_, time, phase_.position, phase_.velocity);
  return evaluate(time, phase_.position, phase_.velocity, acceleration);
}

void Equations::write_tensions(std::vector<double>& tension) const {
  tension.assign(model_.links.size(), 0.0);
  const SystemLinks& links = system_.links;
  for (std::size_t i = 0; i < multipliers_.size(); ++i)
    tension[links.link[i]] = multipliers_[i] * links.length[i];
  for (std::size_t i = 0; i < spring_tension_.size(); ++i)
    tension[springs_.links.link[i]] = spring_tension_[i];
  for (std::size_t i = 0; i < hard_.size(); ++i) write_reach(hard_[i], pushes_[i], tension);
  for (std::size_t i = 0; i < soft_.size(); ++i) write_reach(soft_[i], soft_pushes_[i], tension);
}

// A stop that pushes with a torque (N m), where it is the end of a one-sided link's reach.
void Equations::write_reach(const HeldStop& stop, double push, std::vector<double>& tension) const {
  const Limit& limit = model_.limits[stop.limit];
  if (limit.kind == LimitKind::reach) tension[limit.link] = stop.sign * push / limit.length;
}

// (|d|² − l²)/2 of every link into the multipliers; returns the largest error in a length over the length.
double Equations::length_residual(const Vectors& position) {
  const SystemLinks& links = system_.links;
  link_vectors(links, position, direction_);
  multipliers_.resize(links.size());
  if (links.size() == 0) return 0.0;
  const auto x = all_of(direction_.x), y = all_of(direction_.y), z = all_of(direction_.z);
  const auto length = all_of(links.length);
  all_of(multipliers_) = 0.5 * (x * x + y * y + z * z - length * length);
  Eigen::Index worst = 0;
  const double error = (all_of(multipliers_) / (length * length)).abs().maxCoeff<Eigen::PropagateNaN>(&worst);
  worst_link_ = links.link[static_cast<std::size_t>(worst)];
  return error;
}

// How far the held hard stops are from their ends, into their rows.
double Equations::stop_residual(const Vectors& position) {
  rows_ = hard_rows(hard_, position);
  double worst = 0.0;
  for (LimitRow& row : rows_) {
    const HeldStop& stop = hard_[static_cast<std::size_t>(&row - rows_.data())];
    const Limit& limit = model_.limits[stop.limit];
    row.wanted = excess_at(limit, limit_angle(limit, position), stop.sign);
    worst = std::max(worst, std::abs(row.wanted));
  }
  return worst;
}

// Newton's method with the gradients where it is.
bool Equations::project_positions(Vectors& position) {
  const double tolerance = 0.1 * length_tolerance(system_.links, position);
  double last = infinity;
  for (int round = 0; round < most_rounds; ++round) {
    const double error = freely() ? chains_->length_error(position)
                                  : std::max(length_residual(position), stop_residual(position));
    if (!std::isfinite(error)) return false;
    // Where rounding forbids what is asked for, what no round makes better is taken.
    if (error <= tolerance || (error <= 10.0 * tolerance && error > 0.5 * last)) return true;
    last = error;
    if (freely()) {
      if (!chains_->correct(position)) return false;
      continue;
    }
    if (!system_.matrix->factor(direction_, direction_, no_compliance_) || !solve(rows_, multipliers_))
      return false;
    factored_ = true;
    take(rows_, position);
  }
  length_residual(position);  // which link is worst
  return false;
}

// The same of chains on which nothing else acts.
bool Equations::project_chains(const Vectors& position, Vectors& velocity) {
  const double most = still * largest_coordinate(velocity);
  double last = infinity;
  for (int round = 0; round < most_rounds; ++round) {
    const double error = chains_->speed_along(position, velocity);
    if (!std::isfinite(error)) return false;
    if (error <= most || error > 0.5 * last) return true;
    last = error;
    if (!chains_->correct(position, velocity)) return false;
  }
  return true;
}

// With the matrix where positions were before their last round; what that leaves is taken by another.
bool Equations::project_velocities(const Vectors& position, Vectors& velocity) {
  const SystemLinks& links = system_.links;
  const double most = still * largest_coordinate(velocity);
  rows_ = hard_rows(hard_, position);
  double last = infinity;
  for (int round = 0; round < most_rounds; ++round) {
    along_links(links, direction_, velocity, multipliers_);
    double error = links.size() == 0 ? 0.0 : (all_of(multipliers_) / all_of(links.length)).abs().maxCoeff();
    for (LimitRow& row : rows_) {
      row.wanted = border_.change(row, velocity);
      error = std::max(error, std::abs(row.wanted));
    }
    if (!std::isfinite(error)) return false;
    if (error <= most || error > 0.5 * last) return true;
    last = error;
    if (!factored_ && !system_.matrix->factor(direction_, direction_, no_compliance_)) return false;
    factored_ = true;
    if (!solve(rows_, multipliers_)) return false;
    take(rows_, velocity);
  }
  return true;
}

bool Equations::project(Vectors& position, Vectors& velocity) {
  factored_ = false;
  if (!project_positions(position)) return false;
  return freely() ? project_chains(position, velocity) : project_velocities(position, velocity);
}

// The linear complementarity problem
//   u' = u − W (Jᵀ λ + Gᵀ μ),  J u' + c = 0,  0 ≤ μ ⊥ −(G u' + c) ≥ 0
// of impulses on velocities u, or of forces on accelerations u, whose c (`links`, `wanted`) are what moving
// gradients add; by principal pivots, each on the first row that is not as it should be (Murty, Linear
// Complementarity, 1988, section 4.2).
template <class Wanted>
bool Equations::answer(const std::vector<LimitRow>& touched, const Wanted& wanted,
                       const std::vector<double>& links, std::vector<bool>& pushing, Vectors& u) {
  const Vectors given = u;
  pushing.assign(touched.size(), false);
  // What rounding leaves of the rows: a share of what masses make of them, each for itself.
  double steepest = 0.0;
  for (const LimitRow& row : touched)
    for (std::size_t k = 0; k < model_.limits[row.limit].count; ++k)
      steepest = std::max(steepest, row.along.gradient[k].norm());
  const double none = 1e-12 * steepest * largest_coordinate(given);
  for (std::size_t i = 0; i < touched.size(); ++i) pushing[i] = wanted(i, given) > 0.0;
  const std::size_t most_pivots = 8 * (touched.size() + 1) * (touched.size() + 1);
  for (std::size_t pivot = 0; pivot < most_pivots; ++pivot) {
    std::vector<LimitRow> some;
    for (std::size_t i = 0; i < touched.size(); ++i)
      if (pushing[i]) {
        some.push_back(touched[i]);
        some.back().wanted = wanted(i, given);
      }
    multipliers_ = links;
    if (!solve(some, multipliers_)) return false;
    u = given;
    take(some, u);
    std::size_t wrong = 0, next = 0;
    for (; wrong < touched.size(); ++wrong) {
      const bool is_wrong = pushing[wrong] ? strength_[next++] < 0.0 : wanted(wrong, u) > none;
      if (is_wrong) break;
    }
    if (wrong == touched.size()) return true;
    pushing[wrong] = !pushing[wrong];
  }
  return false;
}

bool Equations::settle(double time, const Vectors& position, double slow, Vectors& velocity,
                       std::vector<HeldStop>& held) {
  std::vector<HeldStop> near, pressed;
  for (std::size_t i = 0; i < model_.limits.size(); ++i)
    for (const double sign : {1.0, -1.0}) {
      const Limit& limit = model_.limits[i];
      if (!has_stop(limit, sign) || let_go(limit, whole_)) continue;
      if (!(excess_at(limit, limit_angle(limit, position), sign) > -touching)) continue;
      (limit.compliance > 0.0 ? pressed : near).push_back({static_cast<Index>(i), sign});
    }
  held.clear();
  std::vector<LimitRow> rows;
  const auto speed = [&](std::size_t i, const Vectors& u) { return border_.change(rows[i], u); };
  if (!near.empty()) {
    rows = hard_rows(near, position);
    if (!factor(position)) return false;
    std::vector<double> links;
    std::vector<bool> pushing;
    along_links(system_.links, direction_, velocity, links);
    if (!answer(rows, speed, links, pushing, velocity)) return false;
  }
  // A soft stop is pressed from now on where it is beyond its end, or on its way there.
  for (const HeldStop& stop : pressed) {
    const Limit& limit = model_.limits[stop.limit];
    const LimitAngle along = border_.outward(stop.limit, stop.sign, position);
    const bool beyond = excess_at(limit, limit_angle(limit, position), stop.sign) > touching;
    if (beyond || border_.change({stop.limit, along, along, 0.0, 0.0}, velocity) >= 0.0) held.push_back(stop);
  }
  hold(held);
  if (near.empty()) return true;

  std::vector<HeldStop> at_rest;
  for (std::size_t i = 0; i < near.size(); ++i)
    if (speed(i, velocity) > -slow) at_rest.push_back(near[i]);
  rows = hard_rows(at_rest, position);
  std::vector<double> curved;
  curved.reserve(at_rest.size());
  for (const HeldStop& stop : at_rest)
    curved.push_back(stop.sign * limit_motion(model_.limits[stop.limit], position, velocity).change);
  Vectors acceleration;
  free_motion(time, position, velocity, acceleration);
  std::vector<double> links;
  std::vector<bool> pushing;
  along_links_moving(system_.links, direction_, acceleration, velocity, links);
  const auto gathering = [&](std::size_t i, const Vectors& u) {
    return border_.change(rows[i], u) + curved[i];
  };
  // The links' right side is that of the free motion, whatever is held.
  if (!answer(rows, gathering, links, pushing, acceleration)) return false;
  for (std::size_t i = 0; i < at_rest.size(); ++i)
    if (pushing[i]) held.push_back(at_rest[i]);
  hold(held);
  factored_ = true;  // for these positions
  return project_velocities(position, velocity);
}

Index redundant_link(const Model& model, const State& state) {
  const std::vector<Index> rigid = whole_rigid_links(model, state);
  const SystemLinks links = gather(model, rigid);
  Vectors direction;
  link_vectors(links, state.position, direction);
  // In a tree with a pin at most, each link moves a mass that those before it don't.
  if (smallest_square(direction) > 0.0 && tree_order(model, rigid)) return no_link;
  const auto place = dependent_row(links, direction, model.masses.size());
  return place ? links.link[*place] : no_link;
}

}  // namespace taut
