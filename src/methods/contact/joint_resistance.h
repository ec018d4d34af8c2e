#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// Damping and friction of a model's joints, as impulses on velocities at the start of a step: for every
/// method that can have joints at all. They are pairs, and sum to no impulse and no angular impulse.
class JointResistance {
 public:
  explicit JointResistance(const Model& model) : model_(model) {}

  /// What joints do in a step of h seconds from this state, to velocities that are on their way; or a share
  /// of it, where the rest follows at the step's end.
  void act(const State& state, double h, double share, Vectors& velocity);

  /// Another share of the same, at the end of the step, for a method that kicks half there.
  void finish(double share, const Vectors& position, Vectors& velocity) const;

  /// To be called once the step has been made, with the positions at its start: what friction holds.
  void keep(const Vectors& start, State& state) const;

 private:
  // What a joint does in a step.
  struct Turn {
    JointAngles angles;
    std::array<LimitAngle, 2> along;
    Eigen::Vector2d slip;     // rad
    Eigen::Vector2d impulse;  // N m s
  };

  const Model& model_;
  std::vector<Turn> turns_;
};

}  // namespace taut
