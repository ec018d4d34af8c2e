// Backward Euler for links in nets, and for bends. With x̃ the positions that a step would reach without
// links, M the masses times 1 + h·drag, and every quantity times h²:
//
//   F = M (x − x̃) + Σ λ n + Σ k (φ − φ₀) ∇φ = 0
//                    at each mass, the sums over its links and bends, n away from the link's other end
//   hard links:  r = |d| − l − α̃ λ + γ n·(d − d₀) = 0,    α̃ = α/h²,  γ = α c/h
//   soft links:  λ = h² [k (|d| − l) + c n·(d − d₀)/h]
//
// Newton's method on both, with the multipliers of the hard links as unknowns of their own:
//
//   [H   Jᵀ ] [Δx]     [F        ]       H = M + Σ soft (h² k + h c) n nᵀ + Σ max(0, λ)/|d| (I − n nᵀ)
//   [J  −D  ] [Δλ] = − [r/(1 + γ)]           + what is positive of the bends' stiffness (implicit_bends.cpp)
//                                        D = α̃/(1 + γ)
//
// The last part of H is the sideways stiffness of tension, without which a taut net never comes to rest under
// long steps; a pushed link's is negative and left out, which costs rounds and keeps H positive definite
// (Choi and Ko, Stable but Responsive Cloth, 2002). The system is solved by conjugate gradients on Δx with a
// constraint preconditioner (Gould, Hribar and Nocedal, On the Solution of Equality Constrained Quadratic
// Programming Problems Arising in Optimization, 2001): H is replaced by a diagonal B, which leaves
// (J B⁻¹ Jᵀ + D), one direct solve of the hard links. Every iterate keeps J Δx − D Δλ exact, so lengths
// converge as Newton's method does, and the curvature and the soft links, which only make H a little unlike
// B, cost a few iterations instead of rows.
//
// Bends are stiff far along chains (the stiffest turns of neighbours against each other are harder than the
// softest turn of a whole rod by the fourth power of how many links it has), so that they take too many
// iterations: with them the system is factorised as a whole (balance_matrix.h).

#include "direct/implicit_net.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/vector_operations.h"
#include "direct/newton_rounds.h"

