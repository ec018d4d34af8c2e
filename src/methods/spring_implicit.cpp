// Backward Euler on springs (Baraff and Witkin, Large Steps in Cloth Simulation, 1998), solved to the end by
// Newton's method:
//
//   F(x₁) = (1 + h·drag) M (x₁ − x) − h M v − h² (M g + loads + f(x₁, (x₁ − x)/h)) = 0,     v₁ = (x₁ − x)/h
//   ((1 + h·drag) M + h² K + h D) Δx = −F,   K = Σ k [n nᵀ + max(0, 1 − l/|d|)(I − n nᵀ)],   D = Σ c n nᵀ
//
// A compressed spring's sideways stiffness is negative; leaving it out keeps the matrix positive definite and
// costs rounds, not accuracy, because F is exact (Choi and Ko, Stable but Responsive Cloth, 2002). Sparse
// LDLᵀ; the pattern is analysed again only when a link breaks. First order, with any step stable, and
// strongly damped.

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>

#include "direct/newton_rounds.h"
#include "direct/solve_memory.h"
#include "file_order_stepper.h"
#include "forces/forces.h"
#include "forces/springs.h"
#include "methods/method.h"
#include "parameters.h"

namespace taut {
namespace {

using Matrix3 = Eigen::Matrix3d;
constexpr int most_newton_rounds = 60;

class SpringImplicitStepper final : public SwappingStepper {
 public:
  explicit SpringImplicitStepper(const Model& model) : model_(model), unknown_(model.masses.size(), -1) {
    for (std::size_t i = 0; i < model.masses.size(); ++i)
      if (!model.masses.pinned(i)) {
        unknown_[i] = 3 * static_cast<Eigen::Index>(free_.size());
        free_.push_back(static_cast<Index>(i));
      }
  }

 private:
  void links_changed(const State& state) override {
    springs_ = gather_springs(model_, state, OneSided::taken);
    bends_ = whole_bends(model_, state);
    analysed_ = false;
  }

  StepReport make_step(State& state, double h, double end_time) override {
    copy_to_work(state);
    StepReport report;
    report.rounds = 0;
    // What the masses would do without springs is both the first guess and the constant part of F.
    kick(model_, end_time, h, state.velocity, free_velocity_ = state.velocity);
    blow(model_, state, state.position, state.velocity, end_time, h, free_velocity_);
    drift(h, state.position, free_velocity_, inertial_ = state.position);
    place_pins(model_, end_time, inertial_, free_velocity_);
    position_ = inertial_;
    if (!solve(state.position, h, report)) return report;

    difference_quotient(h, state.position, position_, velocity_ = free_velocity_);
    place_pins(model_, end_time, position_, velocity_);
    spring_tensions(springs_, position_, velocity_, spring_tension_);
    for (std::size_t i = 0; i < spring_tension_.size(); ++i)
      tension_[springs_.links.link[i]] = spring_tension_[i];
    take_over(state, end_time, report);
    return report;
  }

  // Newton's method until no mass moves by more than the tolerance on lengths.
  bool solve(const Vectors& start, double h, StepReport& report) {
    if (springs_.empty()) return true;
    double shortest = infinity;
    for (const double length : springs_.links.length) shortest = std::min(shortest, length);
    if (shortest == infinity) shortest = 1.0;
    const double tolerance = length_tolerance(springs_.links, position_) * shortest;
    for (int round = 0; round < most_newton_rounds; ++round) {
      assemble(start, h);
      if (!analysed_) solver_.analyzePattern(matrix_);
      analysed_ = true;
      solver_.factorize(matrix_);
      ++report.factorisations;
      ++report.rounds;
      report.link_solves += static_cast<std::int64_t>(springs_.links.size());
      if (solver_.info() != Eigen::Success) {
        report.status = StepStatus::factorisation_failed;
        return false;
      }
      const Eigen::VectorXd change = solver_.solve(right_side_);
      for (const Index mass : free_) position_.add(mass, change.segment<3>(unknown_[mass]));
      const double largest = change.lpNorm<Eigen::Infinity>();
      if (!std::isfinite(largest)) {
        report.status = StepStatus::not_finite;
        return false;
      }
      if (largest <= tolerance) return true;
    }
    report.status = StepStatus::not_converged;
    return false;
  }

  // Fills matrix_ (lower triangle) and right_side_ = −F at position_.
  void assemble(const Vectors& start, double h) {
    entries_.clear();
    right_side_.setZero(3 * static_cast<Eigen::Index>(free_.size()));
    const double drag_factor = 1.0 + h * model_.drag;
    for (const Index mass : free_) {
      const double inertia = drag_factor * model_.masses.mass[mass];
      right_side_.segment<3>(unknown_[mass]) = inertia * (inertial_.at(mass) - position_.at(mass));
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        entries_.emplace_back(unknown_[mass] + axis, unknown_[mass] + axis, inertia);
    }
    for (std::size_t i = 0; i < springs_.links.size(); ++i) add_spring(i, start, h);
    for (const Bend& bend : bends_) add_bend(bend, h);
    const auto size = right_side_.size();
    matrix_.resize(size, size);
    matrix_.setFromTriplets(entries_.begin(), entries_.end());
  }

