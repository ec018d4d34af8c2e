// Fast projection (Goldenthal et al., Efficient Simulation of Inextensible Cloth, 2007) with compliance as in
// XPBD, solved directly (Deul et al., Direct Position-Based Solver for Stiff Rods, 2018).
//
//   until |r_i| ≤ tolerance · l_i in every link:
//     r_i = C_i − α̃_i λ_i + γ_i n·(d − d₀),   C = |d| − l,  n = d/|d|                  (λ: pull, positive)
//     (J W Jᵀ + α̃/(1 + γ)) Δλ = r/(1 + γ),     x ← x − W Jᵀ Δλ,   λ ← λ + Δλ           (Goldenthal 2007, Alg.
//     1)
//
// α̃ = α/h², γ = α c/h as in XPBD. Drag is implicit in the links' forces too: W stands for W/(1 + h·drag). The
// tension is λ/h². An impulse keeps the direction of the round that found it, so the sum is not quite along
// the final directions: a difference of second order in the step, below the method's own error, and what lets
// it answer large moves.
//
// Limits on angles that push border the system (see ActiveLimits).

#include "direct/fast_projection.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/vector_operations.h"
#include "direct/newton_rounds.h"
#include "forces/mass_kernels.h"

namespace taut {

FastProjection::FastProjection(const Model& model, LinkSystem system, const State& state)
    : model_(model), system_(std::move(system)), limits_(model) {
  limits_.links_changed(state);
  for (const Index link : system_.links.link) {
    inverse_length_.push_back(1.0 / model_.links.length[link]);
    compliant_ = compliant_ || !model_.links.rigid(link);
  }
  const std::size_t count = system_.links.size();
  direction_.resize(count);
  distance_.resize(count);
  residual_.resize(count);
  multipliers_.resize(count);
  diagonal_.resize(count);
  scale_.resize(count);
  shortest_ = shortest_length(system_.links);
  blocks_ = ChainBlocks(model_, system_.links);
}

bool FastProjection::solve(const Vectors& start, double h, const ExtentVisit& predict, Vectors& position,
                           std::vector<double>& tension, StepReport& report) {
  const SystemLinks& links = system_.links;
  const double answer = 1.0 / (1.0 + h * model_.drag);
  prepare(start, h, answer);
  limits_.begin_step(h);
  const double tolerance = length_tolerance(shortest_, predict_all(predict, position));
  for (int round = 0; round < most_newton_rounds; ++round) {
    const double worst = look_at_misfit(position, h, report);
    if (report.status != StepStatus::done) return false;
    const double beyond = limits_.look(position);
    const bool solved = worst <= tolerance && beyond <= limit_tolerance;
    const bool lost = round >= rounds_to_settle && worst > settled_error;
    if (solved || lost || round + 1 == most_newton_rounds) report.worst_link = worst_link(worst);
    if (solved) {
      keep_tensions(h, tension);
      limits_.give_tensions(1.0 / (h * h), position, tension);
      return true;
    }
    if (lost) break;
    ++report.factorisations;
    if (!solve_round(answer, position)) {
      measured_ = {};
      measure(position, blocks_.all_masses());
      report.worst_link = worst_link(look_at_misfit(position, h, report));
      report.status = StepStatus::factorisation_failed;
      return false;
    }
    report.rounds += 1;
    report.link_solves += static_cast<std::int64_t>(links.size());
  }
  report.status = StepStatus::not_converged;
  return false;
}

// Measures links, too; returns the largest coordinate (m).
double FastProjection::predict_all(const ExtentVisit& predict, Vectors& position) {
  double farthest = 0.0;
  GrowingExtent moved;
  measured_ = {};
  blocks_.visit([&](Extent block) {
    const Extent masses = blocks_.masses_among({0, block.end});
    moved.grow(masses, [&](Extent more) {
      predict(more);
      farthest = std::max(farthest, largest_of(more.size(), to_read(position, more.begin)));
    });
    measure(position, masses);
  });
  return farthest;
}

// Solves for a round's change of the multipliers, and moves the masses by it.
bool FastProjection::solve_round(double answer, Vectors& position) {
  measured_ = {};
  const auto scale = [&](Extent some) {
    if (compliant_ || answer != 1.0) some_of(residual_, some) *= some_of(scale_, some);
  };
  GrowingExtent solved_so_far, moved;
  const auto move_masses = [&](Extent solved) {
    if (!limits_.none()) limits_.push(system_, direction_, direction_, answer, residual_, position);
    solved_so_far.grow(solved, [&](Extent more) {
      some_of(multipliers_, more) += some_of(residual_, more);
      if (answer != 1.0) some_of(residual_, more) *= answer;
    });
    const Extent masses = blocks_.masses_among(solved);
    moved.grow(masses, [&](Extent more) {
      blocks_.push(model_, system_.links, direction_, residual_, position, -1.0, more);
    });
    measure(position, masses);
  };
  LinkMatrix& matrix = *system_.matrix;
  if (blocks_.several())
    return matrix.factor_and_solve_by_blocks(direction_, direction_, diagonal_, residual_,
                                             {scale, move_masses});
  scale(system_.links.all());
  if (!(limits_.none() ? matrix.factor_and_solve(direction_, direction_, diagonal_, residual_)
                       : matrix.factor(direction_, direction_, diagonal_)))
    return false;
  move_masses(system_.links.all());
  return true;
}

void FastProjection::keep_tensions(double h, std::vector<double>& tension) const {
  if (blocks_.several()) {
    all_of(tension) = all_of(multipliers_) / (h * h);
    return;
  }
  for (std::size_t i = 0; i < multipliers_.size(); ++i)
    tension[system_.links.link[i]] = multipliers_[i] / (h * h);
}

// What stays the same over the rounds: the start-of-step vectors, α̃/(1 + γ) and 1/(1 + γ), both over the
// answer to drag.
void FastProjection::prepare(const Vectors& start, double h, double answer) {
  std::fill(multipliers_.begin(), multipliers_.end(), 0.0);
  if (compliant_ || answer != 1.0) std::fill(scale_.begin(), scale_.end(), 1.0 / answer);
  if (!compliant_) return;
  const SystemLinks& links = system_.links;
  link_vectors(links, start, start_vector_);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const double gamma = links.compliance[i] * links.damping[i] / h;
    scale_[i] = 1.0 / ((1.0 + gamma) * answer);
    diagonal_[i] = links.compliance[i] / (h * h) * scale_[i];
  }
}

