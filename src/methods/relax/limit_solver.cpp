#include "relax/limit_solver.h"

#include <algorithm>

#include "relax/visit_order.h"

namespace taut {

LimitSolver::LimitSolver(const Model& model)
    : model_(model),
      limits_(model.limits),
      inverse_mass_(model.masses.inverse_mass),
      pushes_(model.limits.size()) {}

// One-sided links go colour by colour, as others do, and then angles in their own order.
void LimitSolver::links_changed(const State& state) {
  order_.clear();
  std::vector<Index> links;
  std::vector<std::size_t> limit_of_link(has_one_sided_links(model_) ? model_.links.size() : 0);
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    if (limits_[i].kind != LimitKind::reach || let_go(limits_[i], state)) continue;
    links.push_back(limits_[i].link);
    limit_of_link[limits_[i].link] = i;
  }
  if (!links.empty())
    for (const VisitOrder::Run& run : visit_order(model_, links, mass_order(model_, links)).runs)
      for (const Index link : run) order_.push_back(limit_of_link[link]);
  for (std::size_t i = 0; i < limits_.size(); ++i)
    if (limits_[i].kind != LimitKind::reach) order_.push_back(i);
}

void LimitSolver::begin_step() {
  std::fill(pushes_.begin(), pushes_.end(), Push{});
  pushed_ = false;
}

void LimitSolver::solve_along(const Vectors& start, Vectors& position, double h, double answer) {
  for (const std::size_t i : order_) solve_one(i, start, position, h, answer);
}

void LimitSolver::solve_one(std::size_t i, const Vectors& start, Vectors& position, double h, double answer) {
  const Limit& limit = limits_[i];
  Push& push = pushes_[i];
  const double now = limit_angle(limit, position);
  Overshoot beyond = overshoot(limit, now);
  // What pushes at one end is first taken back there before the other end may push.
  if (beyond.sign != push.sign && push.multiplier < 0.0)
    beyond = {excess_at(limit, now, push.sign), push.sign};
  push.sign = beyond.sign;
  if (beyond.size <= 0.0 && push.multiplier == 0.0) return;
  pushed_ = pushed_ || limit.kind != LimitKind::reach;
  const LimitAngle angle = limit_gradients(limit, position);
  const LimitAngle along = &start == &position ? angle : limit_gradients(limit, start);
  double weight = 0.0;
  for (std::size_t k = 0; k < limit.count; ++k)
    weight += answer * inverse_mass_[limit.masses[k]] * angle.gradient[k].dot(along.gradient[k]);
  if (!(weight > 0.0)) return;  // all its masses are pinned, or the direction is lost
  const double scaled = limit.compliance / (h * h);
  const double wanted = (-beyond.size - scaled * push.multiplier) / (weight + scaled);
  const double change = std::min(push.multiplier + wanted, 0.0) - push.multiplier;
  push.multiplier += change;
  for (std::size_t k = 0; k < limit.count; ++k) {
    const Index mass = limit.masses[k];
    position.add(mass, (answer * inverse_mass_[mass] * change * beyond.sign) * along.gradient[k]);
  }
}

void LimitSolver::give_tensions(double scale, std::vector<double>& tension) const {
  for (const std::size_t i : order_)
    if (limits_[i].kind == LimitKind::reach)
      tension[limits_[i].link] = scale * pushes_[i].multiplier * pushes_[i].sign / limits_[i].length;
}

void LimitSolver::keep_to_their_side(std::vector<double>& tension) const {
  for (const std::size_t i : order_) {
    const Limit& limit = limits_[i];
    if (limit.kind != LimitKind::reach) continue;
    double& pull = tension[limit.link];
    if (!has_stop(limit, 1.0)) pull = std::min(pull, 0.0);
    if (!has_stop(limit, -1.0)) pull = std::max(pull, 0.0);
  }
}

}  // namespace taut
