#include "direct/active_limits.h"

#include <algorithm>
#include <cmath>

namespace taut {

ActiveLimits::ActiveLimits(const Model& model)
    : limits_(model.limits),
      border_(model),
      let_go_(model.limits.size(), false),
      pushes_(model.limits.size()) {
  active_.reserve(model.limits.size());
}

void ActiveLimits::links_changed(const State& state) {
  for (std::size_t i = 0; i < limits_.size(); ++i) let_go_[i] = let_go(limits_[i], state);
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
    if (compliance == 0.0 || let_go_[i]) continue;
    const Overshoot beyond = overshoot(limits_[i], limit_angle(limits_[i], start));
    const LimitAngle along = border_.outward(i, beyond.sign, start);
    const double shortness = 1.0 + h * h * border_.own_weight(i, along) / compliance;  // 1 + ω²h²
    const double at_start = 0.5 / (shortness * shortness);
    share_[i] = 0.5 * (1.0 - at_start);
    if (!(beyond.size > 0.0)) continue;
    start_pushes_[i] = {0.5 * at_start * h * h * beyond.size / compliance, beyond.sign};
    border_.move(i, along, -start_pushes_[i].multiplier, position);
  }
}

void ActiveLimits::kick(const Vectors& position, double answer, Vectors& velocity) const {
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    if (limits_[i].compliance == 0.0) continue;
    for (const Push& push : {start_pushes_[i], pushes_[i]})
      if (push.multiplier > 0.0)
        border_.move(i, border_.outward(i, push.sign, position), -answer * push.multiplier / h_, velocity);
  }
}

double ActiveLimits::look(const Vectors& position, const Vectors* start) {
  active_.clear();
  double worst = 0.0;
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    const Limit& limit = limits_[i];
    if (let_go_[i]) continue;
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
    const LimitAngle along = border_.outward(i, sign, position);
    active_.push_back(
        {i, along, start == nullptr ? along : border_.outward(i, sign, *start), wanted, compliance});
  }
  return worst;
}

void ActiveLimits::push(const LinkSystem& system, const Vectors& rows, const Vectors& columns, double answer,
                        std::vector<double>& links, Vectors& position) {
  for (LimitRow& row : active_) {
    row.wanted /= answer;
    row.compliance /= answer;
  }
  const Eigen::VectorXd strength = border_.solve(system, rows, columns, active_, links);
  for (std::size_t j = 0; j < active_.size(); ++j) {
    double& multiplier = pushes_[active_[j].limit].multiplier;
    const double before = multiplier;
    multiplier = std::max(before + strength[static_cast<Eigen::Index>(j)], 0.0);
    border_.move(active_[j].limit, active_[j].column, answer * (before - multiplier), position);
  }
}

void ActiveLimits::stop(const LinkSystem& system, const Vectors& directions, const Vectors& position,
                        std::vector<double>& links, Vectors& velocity) {
  active_.clear();
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    if (pushes_[i].multiplier == 0.0 || limits_[i].compliance > 0.0) continue;
    const LimitAngle along = border_.outward(i, pushes_[i].sign, position);
    active_.push_back({i, along, along, 0.0, 0.0});
    active_.back().wanted = border_.change(active_.back(), velocity);
  }
  given_ = links;
  for (;;) {
    const Eigen::VectorXd strength = border_.solve(system, directions, directions, active_, links);
    Eigen::Index pulling = 0;
    if (active_.empty() || !(strength.minCoeff(&pulling) < 0.0)) {
      for (std::size_t j = 0; j < active_.size(); ++j)
        border_.move(active_[j].limit, active_[j].column, -strength[static_cast<Eigen::Index>(j)], velocity);
      return;
    }
    active_.erase(active_.begin() + pulling);
    links = given_;
  }
}

void ActiveLimits::give_tensions(double scale, const Vectors& position, std::vector<double>& tension) const {
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    const Limit& limit = limits_[i];
    if (limit.kind != LimitKind::reach || let_go_[i]) continue;
    double torque = scale * pushes_[i].multiplier * pushes_[i].sign;
    if (limit.compliance > 0.0) {
      const Overshoot beyond = overshoot(limit, limit_angle(limit, position));
      torque = std::max(beyond.size, 0.0) * beyond.sign / limit.compliance;
    }
    tension[limit.link] = torque / limit.length;
  }
}

}  // namespace taut
