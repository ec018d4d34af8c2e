#include "direct/active_limits.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace taut {

ActiveLimits::ActiveLimits(const Model& model)
    : limits_(model.limits), inverse_mass_(model.masses.inverse_mass), pushes_(model.limits.size()) {
  active_.reserve(model.limits.size());
  moved_.resize(model.masses.size());
}

void ActiveLimits::begin_step(double h) {
  h_ = h;
  share_.assign(limits_.size(), 1.0);
  std::fill(pushes_.begin(), pushes_.end(), Push{});
}

void ActiveLimits::begin_half_kicks(double h, const Vectors& start, Vectors& position) {
  begin_step(h);
  start_pushes_.assign(limits_.size(), Push{});
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    const double compliance = limits_[i].compliance;
    if (compliance == 0.0) continue;
    const Overshoot beyond = overshoot(limits_[i], limit_angle(limits_[i], start));
    const LimitAngle along = outward(i, beyond.sign, start);
    const double shortness = 1.0 + h * h * own_weight(i, along) / compliance;  // 1 + ω²h²
    const double at_start = 0.5 / (shortness * shortness);
    share_[i] = 0.5 * (1.0 - at_start);
    if (!(beyond.size > 0.0)) continue;
    start_pushes_[i] = {0.5 * at_start * h * h * beyond.size / compliance, beyond.sign};
    move(i, along, -start_pushes_[i].multiplier, position);
  }
}

void ActiveLimits::kick(const Vectors& position, double answer, Vectors& velocity) const {
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    if (limits_[i].compliance == 0.0) continue;
    for (const Push& push : {start_pushes_[i], pushes_[i]})
      if (push.multiplier > 0.0)
        move(i, outward(i, push.sign, position), -answer * push.multiplier / h_, velocity);
  }
}

// The gradient of the overshoot at one end of the range.
LimitAngle ActiveLimits::outward(std::size_t limit, double sign, const Vectors& position) const {
  LimitAngle angle = limit_gradients(limits_[limit], position);
  for (std::size_t k = 0; k < limits_[limit].count; ++k) angle.gradient[k] *= sign;
  return angle;
}

double ActiveLimits::look(const Vectors& position, const Vectors* start) {
  active_.clear();
  double worst = 0.0;
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    const Limit& limit = limits_[i];
    const double angle = limit_angle(limit, position);
    Overshoot beyond = overshoot(limit, angle);
    // What pushes at one end is first taken back there before the other end may push.
    if (beyond.sign != pushes_[i].sign && pushes_[i].multiplier > 0.0)
      beyond = {excess_at(limit, angle, pushes_[i].sign), pushes_[i].sign};
    pushes_[i].sign = beyond.sign;
    if (!(beyond.size > 0.0) && pushes_[i].multiplier == 0.0) continue;
    const double compliance = limit.compliance / (share_[i] * h_ * h_);
    const double wanted = beyond.size - compliance * pushes_[i].multiplier;
    worst = std::max(worst, std::abs(wanted));
    const double sign = pushes_[i].sign;
    const LimitAngle along = outward(i, sign, position);
    active_.push_back({i, along, start == nullptr ? along : outward(i, sign, *start), wanted, compliance});
  }
  return worst;
}

// Σ w|∇C|²: what a unit push at the limit's masses, alone, makes of its angle.
double ActiveLimits::own_weight(std::size_t limit, const LimitAngle& along) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < limits_[limit].count; ++k)
    sum += inverse_mass_[limits_[limit].masses[k]] * along.gradient[k].squaredNorm();
  return sum;
}

// G W G₀ᵀ of two limits: what they share.
double ActiveLimits::product(const Row& row, const Row& column) const {
  const Limit& a = limits_[row.limit];
  const Limit& b = limits_[column.limit];
  double sum = 0.0;
  for (std::size_t i = 0; i < a.count; ++i)
    for (std::size_t j = 0; j < b.count; ++j)
      if (a.masses[i] == b.masses[j])
        sum += inverse_mass_[a.masses[i]] * row.along.gradient[i].dot(column.column.gradient[j]);
  return sum;
}

double ActiveLimits::change(const Row& row, const Vectors& velocity) const {
  const Limit& limit = limits_[row.limit];
  double sum = 0.0;
  for (std::size_t k = 0; k < limit.count; ++k)
    sum += row.along.gradient[k].dot(velocity.at(limit.masses[k]));
  return sum;
}

