#include "model/orientation.h"

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

// Starts from the mean of the links' shortest turns and lets what they still miss turn it on (Gauss and
// Newton's way to least squares). A little of the identity keeps turns that no link sees at none.
Eigen::Quaterniond mean_rotation(const std::vector<Turned>& directions) {
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (const Turned& each : directions) {
    const Eigen::Vector4d turn = Eigen::Quaterniond::FromTwoVectors(each.before, each.now).coeffs();
    sum += sum.dot(turn) < 0.0 ? Eigen::Vector4d(-turn) : turn;
  }
  if (!(sum.norm() > 1e-9)) return Eigen::Quaterniond::Identity();
  Eigen::Quaterniond turn(Eigen::Vector4d(sum.normalized()));
  constexpr int most_rounds = 30;
  for (int round = 0; round < most_rounds; ++round) {
    Eigen::Matrix3d inertia;
    const Vec3 torque = sum_of(directions, turn, inertia);
    inertia += 1e-9 * Eigen::Matrix3d::Identity();
    const Vec3 step = inertia.ldlt().solve(torque);
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
