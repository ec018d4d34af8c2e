#include "direct/limit_border.h"

#include <Eigen/QR>
#include <cmath>

namespace taut {

LimitBorder::LimitBorder(const Model& model)
    : limits_(model.limits), inverse_mass_(model.masses.inverse_mass) {
  moved_.resize(model.masses.size());
}

LimitAngle LimitBorder::outward(std::size_t limit, double sign, const Vectors& position) const {
  LimitAngle angle = limit_gradients(limits_[limit], position);
  for (std::size_t k = 0; k < limits_[limit].count; ++k) angle.gradient[k] *= sign;
  return angle;
}

double LimitBorder::own_weight(std::size_t limit, const LimitAngle& along) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < limits_[limit].count; ++k)
    sum += inverse_mass_[limits_[limit].masses[k]] * along.gradient[k].squaredNorm();
  return sum;
}

// G W G₀ᵀ of two limits: what they share.
double LimitBorder::product(const LimitRow& row, const LimitRow& column) const {
  const Limit& a = limits_[row.limit];
  const Limit& b = limits_[column.limit];
  double sum = 0.0;
  for (std::size_t i = 0; i < a.count; ++i)
    for (std::size_t j = 0; j < b.count; ++j)
      if (a.masses[i] == b.masses[j])
        sum += inverse_mass_[a.masses[i]] * row.along.gradient[i].dot(column.column.gradient[j]);
  return sum;
}

double LimitBorder::change(const LimitRow& row, const Vectors& u) const {
  const Limit& limit = limits_[row.limit];
  double sum = 0.0;
  for (std::size_t k = 0; k < limit.count; ++k) sum += row.along.gradient[k].dot(u.at(limit.masses[k]));
  return sum;
}

void LimitBorder::move(std::size_t limit, const LimitAngle& column, double strength, Vectors& target) const {
  const auto& masses = limits_[limit].masses;
  for (std::size_t k = 0; k < limits_[limit].count; ++k)
    target.add(masses[k], (strength * inverse_mass_[masses[k]]) * column.gradient[k]);
}

// What one limit's push moves: W G₀ᵀ.
void LimitBorder::reach(const LimitRow& column, Vectors& moved) const {
  for (auto* axis : {&moved.x, &moved.y, &moved.z}) axis->assign(inverse_mass_.size(), 0.0);
  move(column.limit, column.column, 1.0, moved);
}

// G W Cᵀ s: how a limit's angle changes when the links push with strengths s.
double LimitBorder::felt(const LimitRow& row, const SystemLinks& links, const Vectors& columns,
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

Eigen::VectorXd LimitBorder::solve(const LinkSystem& system, const Vectors& rows, const Vectors& columns,
                                   const std::vector<LimitRow>& limits, std::vector<double>& links) {
  const SystemLinks& of = system.links;
  const std::size_t count = limits.size();
  answers_.resize(limits_.size());
  for (std::vector<double>& answer : answers_) answer.resize(of.size());
  system.matrix->solve(links);
  if (count == 0) return {};
  Eigen::MatrixXd small(count, count);
  Eigen::VectorXd wanted(count);
  for (std::size_t k = 0; k < count; ++k) {
    reach(limits[k], moved_);
    for (std::size_t i = 0; i < of.size(); ++i)
      answers_[k][i] = rows.at(i).dot(moved_.at(of.a[i]) - moved_.at(of.b[i]));
    system.matrix->solve(answers_[k]);
  }
  for (std::size_t j = 0; j < count; ++j) {
    const auto row = static_cast<Eigen::Index>(j);
    wanted[row] = limits[j].wanted - felt(limits[j], of, columns, links);
    for (std::size_t k = 0; k < count; ++k)
      small(row, static_cast<Eigen::Index>(k)) =
          product(limits[j], limits[k]) - felt(limits[j], of, columns, answers_[k]);
    small(row, row) += limits[j].compliance;
  }
  Eigen::VectorXd strength = small.completeOrthogonalDecomposition().solve(wanted);
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t i = 0; i < of.size(); ++i)
      links[i] -= answers_[k][i] * strength[static_cast<Eigen::Index>(k)];
  return strength;
}

}  // namespace taut