void ActiveLimits::move(std::size_t limit, const LimitAngle& column, double strength, Vectors& target) const {
  const auto& masses = limits_[limit].masses;
  for (std::size_t k = 0; k < limits_[limit].count; ++k)
    target.add(masses[k], (strength * inverse_mass_[masses[k]]) * column.gradient[k]);
}

// What one limit's push moves: W G₀ᵀ.
void ActiveLimits::reach(const Row& column, Vectors& moved) const {
  for (auto* axis : {&moved.x, &moved.y, &moved.z}) axis->assign(inverse_mass_.size(), 0.0);
  move(column.limit, column.column, 1.0, moved);
}

// G W Cᵀ s: how a limit's angle changes when the links push with strengths s.
double ActiveLimits::felt(const Row& row, const SystemLinks& links, const Vectors& columns,
                          const std::vector<double>& strength) const {
  const Limit& limit = limits_[row.limit];
  double sum = 0.0;
  for (std::size_t i = 0; i < links.size(); ++i)
    for (std::size_t k = 0; k < limit.count; ++k) {
      const double along = strength[i] * row.along.gradient[k].dot(columns.at(i));
      if (limit.masses[k] == links.a[i]) sum += links.weight_a[i] * along;
      if (limit.masses[k] == links.b[i]) sum -= links.weight_b[i] * along;
    }
  return sum;
}

Eigen::VectorXd ActiveLimits::solve(const LinkSystem& system, const Vectors& rows, const Vectors& columns,
                                    std::vector<double>& links) {
  const SystemLinks& of = system.links;
  const std::size_t count = active_.size();
  answers_.resize(limits_.size());
  for (std::vector<double>& answer : answers_) answer.resize(of.size());
  system.matrix->solve(links);
  if (count == 0) return {};
  Eigen::MatrixXd small(count, count);
  Eigen::VectorXd wanted(count);
  for (std::size_t k = 0; k < count; ++k) {
    reach(active_[k], moved_);
    for (std::size_t i = 0; i < of.size(); ++i)
      answers_[k][i] = rows.at(i).dot(moved_.at(of.a[i]) - moved_.at(of.b[i]));
    system.matrix->solve(answers_[k]);
  }
  for (std::size_t j = 0; j < count; ++j) {
    const auto row = static_cast<Eigen::Index>(j);
    wanted[row] = active_[j].wanted - felt(active_[j], of, columns, links);
    for (std::size_t k = 0; k < count; ++k)
      small(row, static_cast<Eigen::Index>(k)) =
          product(active_[j], active_[k]) - felt(active_[j], of, columns, answers_[k]);
    small(row, row) += active_[j].compliance;
  }
  Eigen::VectorXd strength = small.completeOrthogonalDecomposition().solve(wanted);
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t i = 0; i < of.size(); ++i)
      links[i] -= answers_[k][i] * strength[static_cast<Eigen::Index>(k)];
  return strength;
}

void ActiveLimits::push(const LinkSystem& system, const Vectors& rows, const Vectors& columns, double answer,
                        std::vector<double>& links, Vectors& position) {
  for (Row& row : active_) {
    row.wanted /= answer;
    row.compliance /= answer;
  }
  const Eigen::VectorXd strength = solve(system, rows, columns, links);
  for (std::size_t j = 0; j < active_.size(); ++j) {
    double& multiplier = pushes_[active_[j].limit].multiplier;
    const double before = multiplier;
    multiplier = std::max(before + strength[static_cast<Eigen::Index>(j)], 0.0);
    move(active_[j].limit, active_[j].column, answer * (before - multiplier), position);
  }
}

void ActiveLimits::stop(const LinkSystem& system, const Vectors& directions, const Vectors& position,
                        std::vector<double>& links, Vectors& velocity) {
  active_.clear();
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    if (pushes_[i].multiplier == 0.0 || limits_[i].compliance > 0.0) continue;
    const LimitAngle along = outward(i, pushes_[i].sign, position);
    active_.push_back({i, along, along, 0.0, 0.0});
    active_.back().wanted = change(active_.back(), velocity);
  }
  given_ = links;
  for (;;) {
    const Eigen::VectorXd strength = solve(system, directions, directions, links);
    Eigen::Index pulling = 0;
    if (active_.empty() || !(strength.minCoeff(&pulling) < 0.0)) {
      for (std::size_t j = 0; j < active_.size(); ++j)
        move(active_[j].limit, active_[j].column, -strength[static_cast<Eigen::Index>(j)], velocity);
      return;
    }
    active_.erase(active_.begin() + pulling);
    links = given_;
  }
}

}  // namespace taut