namespace taut {
namespace {

// A link whose stiffness, times h², is above so many times the inertia of its masses is hard.
constexpr double hard_ratio = 300.0;
// How much closer each round's linear solve comes.
constexpr double linear_gain = 0.05;
constexpr int most_iterations = 200;
// Forces are in balance when what is left would move no mass by more than this share of the shortest link …
constexpr double balance = 1e-6;
// … nor by more than this share of what forces move masses by in the step. In short steps that is less, and
// the share falls with the step, so that the method converges.
constexpr double balance_of_forces = 1e-3;
constexpr double longest_short_step = 1.0 / 240.0;  // s
// Where a row of pushed links buckles within the step there is no balance close by, and the search for it
// does not settle. After so many rounds it is given up and only lengths are brought to their end, as in fast
// projection.
constexpr int rounds_to_balance = 8;
// Where the system is factorised as a whole, of a link's weight, what it gives way by if it is rigid: so
// little that a round brings lengths a hundred million times nearer, and enough for pivots not to be
// rounding.
constexpr double give_way = 1e-8;
// The share of a mass that the negative stiffness of its pushed links may take.
constexpr double most_push = 0.8;

double stiffness(const Model& model, Index link, double h) {
  return h * h * model.links.stiffness[link] + h * model.links.damping[link];
}

double dot(const Vectors& a, const Vectors& b) {
  return (all_of(a.x) * all_of(b.x) + all_of(a.y) * all_of(b.y) + all_of(a.z) * all_of(b.z)).sum();
}

// result = weights·a, mass by mass
void weigh(const std::vector<double>& weights, const Vectors& a, Vectors& result) {
  result.resize(a.size());
  for_each_axis([&weights](auto& to, const auto& from) { all_of(to) = all_of(weights) * all_of(from); },
                result, a);
}

}  // namespace

ImplicitNet::ImplicitNet(const Model& model, const std::vector<Index>& whole, std::vector<Bend> bends,
                         double h)
    : model_(model),
      bends_(std::move(bends)),
      inertia_(model.masses.size(), 0.0),
      mass_(model.masses.size(), 0.0) {
  std::vector<Index> hard, soft;
  for (const Index link : whole) {
    const double weight =
        model.masses.inverse_mass[model.links.a[link]] + model.masses.inverse_mass[model.links.b[link]];
    (stiffness(model, link, h) * weight > hard_ratio ? hard : soft).push_back(link);
  }
  for (std::size_t i = 0; i < mass_.size(); ++i)
    if (!model.masses.pinned(i)) {
      free_.push_back(static_cast<Index>(i));
      mass_[i] = model.masses.mass[i] * (1.0 + h * model.drag);
      inertia_[i] = mass_[i];
    }
  // A soft link's stiffness acts along one of three directions.
  for (const Index link : soft)
    for (const Index mass : {model.links.a[link], model.links.b[link]})
      if (!model.masses.pinned(mass)) inertia_[mass] += stiffness(model, link, h) / 3.0;
  inverse_inertia_.assign(inertia_.size(), 0.0);  // pins do not move
  for (const Index mass : free_) inverse_inertia_[mass] = 1.0 / inertia_[mass];
  Model heavier = model;
  heavier.masses.mass = inertia_;
  heavier.masses.inverse_mass = inverse_inertia_;
  preconditioner_ = make_link_system(heavier, hard);

  hard_ = hard.size();
  if (!bends_.empty()) whole_.emplace(model, hard_);
  std::vector<Index> ordered = preconditioner_.links.link;
  ordered.insert(ordered.end(), soft.begin(), soft.end());
  links_ = gather(model, ordered);
  for (const Index link : ordered) {
    inverse_length_.push_back(1.0 / model.links.length[link]);
  }
  for (auto* values : {&distance_, &pull_, &along_, &across_}) values->resize(ordered.size());
  for (auto* values : {&length_error_, &length_residual_, &diagonal_, &scale_}) values->resize(hard_);
}

bool ImplicitNet::solve(const Vectors& start, double h, Vectors& position, std::vector<double>& tension,
                        StepReport& report) {
  inertial_ = position;
  prepare(start, h, tension);
  const double shortest =
      links_.size() == 0 ? 1.0 : *std::min_element(links_.length.begin(), links_.length.end());
  double last_error = infinity;
  for (int round = 0; round < most_newton_rounds; ++round) {
    measure(position, h);
    const double error = worst_length_error(report);
    if (report.status != StepStatus::done) return false;
    const bool seek_balance = whole_ || round < rounds_to_balance;
    const double close_enough = std::min(
        balance * shortest, balance_of_forces * std::min(1.0, h / longest_short_step) * largest_move(h));
    const double closest = std::max(close_enough, 0.1 * tolerance_ * shortest);
    if (error <= tolerance_ && (!seek_balance || worst_imbalance() <= closest)) {
      for (std::size_t i = 0; i < links_.size(); ++i) tension[links_.link[i]] = pull_[i] / (h * h);
      return true;
    }
    if (round >= rounds_to_settle && error > settled_error) break;
    // The linear system of an earlier round will do while lengths still gain enough by it.
    if (round == 0 || error > 0.1 * last_error || whole_) {
      linearise(h);
      ++report.factorisations;
      if (!factor(position, h)) {
        report.status = StepStatus::factorisation_failed;
        return false;
      }
    }
    last_error = error;
    report.link_solves +=
        (whole_ ? solve_whole() : solve_linear(seek_balance)) * static_cast<std::int64_t>(links_.size());
    report.rounds += 1;
    add_scaled(position, 1.0, change_.mass, position);
    for (std::size_t i = 0; i < hard_; ++i) pull_[i] += change_.links[i];
  }
  report.status = StepStatus::not_converged;
  return false;
}

// What stays the same over the rounds, and the pulls of the last step as a first guess.
void ImplicitNet::prepare(const Vectors& start, double h, const std::vector<double>& tension) {
  tolerance_ = length_tolerance(links_, inertial_);
  link_vectors(links_, start, start_vector_);
  for (const Index mass : free_) mass_[mass] = model_.masses.mass[mass] * (1.0 + h * model_.drag);
  for (std::size_t i = 0; i < hard_; ++i) {
    pull_[i] = tension[links_.link[i]] * h * h;
    scale_[i] = 1.0 / (1.0 + links_.compliance[i] * links_.damping[i] / h);
    diagonal_[i] = links_.compliance[i] / (h * h) * scale_[i];
  }
}

// Directions, distances, pulls of soft links, and how far lengths and forces are off.
void ImplicitNet::measure(const Vectors& position, double h) {
  link_vectors(links_, position, direction_);
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Vec3 d = direction_.at(i);
    distance_[i] = d.norm();
    const Vec3 n = d / distance_[i];
    direction_.set(i, n);
    const double stretch = distance_[i] - links_.length[i];
    const double rate = links_.damping[i] > 0.0 ? n.dot(d - start_vector_.at(i)) / h : 0.0;
    if (i >= hard_)
      pull_[i] = h * h * (stretch / links_.compliance[i] + links_.damping[i] * rate);
    else
      length_error_[i] = stretch + links_.compliance[i] * (links_.damping[i] * rate - pull_[i] / (h * h));
  }
  imbalance_.resize(position.size());
  scaled_difference(1.0, position, inertial_, imbalance_);
  weigh(mass_, imbalance_, imbalance_);
  spread(direction_, 1.0, pull_, imbalance_);
  bends_.add_gradient(h, position, imbalance_);
}

