// Each joint in turn, with its angles' rates r = G v and G their gradients:
//
//   ρ = largest eigenvalue of G W Gᵀ                    how far a unit impulse changes the rates
//   s ← s, at most h τ' ρ/β, with τ' = h τ              how far friction has given way (rad)
//   z = −(r + β s/h)/ρ                                  the impulse that would stop it, and take s back
//   p = (h c ρ z + z min(1, τ'/|z|))/(1 + h c ρ)        N m s
//   v ← v + W Gᵀ p
//   s ← s + G Δx                                        at the end of the step
//
// where c is the damping and τ the friction. With |z| ≤ τ' the joint sticks. Beyond, p is what solves
//   p = −h c r' − τ' r'/|r'|,  r' = r + ρ p
// for the rates r' after it: the law of the joint, taken at the end, so that it can't turn a joint round. The
// links answer after that; what they undo shows in r and s of the next step, and at rest s is where p is what
// the links ask for. So a joint that sticks stays, and does not creep: the tangential spring of Cundall and
// Strack (A discrete numerical model for granular assemblies, 1979) with a stiffness that goes with the step.

#include "contact/joint_resistance.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "contact/friction.h"

namespace taut {
namespace {

constexpr double taken_back = 0.2;  // β, share of the slip a step

using Gradients = std::array<LimitAngle, 2>;

Gradients gradients(const JointAngles& angles, const Vectors& position) {
  Gradients along;
  for (std::size_t k = 0; k < angles.count; ++k) along[k] = limit_gradients(angles.angles[k], position);
  return along;
}

// G v, or G Δx; zero for an angle that the joint does not have.
template <class Value>
Eigen::Vector2d rates(const JointAngles& angles, const Gradients& along, const Value& value) {
  Eigen::Vector2d sums = Eigen::Vector2d::Zero();
  for (std::size_t k = 0; k < angles.count; ++k) {
    const Limit& limit = angles.angles[k];
    for (std::size_t i = 0; i < limit.count; ++i)
      sums[static_cast<Eigen::Index>(k)] += along[k].gradient[i].dot(value(limit.masses[i]));
  }
  return sums;
}

// The largest eigenvalue of G W Gᵀ. All of a joint's angles are those of the same masses.
double largest_answer(const JointAngles& angles, const Gradients& along,
                      const std::vector<double>& inverse_mass) {
  const Limit& limit = angles.angles[0];
  const auto product = [&](std::size_t j, std::size_t k) {
    double sum = 0.0;
    for (std::size_t i = 0; i < limit.count; ++i)
      sum += inverse_mass[limit.masses[i]] * along[j].gradient[i].dot(along[k].gradient[i]);
    return sum;
  };
  const double first = product(0, 0);
  if (angles.count == 1) return first;
  const double second = product(1, 1);
  return 0.5 * (first + second) + std::hypot(0.5 * (first - second), product(0, 1));
}

// v ← v + W Gᵀ p
void push(const JointAngles& angles, const Gradients& along, const std::vector<double>& inverse_mass,
          const Eigen::Vector2d& impulse, Vectors& velocity) {
  for (std::size_t k = 0; k < angles.count; ++k) {
    const Limit& limit = angles.angles[k];
    for (std::size_t i = 0; i < limit.count; ++i)
      velocity.add(limit.masses[i], (inverse_mass[limit.masses[i]] * impulse[static_cast<Eigen::Index>(k)]) *
                                        along[k].gradient[i]);
  }
}

}  // namespace

void JointResistance::act(const State& state, double h, double share, Vectors& velocity) {
  const std::vector<double>& inverse_mass = model_.masses.inverse_mass;
  turns_.clear();
  for (std::size_t i = 0; i < model_.joints.size(); ++i) {
    const Joint& joint = model_.joints[i];
    turns_.push_back(
        {joint_angles(joint, state.position), {}, Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()});
    Turn& turn = turns_.back();
    turn.along = gradients(turn.angles, state.position);
    const double answer = largest_answer(turn.angles, turn.along, inverse_mass);
    if (!(answer > 0.0)) continue;  // all its masses are pinned
    const double most = h * joint.friction;
    for (std::size_t k = 0; k < turn.angles.count; ++k)
      turn.slip[static_cast<Eigen::Index>(k)] =
          state.static_friction.joints[i].dot(turn.angles.directions[k]);
    turn.slip = no_longer_than(most * h * answer / taken_back, turn.slip);
    const Eigen::Vector2d rate =
        rates(turn.angles, turn.along, [&](Index mass) { return velocity.at(mass); });
    const Eigen::Vector2d stopping = -(rate + turn.slip * (taken_back / h)) / answer;
    const double damped = h * joint.damping * answer;
    turn.impulse = (damped * stopping + no_longer_than(most, stopping)) / (1.0 + damped);
    push(turn.angles, turn.along, inverse_mass, share * turn.impulse, velocity);
  }
}

void JointResistance::finish(double share, const Vectors& position, Vectors& velocity) const {
  for (const Turn& turn : turns_)
    push(turn.angles, gradients(turn.angles, position), model_.masses.inverse_mass, share * turn.impulse,
         velocity);
}

void JointResistance::keep(const Vectors& start, State& state) const {
  for (std::size_t i = 0; i < turns_.size(); ++i) {
    const Turn& turn = turns_[i];
    const Eigen::Vector2d slip = turn.slip + rates(turn.angles, turn.along, [&](Index mass) -> Vec3 {
                                   return state.position.at(mass) - start.at(mass);
                                 });
    state.static_friction.joints[i] =
        slip[0] * turn.angles.directions[0] + slip[1] * turn.angles.directions[1];
  }
}

}  // namespace taut