  void add_spring(std::size_t i, const Vectors& start, double h) {
    const Index a = springs_.links.a[i], b = springs_.links.b[i];
    const Vec3 d = position_.at(a) - position_.at(b);
    const double distance = d.norm();
    // Without a direction to pull in, a block of zeros: the pattern must stay the one that was analysed.
    const Vec3 n = distance == 0.0 ? Vec3(Vec3::Zero()) : Vec3(d / distance);
    const double stretch = springs_.stretch(i, distance), c = springs_.links.damping[i];
    const bool slack = stretch == 0.0 && !springs_.free_range.empty();
    const double k = slack ? 0.0 : springs_.stiffness[i];
    const double nominal = springs_.free_range.empty() ? springs_.links.length[i] : distance - stretch;
    const Vec3 moved = d - (start.at(a) - start.at(b));
    const Vec3 pull = n * (k * stretch + c * n.dot(moved) / h);
    const Matrix3 along = n * n.transpose();
    const double sideways = slack ? 0.0 : std::max(0.0, 1.0 - nominal / distance);
    const Matrix3 block = (h * h * k) * (along + sideways * (Matrix3::Identity() - along)) + (h * c) * along;
    if (unknown_[a] >= 0) right_side_.segment<3>(unknown_[a]) -= h * h * pull;
    if (unknown_[b] >= 0) right_side_.segment<3>(unknown_[b]) += h * h * pull;
    add_block(unknown_[a], unknown_[a], block);
    add_block(unknown_[b], unknown_[b], block);
    add_block(std::max(unknown_[a], unknown_[b]), std::min(unknown_[a], unknown_[b]), -block);
  }

  // Of a bend's stiffness k ∇φ ∇φᵀ alone: what its own curvature would add can be negative.
  void add_bend(const Bend& bend, double h) {
    const BendAngle turn = bend_gradients(bend, position_);
    const double strength = h * h * bend.stiffness;
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Index row = unknown_[bend.masses[i]];
      if (row >= 0) right_side_.segment<3>(row) -= strength * (turn.angle - bend.rest) * turn.gradient[i];
      for (std::size_t j = 0; j < 3; ++j)
        if (unknown_[bend.masses[j]] <= row)
          add_block(row, unknown_[bend.masses[j]],
                    strength * turn.gradient[i] * turn.gradient[j].transpose());
    }
  }

  void add_block(Eigen::Index row, Eigen::Index column, const Matrix3& block) {
    if (row < 0 || column < 0) return;  // a pin
    for (Eigen::Index i = 0; i < 3; ++i)
      for (Eigen::Index j = 0; j < 3; ++j)
        if (row + i >= column + j) entries_.emplace_back(row + i, column + j, block(i, j));
  }

  const Model& model_;
  std::vector<Eigen::Index> unknown_;  // first of a mass's three unknowns; −1 for a pin
  std::vector<Index> free_;
  Springs springs_;
  std::vector<Bend> bends_;
  bool analysed_ = false;
  Vectors inertial_, free_velocity_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::SparseMatrix<double> matrix_;
  Eigen::VectorXd right_side_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
  std::vector<double> spring_tension_;
};

constexpr std::array spring_implicit_params{steps_per_second_param(240.0)};

std::unique_ptr<Stepper> make_spring_implicit(const Model& model, const Settings&, const Execution&) {
  return std::make_unique<SpringImplicitStepper>(model);
}

double spring_implicit_memory(const Model& model) {
  constexpr double bytes_of_link = 150.0;
  return bytes_of_masses_factor(model, bytes_of_link);
}

}  // namespace

Method spring_implicit_method() {
  Capabilities can;
  can.family = Family::implicit;
  can.takes_steps_back = true;
  can.keeps = {Keeping::kept, Keeping::lost_with_step, Keeping::lost_with_step};
  can.stiffness = true;
  can.rigid = false;
  can.one_sided = true;
  can.bending = true;
  can.break_stretch = true;
  can.break_tension = true;
  return {"spring-implicit",
          "backward Euler on springs, solved by Newton's method",
          "Baraff and Witkin, Large Steps in Cloth Simulation (1998)",
          spring_implicit_params,
          can,
          {15.0, 330.0, 0.0, 40.0},
          make_spring_implicit,
          nullptr,
          spring_implicit_memory};
}

}  // namespace taut