// The largest |r|/l of a hard link.
double ImplicitNet::worst_length_error(StepReport& report) const {
  double worst = 0.0;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    if (distance_[i] == 0.0) {
      report.status = StepStatus::direction_lost;
      report.worst_link = links_.link[i];
      return worst;
    }
    const double error = i < hard_ ? std::abs(length_error_[i]) * inverse_length_[i] : 0.0 * distance_[i];
    if (!(error <= worst)) {
      worst = error;
      report.worst_link = links_.link[i];
    }
  }
  if (!std::isfinite(worst)) report.status = StepStatus::not_finite;
  return worst;
}

// The farthest that what is left of the forces would move a mass by itself (m).
double ImplicitNet::worst_imbalance() const {
  double worst = 0.0;
  for (const Index mass : free_)
    worst = std::max(worst, imbalance_.at(mass).squaredNorm() / (inertia_[mass] * inertia_[mass]));
  return std::sqrt(worst);
}

// The farthest that gravity, or a single link, moves a mass in the step by itself (m).
double ImplicitNet::largest_move(double h) const {
  double largest = h * h * model_.gravity.norm();
  for (std::size_t i = 0; i < links_.size(); ++i)
    for (const Index mass : {links_.a[i], links_.b[i]})
      if (inertia_[mass] > 0.0) largest = std::max(largest, std::abs(pull_[i]) / inertia_[mass]);
  return largest;
}

// Takes H and J at the present positions.
void ImplicitNet::linearise(double h) {
  axis_ = direction_;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    along_[i] = i < hard_ ? 0.0 : stiffness(model_, links_.link[i], h);
    across_[i] = pull_[i] / distance_[i];
  }
  limit_push();
}

// A pushed link's sideways stiffness is negative, and twice that is the most it takes from H at either mass:
// all of it at a mass must stay below the inertia, or H is no longer positive definite.
void ImplicitNet::limit_push() {
  push_.assign(mass_.size(), 0.0);
  for (std::size_t i = 0; i < links_.size(); ++i)
    if (across_[i] < 0.0)
      for (const Index mass : {links_.a[i], links_.b[i]}) push_[mass] -= 2.0 * across_[i];
  for (std::size_t mass = 0; mass < mass_.size(); ++mass)
    push_[mass] = mass_[mass] == 0.0 ? 1.0 : std::min(1.0, most_push * mass_[mass] / push_[mass]);
  for (std::size_t i = 0; i < links_.size(); ++i)
    if (across_[i] < 0.0) across_[i] *= std::min(push_[links_.a[i]], push_[links_.b[i]]);
}

// What the linear system is solved by: the whole of it where there are bends, else its preconditioner.
bool ImplicitNet::factor(const Vectors& position, double h) {
  if (whole_) return factor_whole(position, h);
  return hard_ == 0 || preconditioner_.matrix->factor(axis_, axis_, diagonal_);
}

bool ImplicitNet::factor_whole(const Vectors& position, double h) {
  using Eigen::Matrix3d;
  whole_->clear();
  for (const Index mass : free_) whole_->add(mass, mass, mass_[mass] * Matrix3d::Identity());
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Index a = links_.a[i], b = links_.b[i];
    const Vec3 n = axis_.at(i);
    const Matrix3d block = across_[i] * Matrix3d::Identity() + (along_[i] - across_[i]) * (n * n.transpose());
    whole_->add(a, a, block);
    whole_->add(b, b, block);
    whole_->add(a, b, -block);
    if (i < hard_)
      whole_->set_link(i, a, b, n, diagonal_[i] + give_way * (links_.weight_a[i] + links_.weight_b[i]));
  }
  bends_.add_stiffness(h, position, *whole_);
  return whole_->factor();
}