// r of the links between masses that have moved, but for what compliance adds, and their unit directions.
void FastProjection::measure(const Vectors& position, Extent moved) {
  if (measured_.empty()) misfit_ = {};
  measured_.grow(blocks_.links_among(moved), [&](Extent more) {
    misfit_.add(
        measure_stretches(system_.links, position, inverse_length_, direction_, distance_, residual_, more));
  });
}

// Makes r whole; returns the largest |r|/l.
double FastProjection::look_at_misfit(const Vectors& position, double h, StepReport& report) {
  const SystemLinks& links = system_.links;
  Misfit misfit = misfit_;
  if (!misfit.directed && misfit.finite) {
    const auto lost = std::find(distance_.begin(), distance_.end(), 0.0) - distance_.begin();
    report.status = StepStatus::direction_lost;
    report.worst_link = links.link[static_cast<std::size_t>(lost)];
    return misfit.worst;
  }
  if (compliant_) {
    add_compliance(position, h);
    const auto strains = all_of(residual_).abs() * all_of(inverse_length_);
    misfit.worst = strains.maxCoeff<Eigen::PropagateNaN>();
    misfit.finite = std::isfinite(misfit.worst);
  }
  if (!misfit.finite) {
    report.status = StepStatus::not_finite;
    report.worst_link = worst_link(infinity);
  }
  return misfit.worst;
}

// The first link whose |r|/l is so large, or not a number.
Index FastProjection::worst_link(double size) const {
  for (std::size_t i = 0; i < residual_.size(); ++i)
    if (!(std::abs(residual_[i]) * inverse_length_[i] < size)) return system_.links.link[i];
  return no_link;
}

// The part of r that a link without compliance does not have.
void FastProjection::add_compliance(const Vectors& position, double h) {
  const SystemLinks& links = system_.links;
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (links.compliance[i] == 0.0) continue;
    const Vec3 vector = position.at(links.a[i]) - position.at(links.b[i]);
    const double rate = vector.dot(vector - start_vector_.at(i)) / (distance_[i] * h);
    residual_[i] += links.compliance[i] * (links.damping[i] * rate - multipliers_[i] / (h * h));
  }
}

}  // namespace taut
