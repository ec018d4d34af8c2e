#include "model/orientation.h"

#include <cmath>

namespace taut {
namespace {

// Directions of a mass's links, at the start and now.
struct Turned {
  Vec3 before, now;
};

Vec3 sum_of(const std::vector<Turned>& directions, const Eigen::Quaterniond& turn, Eigen::Matrix3d& inertia) {
  Vec3 torque = Vec3::Zero();
  inertia.setZero();
  for (const Turned& each : directions) {
    const Vec3 guess = turn * each.before;
    torque += guess.cross(each.now);
    inertia += Eigen::Matrix3d::Identity() - guess * guess.transpose();
  }
  return torque;
}

// The shortest turn from one direction to another; of opposite ones, about any axis across them.
Eigen::Quaterniond shortest_turn(const Turned& directions) {
  const double cosine = directions.before.dot(directions.now);
  if (cosine < -1.0 + 1e-12) {
    const Vec3 axis = directions.before.unitOrthogonal();
    return {0.0, axis.x(), axis.y(), axis.z()};
  }
  const double twice = std::sqrt(2.0 * (1.0 + cosine));  // the cosine of half the angle, twice
  const Vec3 axis = directions.before.cross(directions.now) / twice;
  return {0.5 * twice, axis.x(), axis.y(), axis.z()};
}

// x of A x = b, for a symmetric A that is positive: Cholesky's A = L Lᵀ.
Vec3 solve(const Eigen::Matrix3d& a, const Vec3& b) {
  double l[3][3] = {};
  double x[3];
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column <= row; ++column) {
      double left = a(row, column);
      for (int k = 0; k < column; ++k) left -= l[row][k] * l[column][k];
      l[row][column] = row == column ? std::sqrt(left) : left / l[column][column];
    }
    double left = b[row];
    for (int k = 0; k < row; ++k) left -= l[row][k] * x[k];
    x[row] = left / l[row][row];
  }
  for (int row = 2; row >= 0; --row) {
    for (int k = row + 1; k < 3; ++k) x[row] -= l[k][row] * x[k];
    x[row] /= l[row][row];
  }
  return {x[0], x[1], x[2]};
}

// Starts from the mean of the links' shortest turns and lets what they still miss turn it on (Gauss and
// Newton's way to least squares). A little of the identity keeps turns that no link sees at none.
Eigen::Quaterniond mean_rotation(const std::vector<Turned>& directions) {
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (const Turned& each : directions) {
    const Eigen::Vector4d turn = shortest_turn(each).coeffs();
    sum += sum.dot(turn) < 0.0 ? Eigen::Vector4d(-turn) : turn;
  }
  if (!(sum.norm() > 1e-9)) return Eigen::Quaterniond::Identity();
  Eigen::Quaterniond turn(Eigen::Vector4d(sum.normalized()));
  constexpr int most_rounds = 30;
  for (int round = 0; round < most_rounds; ++round) {
    Eigen::Matrix3d inertia;
    const Vec3 torque = sum_of(directions, turn, inertia);
    inertia += 1e-9 * Eigen::Matrix3d::Identity();
    const Vec3 step = solve(inertia, torque);
    const double angle = step.norm();
    if (!(angle > 1e-12)) break;
    turn = (Eigen::Quaterniond(Eigen::AngleAxisd(angle, step / angle)) * turn).normalized();
  }
  return turn;
}

}  // namespace

std::vector<Eigen::Quaterniond> orientations(const Model& model, const State& start, const State& state) {
  std::vector<std::vector<Turned>> directions(model.masses.size());
  for (std::size_t link = 0; link < model.links.size(); ++link) {
    if (state.broken(link)) continue;
    const Index a = model.links.a[link], b = model.links.b[link];
    const Vec3 before = start.position.at(b) - start.position.at(a);
    const Vec3 now = state.position.at(b) - state.position.at(a);
    if (before.isZero(0.0) || now.isZero(0.0)) continue;
    directions[a].push_back({before.normalized(), now.normalized()});
    directions[b].push_back({-before.normalized(), -now.normalized()});
  }
  std::vector<Eigen::Quaterniond> turns;
  turns.reserve(directions.size());
  for (const auto& each : directions) turns.push_back(mean_rotation(each));
  return turns;
}

}  // namespace taut