// −(F, r/(1 + γ)), and the change that it makes; returns that this was done once.
std::int64_t ImplicitNet::solve_whole() {
  change_.mass = imbalance_;
  for (auto* axis : {&change_.mass.x, &change_.mass.y, &change_.mass.z}) all_of(*axis) = -all_of(*axis);
  change_.links.resize(hard_);
  for (std::size_t i = 0; i < hard_; ++i) change_.links[i] = -length_error_[i] * scale_[i];
  whole_->solve(change_.mass, change_.links);
  return 1;
}

// Solves the linear system for the change of positions and multipliers; returns the iterations.
std::int64_t ImplicitNet::solve_linear(bool seek_balance) {
  // The right side is −(F, r/(1 + γ)).
  residual_ = imbalance_;
  for (auto* axis : {&residual_.x, &residual_.y, &residual_.z})
    for (double& value : *axis) value = seek_balance ? -value : 0.0;
  for (std::size_t i = 0; i < hard_; ++i) length_residual_[i] = -length_error_[i] * scale_[i];
  precondition(length_residual_, change_);
  multiply(change_, image_);
  add_scaled(residual_, -1.0, image_, residual_);
  std::fill(length_residual_.begin(), length_residual_.end(), 0.0);
  precondition(length_residual_, step_);
  search_ = step_;
  double gain = dot(residual_, step_.mass);
  std::int64_t iterations = 1;
  while (iterations < most_iterations && gain > linear_gain * linear_gain * inertia_square(change_.mass)) {
    multiply(search_, image_);
    const double curvature = dot(search_.mass, image_);
    if (!(curvature > 0.0)) break;
    const double length = gain / curvature;
    add_scaled(change_.mass, length, search_.mass, change_.mass);
    all_of(change_.links) += length * all_of(search_.links);
    add_scaled(residual_, -length, image_, residual_);
    precondition(length_residual_, step_);
    const double next = dot(residual_, step_.mass);
    const double keep = next / gain;
    gain = next;
    add_scaled(step_.mass, keep, search_.mass, search_.mass);
    all_of(search_.links) = all_of(step_.links) + keep * all_of(search_.links);
    ++iterations;
  }
  return iterations;
}

// (B, J; J, −D) answer = (residual_, lengths).
void ImplicitNet::precondition(const std::vector<double>& lengths, Pair& answer) {
  weigh(inverse_inertia_, residual_, answer.mass);
  answer.links = lengths;
  if (hard_ == 0) return;
  // (J B⁻¹ Jᵀ + D) Δλ = J B⁻¹ residual − lengths
  for (std::size_t i = 0; i < hard_; ++i) {
    const Vec3 between = answer.mass.at(links_.a[i]) - answer.mass.at(links_.b[i]);
    answer.links[i] = axis_.at(i).dot(between) - lengths[i];
  }
  preconditioner_.matrix->solve(answer.links);
  force_ = residual_;
  spread(axis_, -1.0, answer.links, force_);
  weigh(inverse_inertia_, force_, answer.mass);
}

// force = H Δx + Jᵀ Δλ
void ImplicitNet::multiply(const Pair& change, Vectors& force) const {
  weigh(mass_, change.mass, force);
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Index a = links_.a[i], b = links_.b[i];
    const Vec3 n = axis_.at(i), moved = change.mass.at(a) - change.mass.at(b);
    const double along = (along_[i] - across_[i]) * n.dot(moved) + (i < hard_ ? change.links[i] : 0.0);
    const Vec3 pull = across_[i] * moved + along * n;
    force.add(a, pull);
    force.add(b, -pull);
  }
}

// Adds each link's pull, times a factor, at both its ends, for as many links as there are pulls.
void ImplicitNet::spread(const Vectors& direction, double factor, const std::vector<double>& pull,
                         Vectors& force) const {
  for (std::size_t i = 0; i < pull.size(); ++i) {
    const Vec3 on_a = direction.at(i) * (factor * pull[i]);
    force.add(links_.a[i], on_a);
    force.add(links_.b[i], -on_a);
  }
}

double ImplicitNet::inertia_square(const Vectors& change) const {
  double sum = 0.0;
  for (const Index mass : free_) sum += inertia_[mass] * change.at(mass).squaredNorm();
  return sum;
}

}  // namespace taut
